import { NumberInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { plural, shortDay } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { Skeleton } from '@/ui/Skeleton'
import { StatusBadge } from '@/ui/StatusBadge'
import { useDebounced } from '@/ui/useDebounced'

import { type Effort, effortQuery } from './api'
import classes from './Money.module.css'
import { basisWords, effortDays, effortWords, hoursRange } from './words'

interface EffortLineProps {
  projectId: string
  postingId?: string
  contractId?: string
  /** The days as they are typed; empty for none. */
  beginOn?: string
  dueOn?: string
}

/** How long the work takes by its rows, and whether the day that is asked for can be kept. */
export function EffortLine({ projectId, postingId, contractId, beginOn = '', dueOn = '' }: EffortLineProps) {
  const [typed, setTyped] = useState<number | string | null>(null)
  const hours = typeof typed === 'number' && typed >= 1 && typed <= 168 ? typed : null
  const asked = useDebounced(JSON.stringify({ beginOn, dueOn, hours }))
  const now = JSON.parse(asked) as { beginOn: string; dueOn: string; hours: number | null }
  const { data: effort, error } = useQuery(
    effortQuery(projectId, {
      posting_id: postingId,
      contract_id: contractId,
      begin_on: now.beginOn || undefined,
      due_on: now.dueOn || undefined,
      weekly_hours: now.hours ?? undefined,
    }),
  )
  if (!effort) return error ? <Refusal error={error} /> : <Skeleton rows={1} />
  if (effort.cues === 0) return null
  return (
    <div className={`small grid justify-items-start gap-1 ${classes.effort}`} role="group" aria-label="Effort">
      <p>
        {effortWords(effort)} {effortDays(effort)}
      </p>
      <Fits effort={effort} />
      <details>
        <summary>How it is counted</summary>
        <NumberInput
          label="Hours a week"
          description={
            effort.weekly_hours_from === 'roster'
              ? 'From the roster.'
              : effort.weekly_hours_from === 'assumed'
                ? 'Assumed: nobody has entered them.'
                : undefined
          }
          value={typed ?? effort.weekly_hours}
          min={1}
          max={168}
          onChange={setTyped}
        />
        <ul aria-label="Hours by category">
          {effort.lines.map((line) => (
            <li key={`${line.category} ${line.basis} ${line.based_on}`}>
              {`${line.category || 'No category'}: ${plural(line.cues, 'cue')}, ${plural(line.files, 'file')}, ${hoursRange(line)}, by ${basisWords(line)}`}
            </li>
          ))}
        </ul>
        <p className="mid">
          The usual figures are our estimates, not measurements; an estimate in the plan replaces them. They are hours
          for the first file of a category, plus 10–20 % for each further variation, plus the same again for each minute
          beyond the first 30 seconds, up to six times in all. Working days are Monday to Friday; days booked in the
          roster do not count, and half days count half.
        </p>
      </details>
    </div>
  )
}

function Fits({ effort: { fit, due_on: dueOn, concepts } }: { effort: Effort }) {
  return (
    <>
      {fit === 'impossible' && dueOn && (
        <p role="status">
          <StatusBadge kind="late">
            {`${shortDay(dueOn)} is too early for this work. Ask for fewer sounds, or set a later day.`}
          </StatusBadge>
        </p>
      )}
      {fit === 'tight' && dueOn && (
        <StatusBadge kind="warning">{`${shortDay(dueOn)} works only if all goes well.`}</StatusBadge>
      )}
      {fit === 'fits' && dueOn && <StatusBadge kind="passed">{`${shortDay(dueOn)} leaves enough time.`}</StatusBadge>}
      {concepts > 0 && (
        <p className="mid">{`${plural(concepts, 'cue is', 'cues are')} still a concept, so hours may change.`}</p>
      )}
    </>
  )
}
