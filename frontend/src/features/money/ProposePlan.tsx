import { TextInput } from '@mantine/core'
import { type FormEvent, useState } from 'react'

import { useMutation } from '@/api'
import { type PlanProposal, proposedPlan } from '@/money/api'
import { minorOf } from '@/money/words'
import { Button } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'

import classes from './Plan.module.css'

interface ProposePlanProps {
  contractId: string
  currency: string
  /** By the day, milestones are dates only. */
  isByDay: boolean
  onProposed: (proposal: PlanProposal) => void
}

/** The whole plan in one act, from due dates and categories of the list; each milestone can be changed then. */
export function ProposePlan({ contractId, currency, isByDay, onProposed }: ProposePlanProps) {
  const [total, setTotal] = useState('')
  const propose = useMutation({
    mutationFn: (minor: number | null) => proposedPlan(contractId, minor),
    onSuccess: onProposed,
  })
  const minor = minorOf(total, currency)
  const fault =
    total.trim() !== '' && minor === null && `“${total}” is not an amount in ${currency}. Write it like 6,000.00.`
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (!propose.isPending && !fault) propose.mutate(total.trim() === '' ? null : minor)
  }
  return (
    <div className="p-3-inset">
      <EmptyState head="No milestones yet" level={3}>
        Propose them from the sound list: parts by due dates, two weeks apart or more, with a deposit of 20 % in the
        price.
      </EmptyState>
      <form className={classes.propose} onSubmit={send} noValidate aria-label="Propose milestones">
        {!isByDay && (
          <TextInput
            label={`Total price, ${currency} (optional)`}
            value={total}
            error={fault}
            inputMode="decimal"
            onChange={({ currentTarget: { value } }) => setTotal(value)}
          />
        )}
        <Button type="submit" aria-busy={propose.isPending}>
          Propose milestones
        </Button>
      </form>
      {propose.data?.milestones.length === 0 && (
        <p className="small mid" role="status">
          Every cue of the list is cut, or is under an agreed contract.
        </p>
      )}
      <Refusal error={propose.error} />
    </div>
  )
}
