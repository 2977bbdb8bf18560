import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { type StudioCalendar, useSaveStudioCalendar, useStudioCalendar } from './api'
import { CardProblem } from './CardProblem'
import classes from './Studio.module.css'
import { TimeZoneSelect } from './TimeZoneSelect'

/** When the studio works: its contracts' clauses on silence count days by it. */
export function CalendarCard({ studioId }: { studioId: string }) {
  const { data: calendar, error } = useStudioCalendar(studioId)
  const save = useSaveStudioCalendar(studioId)
  return (
    <Card aria-labelledby="calendar">
      <CardHead id="calendar" title="Calendar" note="for clauses on silence" />
      <CardProblem error={error ?? save.error} />
      {calendar && (
        <Fields studioId={studioId} calendar={calendar} isPending={save.isPending} onSave={(to) => save.mutate(to)} />
      )}
      <p className="small mid p-3-inset">
        Saturdays and Sundays never count. A holiday entered now does not delay a cue that is in review already.
        Designers see this calendar.
      </p>
    </Card>
  )
}

interface FieldsProps {
  studioId: string
  calendar: StudioCalendar
  isPending: boolean
  onSave: (calendar: StudioCalendar) => void
}

function Fields({ studioId, calendar: { time_zone: zone, holidays }, isPending, onSave }: FieldsProps) {
  const add = useSaveStudioCalendar(studioId)
  return (
    <>
      <div className="p-3-inset">
        <TimeZoneSelect zone={zone} onChoose={(chosen) => onSave({ time_zone: chosen, holidays })} />
      </div>
      {holidays.length > 0 && (
        <Rows aria-label="Holidays">
          {holidays.map((holiday) => (
            <Row key={holiday.day}>
              <span className="grow">
                <span className="strong">{holiday.name}</span> <span className="mid">{day(holiday.day)}</span>
              </span>
              <Button
                variant="quiet"
                icon="cross"
                aria-label={`Remove ${holiday.name}, ${day(holiday.day)}`}
                disabled={isPending}
                onClick={() =>
                  onSave({ time_zone: zone, holidays: holidays.filter((other) => other.day !== holiday.day) })
                }
              />
            </Row>
          ))}
        </Rows>
      )}
      <Form
        className={`flex wrap items-end gap-2 ${classes.holiday}`}
        initialValues={{ day: '', name: '' }}
        mutation={add}
        resets
        onSubmit={(holiday) => add.mutate({ time_zone: zone, holidays: [...holidays, holiday] })}
      >
        <Field name="day" label="Holiday" type="date" />
        <Field name="name" label="Name" />
        <Submit variant="plain" icon="plus">
          Add holiday
        </Submit>
      </Form>
    </>
  )
}
