import { TextInput } from '@mantine/core'
import { type FormEvent, useState } from 'react'

import { put, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { minorOf, money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

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
  const [typed, setTyped, draft] = useDraft(`budget:${projectId}`, { currency, amount: '' })
  const [problems, setProblems] = useState<{ currency?: string; amount?: string }>({})
  const change = (part: Partial<typeof typed>) => {
    setProblems({})
    setTyped((now) => ({ ...now, ...part }))
  }
  const save = (event: FormEvent) => {
    event.preventDefault()
    const code = typed.currency.trim().toUpperCase()
    if (!/^[A-Z]{3}$/.test(code)) return setProblems({ currency: 'Three letters, such as USD or EUR.' })
    const isEmpty = typed.amount.trim() === ''
    const minor = isEmpty ? null : minorOf(typed.amount, code)
    if (!isEmpty && (minor === null || minor <= 0))
      return setProblems({ amount: 'An amount above zero, such as 12000.' })
    set.mutate(
      { currency: code, amount_minor: minor },
      {
        onSuccess: () => {
          draft.discard()
          showToast(minor === null ? `No budget in ${code}.` : `The budget is ${money(minor, code)}.`)
          onDone()
        },
      },
    )
  }
  return (
    <form
      className={`grid items-end gap-3 col-span-full ${classes.budget}`}
      onSubmit={save}
      noValidate
      aria-label="Budget"
    >
      <TextInput
        label="Currency"
        maxLength={3}
        value={typed.currency}
        error={problems.currency}
        onChange={({ currentTarget: { value } }) => change({ currency: value })}
      />
      <TextInput
        label="Budget"
        description="Empty removes it"
        inputMode="decimal"
        value={typed.amount}
        error={problems.amount}
        onChange={({ currentTarget: { value } }) => change({ amount: value })}
      />
      <Button type="submit" variant="primary" aria-busy={set.isPending}>
        Save budget
      </Button>
      <Button variant="quiet" onClick={onDone}>
        Close
      </Button>
      <DraftNote draft={draft} />
      <Refusal inset error={set.error} />
    </form>
  )
}
