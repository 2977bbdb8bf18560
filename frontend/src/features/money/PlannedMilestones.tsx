import { Checkbox, TextInput } from '@mantine/core'
import type { ReactNode } from 'react'

import { money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { FieldError } from '@/ui/FieldError'

import classes from './Plan.module.css'
import { type Fault, moved, type TypedMilestone } from './plan'

interface PlannedMilestonesProps {
  milestones: readonly TypedMilestone[]
  /** What each pays, as far as it can be read. */
  pays: readonly number[]
  faults: readonly Fault[]
  currency: string
  onChange: (milestones: TypedMilestone[]) => void
  onAdd: () => void
  /** What is shown while there are none. */
  begin: ReactNode
}

/** The milestones of a plan, in order; each with what is wrong about it. */
export function PlannedMilestones({
  milestones,
  pays,
  faults,
  currency,
  onChange,
  onAdd,
  begin,
}: PlannedMilestonesProps) {
  return (
    <Card aria-labelledby="milestones">
      <CardHead
        id="milestones"
        title="Milestones"
        count={milestones.length}
        end={
          <Button icon="plus" keys="n" onClick={onAdd}>
            Add milestone
          </Button>
        }
      />
      {milestones.length === 0 && begin}
      {milestones.map((milestone, place) => (
        <Milestone
          key={milestone.key}
          milestone={milestone}
          place={place}
          last={milestones.length - 1}
          paysMinor={pays[place] ?? 0}
          faults={faults.filter(({ where }) => where === `milestones.${place}`)}
          currency={currency}
          onChange={(changes) =>
            onChange(milestones.map((item) => (item.key === milestone.key ? { ...item, ...changes } : item)))
          }
          onMove={(by) => onChange(moved(milestones, place, by))}
          onRemove={() => onChange(milestones.filter(({ key }) => key !== milestone.key))}
        />
      ))}
    </Card>
  )
}

interface MilestoneProps {
  milestone: TypedMilestone
  place: number
  last: number
  paysMinor: number
  faults: readonly Fault[]
  currency: string
  onChange: (changes: Partial<TypedMilestone>) => void
  onMove: (by: 1 | -1) => void
  onRemove: () => void
}

function Milestone({
  milestone,
  place,
  last,
  paysMinor,
  faults,
  currency,
  onChange,
  onMove,
  onRemove,
}: MilestoneProps) {
  const called = milestone.name.trim() || `milestone ${place + 1}`
  return (
    <fieldset className={`grid items-start gap-2-3 m-0 p-3-inset ${classes.milestone}`}>
      <legend className="visually-hidden">{called}</legend>
      <TextInput
        label="Name"
        value={milestone.name}
        maxLength={200}
        onChange={({ currentTarget: { value } }) => onChange({ name: value })}
      />
      <TextInput
        label="Date"
        type="date"
        value={milestone.isDeposit ? '' : milestone.dueOn}
        disabled={milestone.isDeposit}
        onChange={({ currentTarget: { value } }) => onChange({ dueOn: value })}
      />
      <TextInput
        label={`Amount, ${currency}`}
        value={milestone.amount}
        inputMode="decimal"
        placeholder={milestone.isDeposit ? undefined : money(paysMinor, currency)}
        onChange={({ currentTarget: { value } }) => onChange({ amount: value })}
      />
      <TextInput
        label="Tax, %"
        value={milestone.tax}
        inputMode="decimal"
        placeholder="as in the contract"
        onChange={({ currentTarget: { value } }) => onChange({ tax: value })}
      />
      <div className="flex wrap items-center between gap-2-4 col-span-full">
        <Checkbox
          label="Deposit, due at signing"
          checked={milestone.isDeposit}
          onChange={({ currentTarget: { checked } }) => onChange({ isDeposit: checked })}
        />
        <span className="flex wrap gap-2">
          <Button variant="quiet" disabled={place === 0} onClick={() => onMove(-1)} aria-label={`Move ${called} up`}>
            Up
          </Button>
          <Button
            variant="quiet"
            disabled={place === last}
            onClick={() => onMove(1)}
            aria-label={`Move ${called} down`}
          >
            Down
          </Button>
          <Button variant="quiet" onClick={onRemove} aria-label={`Remove ${called}`}>
            Remove
          </Button>
        </span>
      </div>
      {faults.map(({ message }) => (
        <div key={message} className="col-span-full">
          <FieldError>{message}</FieldError>
        </div>
      ))}
    </fieldset>
  )
}
