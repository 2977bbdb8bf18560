import { NativeSelect, NumberInput, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { keptCuesQuery } from '@/api/soundList'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
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
  const [cueId, setCueId] = useState('')
  const [minutes, setMinutes] = useState<number | string>('')
  const [workedOn, setWorkedOn] = useState(today())
  const [note, setNote] = useState('')
  const [isLacking, setLacking] = useState(false)
  const send = (event: FormEvent) => {
    event.preventDefault()
    const lacks = typeof minutes !== 'number' || minutes < 1 || workedOn === ''
    setLacking(lacks)
    if (lacks || log.isPending) return
    log.mutate(
      { cue_id: cueId || null, posting_id: postingId ?? null, minutes, worked_on: workedOn, note },
      {
        onSuccess: () => {
          setMinutes('')
          setNote('')
        },
      },
    )
  }
  return (
    <form className="row wrap items-end" onSubmit={send} noValidate aria-label="Log time without a contract">
      {cues.length > 0 && (
        <NativeSelect
          label="Cue"
          data={[
            { value: '', label: 'None' },
            ...cues.map(({ id, label, name }) => ({ value: id, label: `${label} ${name}` })),
          ]}
          value={cueId}
          onChange={({ currentTarget }) => setCueId(currentTarget.value)}
        />
      )}
      <NumberInput
        label="Minutes"
        min={1}
        max={24 * 60}
        allowDecimal={false}
        value={minutes}
        onChange={setMinutes}
        error={isLacking ? 'Enter minutes and a date.' : undefined}
      />
      <TextInput
        label="Worked on"
        type="date"
        value={workedOn}
        onChange={({ currentTarget }) => setWorkedOn(currentTarget.value)}
      />
      <TextInput
        label="What it was"
        className="grow"
        value={note}
        maxLength={2000}
        onChange={({ currentTarget }) => setNote(currentTarget.value)}
      />
      <Button type="submit" aria-busy={log.isPending}>
        Log time
      </Button>
      <Refusal error={log.error} />
    </form>
  )
}
