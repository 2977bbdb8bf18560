import { NativeSelect, NumberInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { Button } from '@/ui/Button'
import { keptCuesQuery } from '@/api/soundList'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { plural, shortDay, today } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { Rows } from '@/ui/Rows'

import { ownTimeQuery, useDropOwnTime, useLogOwnTime } from './api'
import { hours } from './words'

interface OwnTimeCardProps {
  projectId: string
  /** Of the bid, where the posting is all that is seen of the project. */
  postingId?: string
}

/** Time without a contract: a bid, test work, an own project; its person alone sees it. */
export function OwnTimeCard({ projectId, postingId }: OwnTimeCardProps) {
  const { data } = useQuery(ownTimeQuery(projectId, postingId))
  const drop = useDropOwnTime()
  if (!data) return null
  const { times, categories } = data
  return (
    <Card aria-labelledby="own-time">
      <CardHead
        id="own-time"
        title="Your time without a contract"
        count={times.length > 0 ? times.length : undefined}
        end="visible to you only"
      />
      <div className="grid gap-3 p-3-inset">
        <LogForm projectId={projectId} postingId={postingId} />
        {categories.map(({ category, cues, low_min: low, high_min: high }) => (
          <p key={category} className="small mid">
            {category || 'No category'}: {low === high ? hours(low) : `${hours(low)} to ${hours(high)}`} a cue, of{' '}
            {plural(cues, 'approved cue')} of yours with this studio.
          </p>
        ))}
        <Refusal error={drop.error} />
      </div>
      <Rows>
        {times.map(({ id, cue, minutes, worked_on: workedOn, note }) => (
          <li key={id} className="row wrap p-3-inset">
            <span className="nowrap">{shortDay(workedOn)}</span>
            <span className="strong nowrap">{hours(minutes)}</span>
            <span className="mid grow">{[cue?.name, note].filter(Boolean).join(': ')}</span>
            <Button
              variant="quiet"
              disabled={drop.isPending}
              aria-label={`Remove ${hours(minutes)} on ${shortDay(workedOn)}`}
              onClick={() => drop.mutate(id)}
            >
              Remove
            </Button>
          </li>
        ))}
      </Rows>
    </Card>
  )
}

function LogForm({ projectId, postingId }: OwnTimeCardProps) {
  const { data: cues = [] } = useQuery({ ...keptCuesQuery(projectId), enabled: postingId === undefined })
  const log = useLogOwnTime(projectId)
  return (
    <Form
      className="row wrap items-end"
      aria-label="Log time without a contract"
      initialValues={{ cue_id: '', minutes: '', worked_on: today(), note: '' }}
      mutation={log}
      checks={({ minutes }) => ({ minutes: !(Number(minutes) >= 1) && 'Enter minutes.' })}
      resets={({ cue_id, worked_on }) => ({ cue_id, worked_on })}
      onSubmit={({ cue_id: cueId, minutes, ...rest }) =>
        log.mutate({ ...rest, cue_id: cueId || null, posting_id: postingId ?? null, minutes: Number(minutes) })
      }
    >
      {cues.length > 0 && (
        <Field
          as={NativeSelect}
          optional
          name="cue_id"
          label="Cue"
          data={[
            { value: '', label: 'None' },
            ...cues.map(({ id, label, name }) => ({ value: id, label: `${label} ${name}` })),
          ]}
        />
      )}
      <Field as={NumberInput} name="minutes" label="Minutes" min={1} max={24 * 60} allowDecimal={false} />
      <Field name="worked_on" label="Worked on" type="date" />
      <Field optional name="note" label="What it was" className="grow" maxLength={2000} />
      <Submit variant="plain">Log time</Submit>
    </Form>
  )
}
