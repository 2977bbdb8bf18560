import { NumberInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { plural, shortDay } from '@/ui/format'
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
  const [typed, setTyped] = useState<number | null>(null)
  const asked = useDebounced(JSON.stringify({ beginOn, dueOn, typed }))
  const now = JSON.parse(asked) as { beginOn: string; dueOn: string; typed: number | null }
  const { data: effort, error } = useQuery(
    effortQuery(projectId, {
      posting_id: postingId,
      contract_id: contractId,
      begin_on: now.beginOn || undefined,
      due_on: now.dueOn || undefined,
      weekly_hours: now.typed ?? undefined,
    }),
  )
  if (!effort) return error ? <p className="small mid">Hours could not be counted.</p> : <Skeleton rows={1} />
  if (effort.cues === 0) return null
  return (
    <div className={`small ${classes.effort}`} role="group" aria-label="Effort">
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
          onChange={(value) => setTyped(typeof value === 'number' && value >= 1 && value <= 168 ? value : null)}
        />
        <ul aria-label="Hours by category">
          {effort.lines.map((line) => (
            <li key={`${line.category} ${line.basis} ${line.based_on}`}>
              {`${line.category || 'No category'}: ${plural(line.cues, 'cue')}, ${plural(line.files, 'file')}, ${hoursRange(line)}, by ${basisWords(line)}`}
            </li>
          ))}
        </ul>
        <p className="mid">
          Usual figures are ours: hours for the first file of a category, a tenth to a fifth of them for each further
          variation, and as much again for each minute beyond the first half. Days go from Monday to Friday, without
          those that the roster has as booked.
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
        <p className="mid">{`${plural(concepts, 'cue is', 'cues are')} a concept still: hours may change.`}</p>
      )}
    </>
  )
}
