import { useState } from 'react'

import { put, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { minorOf, money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Field, Submit } from '@/ui/Form'

import classes from './Pace.module.css'

interface Budget {
  currency: string
  amount_minor: number | null
}

const useSetBudget = (projectId: string) =>
  useMutation({
    mutationFn: (body: Budget) => put('/v1/projects/{project_id}/budget', { project_id: projectId }, body),
    affects: [queryKeys.pace(projectId)],
  })

/** What the project may cost in one currency; for producers. */
export function BudgetForm({ projectId, currencies }: { projectId: string; currencies: readonly string[] }) {
  const [isOpen, setIsOpen] = useState(false)
  if (!isOpen) {
    return (
      <p className="col-span-full">
        <Button variant="quiet" onClick={() => setIsOpen(true)}>
          Set a budget
        </Button>
      </p>
    )
  }
  return <OpenForm projectId={projectId} currency={currencies[0] ?? 'USD'} onDone={() => setIsOpen(false)} />
}

function OpenForm({ projectId, currency, onDone }: { projectId: string; currency: string; onDone: () => void }) {
  const set = useSetBudget(projectId)
  return (
    <DraftForm
      className={`grid items-end gap-3 col-span-full ${classes.budget}`}
      aria-label="Budget"
      draftKey={`budget:${projectId}`}
      initialValues={{ currency, amount: '' }}
      mutation={set}
      checks={(typed) => ({
        currency: !/^[A-Z]{3}$/.test(codeOf(typed.currency)) && 'Three letters, such as USD or EUR.',
        amount:
          typed.amount.trim() !== '' &&
          !((minorOf(typed.amount, codeOf(typed.currency)) ?? 0) > 0) &&
          'An amount above zero, such as 12000.',
      })}
      onSubmit={(typed, onSent) => {
        const code = codeOf(typed.currency)
        const minor = typed.amount.trim() === '' ? null : minorOf(typed.amount, code)
        set.mutate(
          { currency: code, amount_minor: minor },
          {
            onSuccess: () => {
              onSent()
              showToast(minor === null ? `No budget in ${code}.` : `The budget is ${money(minor, code)}.`)
              onDone()
            },
          },
        )
      }}
    >
      <Field name="currency" label="Currency" maxLength={3} />
      <Field optional name="amount" label="Budget" description="Empty removes it" inputMode="decimal" />
      <Submit>Save budget</Submit>
      <Button variant="quiet" onClick={onDone}>
        Close
      </Button>
    </DraftForm>
  )
}

const codeOf = (typed: string): string => typed.trim().toUpperCase()
