import { NativeSelect, TextInput } from '@mantine/core'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import type { ListedCue } from '@/money/api'
import { ClosedGateNote } from '@/phases'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { plural } from '@/ui/format'

import classes from './Plan.module.css'
import { NO_CUE, type TypedCue, type TypedPlan } from './plan'

interface PlannedCuesProps {
  cues: readonly ListedCue[]
  typed: TypedPlan
  currency: string
  projectId: string
  onChange: (ids: readonly string[], changes: Partial<TypedCue>) => void
}

const OUTSIDE = { value: '', label: 'Not included' }

/** Which cue is in which milestone, its price and how long it is thought to take. */
export function PlannedCues({ cues, typed, currency, projectId, onChange }: PlannedCuesProps) {
  const [filter, setFilter] = useState('')
  const words = filter.trim().toLowerCase()
  const shown = cues.filter(({ label, name, category }) => `${label} ${name} ${category}`.toLowerCase().includes(words))
  const choices = [
    OUTSIDE,
    ...typed.milestones
      .filter(({ isDeposit }) => !isDeposit)
      .map(({ key, name }, place) => ({ value: key, label: name.trim() || `Milestone ${place + 1}` })),
  ]
  const keys = new Set(choices.map(({ value }) => value))
  const coveredCues = cues.filter(({ id }) => keys.has(typed.cues[id]?.milestone ?? '') && typed.cues[id]?.milestone)
  const covered = coveredCues.length
  if (cues.length === 0) {
    return (
      <EmptyState
        head="The sound list is empty."
        action={
          <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId }} search={{}}>
            Go to the sound list
          </Link>
        }
      >
        Milestones pay for cues. Add cues to the sound list first.
      </EmptyState>
    )
  }
  return (
    <Card aria-labelledby="cues">
      <CardHead id="cues" title="Cues" end={`${covered} of ${plural(cues.length, 'cue')} in this contract`} />
      <ClosedGateNote projectId={projectId} cueIds={coveredCues.map(({ id }) => id)} />
      <div className={`grid gap-3 border-b p-3-inset ${classes.bulk}`}>
        <TextInput
          label="Show"
          placeholder="name, ID or category"
          value={filter}
          onChange={({ currentTarget: { value } }) => setFilter(value)}
        />
        <NativeSelect
          size="xs"
          label={`Assign these ${plural(shown.length, 'cue')} to`}
          data={[{ value: 'choose', label: 'Choose milestone' }, ...choices]}
          value="choose"
          onChange={({ currentTarget: { value } }) => {
            if (value !== 'choose') {
              onChange(
                shown.map(({ id }) => id),
                { milestone: value },
              )
            }
          }}
        />
      </div>
      {shown.length === 0 && <p className="mid p-3-inset">{`No cue matches “${filter}”.`}</p>}
      <ul>
        {shown.map((cue) => {
          const typedCue = typed.cues[cue.id] ?? NO_CUE
          const isIn = keys.has(typedCue.milestone) && typedCue.milestone !== ''
          return (
            <li key={cue.id} className={`grid items-center border-b ${classes.cue}`}>
              <span className={isIn ? 'cut-text' : 'cut-text mid'}>
                <span className="mono dim">{cue.label}</span> {cue.name}
                <span className="small dim"> {cue.category}</span>
              </span>
              <NativeSelect
                size="xs"
                aria-label={`Milestone of ${cue.name}`}
                data={choices}
                value={isIn ? typedCue.milestone : ''}
                onChange={({ currentTarget: { value } }) => onChange([cue.id], { milestone: value })}
              />
              <TextInput
                aria-label={`Price of ${cue.name}, ${currency}`}
                placeholder="price"
                inputMode="decimal"
                value={typedCue.price}
                disabled={!isIn}
                onChange={({ currentTarget: { value } }) => onChange([cue.id], { price: value })}
              />
              <TextInput
                aria-label={`Hours estimated for ${cue.name}`}
                placeholder="hours"
                inputMode="decimal"
                value={typedCue.hours}
                disabled={!isIn}
                onChange={({ currentTarget: { value } }) => onChange([cue.id], { hours: value })}
              />
            </li>
          )
        })}
      </ul>
    </Card>
  )
}
