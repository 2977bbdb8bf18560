import { NativeSelect } from '@mantine/core'
import { useRef, useState } from 'react'

import { base64Of } from '@/api/base64'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { FieldError } from '@/ui/FieldError'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, plural, shortDay } from '@/ui/format'

import forms from '../Hiring.module.css'
import { type Entry, useDropCalendar, useReadCalendar, useSetBusy } from './api'
import classes from './Roster.module.css'
import { LargeWeeks } from './Weeks'
import { busyInWords } from './words'

const LARGEST_BYTES = 2_000_000

interface TypedRange {
  from: string
  to: string
  kind: 'booked' | 'half_days'
  note: string
}
const NEW_RANGE: TypedRange = { from: '', to: '', kind: 'booked', note: '' }

const typedRanges = ({ busy }: Entry): TypedRange[] =>
  busy
    .filter(({ is_from_calendar: isFromCalendar }) => !isFromCalendar)
    .map(({ from_on, to_on, kind, note }) => ({ from: from_on, to: to_on, kind: kind ?? 'booked', note: note ?? '' }))

/** When a designer is busy: typed, and read from the calendar file that they sent. */
export function AvailabilityCard({ entry }: { entry: Entry }) {
  return (
    <Card aria-labelledby="availability">
      <CardHead id="availability" title="Availability" note="the next 12 weeks" />
      <div className={`grid gap-3 ${forms.body}`}>
        <LargeWeeks weeks={entry.weeks} firstOn={entry.first_week_on} />
        <BusyForm entry={entry} />
        <CalendarPart entry={entry} />
      </div>
    </Card>
  )
}

function BusyForm({ entry }: { entry: Entry }) {
  const save = useSetBusy(entry.id)
  const saved = { ranges: typedRanges(entry) }
  return (
    <DraftForm
      className="stack"
      aria-label="Busy days"
      draftKey={`roster-busy:${entry.id}`}
      initialValues={saved}
      mutation={save}
      onSubmit={({ ranges }, onSent) =>
        save.mutate(
          ranges.map(({ from, to, ...rest }) => ({ from_on: from, to_on: to, ...rest })),
          {
            onSuccess: () => {
              onSent()
              showToast('Dates saved.')
            },
          },
        )
      }
    >
      {({ ranges }, change) => (
        <>
          {ranges.map((_, at) => (
            <fieldset
              key={at}
              className={`grid items-end gap-3 ${classes.range}`}
              style={{ border: 0, padding: 0, margin: 0 }}
            >
              <legend className="visually-hidden">{`Busy range ${at + 1}`}</legend>
              <Field name={`ranges.${at}.from`} label="Busy from" type="date" />
              <Field name={`ranges.${at}.to`} label="to" type="date" />
              <Field
                as={NativeSelect}
                name={`ranges.${at}.kind`}
                label="How much"
                data={[
                  { value: 'booked', label: 'booked' },
                  { value: 'half_days', label: 'half days' },
                ]}
              />
              <Field optional name={`ranges.${at}.note`} label="Note" maxLength={200} />
              <Button
                square
                variant="quiet"
                icon="cross"
                aria-label={`Remove busy range ${at + 1}`}
                onClick={() => change({ ranges: ranges.filter((_, place) => place !== at) })}
              />
            </fieldset>
          ))}
          <div className="row wrap">
            <Button icon="plus" onClick={() => change({ ranges: [...ranges, NEW_RANGE] })}>
              Add busy days
            </Button>
            {JSON.stringify(ranges) !== JSON.stringify(saved.ranges) && <Submit>Save dates</Submit>}
          </div>
        </>
      )}
    </DraftForm>
  )
}

function CalendarPart({ entry }: { entry: Entry }) {
  const read = useReadCalendar(entry.id)
  const drop = useDropCalendar(entry.id)
  const [unread, setUnread] = useState<string | null>(null)
  const picker = useRef<HTMLInputElement>(null)
  const take = async (file: File | undefined) => {
    if (file === undefined) return
    setUnread(null)
    if (file.size > LARGEST_BYTES) {
      setUnread(`${file.name} has ${bytes(file.size)}; the limit is ${bytes(LARGEST_BYTES)}. Export one year only.`)
      return
    }
    try {
      read.mutate({ file_name: file.name, content_base64: await base64Of(file) })
    } catch {
      setUnread(`${file.name} could not be read from your disk. Choose it again.`)
    }
  }
  const imported = entry.busy.filter(({ is_from_calendar: isFromCalendar }) => isFromCalendar)
  return (
    <section className="stack" aria-label="Calendar file">
      {entry.calendar_name && entry.calendar_read_at && (
        <div>
          <p>
            {`${entry.calendar_name}, read ${ago(entry.calendar_read_at)}: ${plural(imported.length, 'busy range')}`}
            {entry.calendar_to_on && ` until ${shortDay(entry.calendar_to_on)}`}
          </p>
          <p className="small mid">
            {imported.slice(0, 6).map(busyInWords).join(' · ')}
            {imported.length > 6 && ` · and ${imported.length - 6} more`}
          </p>
        </div>
      )}
      <p className="small dim">Only days are kept from a calendar file, no titles of events.</p>
      {unread && <FieldError>{unread}</FieldError>}
      <Refusal error={read.error ?? drop.error} />
      <div className="row wrap">
        <Button icon="upload" aria-busy={read.isPending} onClick={() => picker.current?.click()}>
          {entry.calendar_name ? 'Read a newer calendar file' : 'Read a calendar file (.ics)'}
        </Button>
        {entry.calendar_name && (
          <Button variant="quiet" aria-busy={drop.isPending} onClick={() => drop.mutate(undefined)}>
            Remove its days
          </Button>
        )}
      </div>
      <input
        ref={picker}
        type="file"
        hidden
        aria-label="Calendar file"
        accept=".ics,text/calendar"
        onChange={(event) => {
          void take(event.currentTarget.files?.[0])
          event.currentTarget.value = ''
        }}
      />
    </section>
  )
}
