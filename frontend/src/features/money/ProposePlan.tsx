import { useMutation } from '@/api'
import { type PlanProposal, proposedPlan } from '@/money/api'
import { minorOf } from '@/money/words'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'

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
  const propose = useMutation({
    mutationFn: (minor: number | null) => proposedPlan(contractId, minor),
    onSuccess: onProposed,
  })
  return (
    <div className="p-3-inset">
      <EmptyState head="No milestones yet" level={3}>
        Propose them from the sound list: parts by due dates, two weeks apart or more, with a deposit of 20 % in the
        price.
      </EmptyState>
      <Form
        className={classes.propose}
        aria-label="Propose milestones"
        initialValues={{ total: '' }}
        mutation={propose}
        checks={({ total }) => ({
          total:
            total.trim() !== '' &&
            minorOf(total, currency) === null &&
            `“${total}” is not an amount in ${currency}. Write it like 6,000.00.`,
        })}
        onSubmit={({ total }) => propose.mutate(total.trim() === '' ? null : minorOf(total, currency))}
      >
        {!isByDay && <Field optional name="total" label={`Total price, ${currency} (optional)`} inputMode="decimal" />}
        <Submit variant="plain">Propose milestones</Submit>
      </Form>
      {propose.data?.milestones.length === 0 && (
        <p className="small mid" role="status">
          Every cue of the list is cut, or is under an agreed contract.
        </p>
      )}
    </div>
  )
}
