import { TextInput } from '@mantine/core'
import type { UseMutationResult } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { useDraft } from '@/app/drafts'
import type { Invoice, PaymentAdd } from '@/money/api'
import { amount, minorOf, money } from '@/money/words'
import { Button } from '@/ui/Button'
import { today } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import classes from './Page.module.css'

interface PaymentFormProps {
  name: string
  verb: string
  /** The label of the day. */
  day: string
  note?: string
  /** The whole that may be written down; a part of it may, too. Below zero on a credit note. */
  mostMinor: number
  currency: string
  record: UseMutationResult<Invoice, Error, PaymentAdd>
  onDone: () => void
}

/** Money that changed hands, whole or in part, with the bank's reference. */
export function PaymentForm({ name, verb, day, note, mostMinor, currency, record, onDone }: PaymentFormProps) {
  const first = useFocusOnMount<HTMLInputElement>()
  const [typed, setTyped] = useState(amount(mostMinor, currency))
  const [reference, setReference, draft] = useDraft(`payment:${name}`, '')
  const [on, setOn] = useState(today())
  const [missing, setMissing] = useState<{ amount?: string; reference?: string; on?: string }>({})
  const minor = minorOf(typed, currency)
  const isPart = minor !== null && minor !== 0 && Math.abs(minor) < Math.abs(mostMinor)
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (record.isPending) return
    const lacks = {
      amount: minor === null || minor === 0 ? `Enter an amount in ${currency}, such as 180.00.` : undefined,
      reference: reference.trim() === '' ? 'Enter the bank reference.' : undefined,
      on: on === '' ? 'Enter a date.' : undefined,
    }
    setMissing(lacks)
    if (minor === null || lacks.amount || lacks.reference || lacks.on) return
    record.mutate(
      { amount_minor: minor, reference: reference.trim(), paid_on: on },
      {
        onSuccess: () => {
          draft.discard()
          onDone()
        },
      },
    )
  }
  return (
    <form className={`grid gap-3 ${classes.form}`} onSubmit={send} noValidate aria-label={name}>
      <TextInput
        ref={first}
        label={`Amount, ${currency}`}
        description={
          isPart ? `Partial: ${money(mostMinor - minor, currency)} remains.` : `The full ${money(mostMinor, currency)}.`
        }
        value={typed}
        onChange={(event) => setTyped(event.currentTarget.value)}
        error={missing.amount}
        inputMode="decimal"
      />
      <TextInput
        label="Reference"
        description="As on the bank statement."
        value={reference}
        maxLength={200}
        onChange={(event) => setReference(event.currentTarget.value)}
        error={missing.reference}
      />
      <TextInput
        label={day}
        description="Today or earlier."
        type="date"
        value={on}
        onChange={(event) => setOn(event.currentTarget.value)}
        error={missing.on}
      />
      {note !== undefined && <p className={`small mid ${classes.wide}`}>{note}</p>}
      <Refusal error={record.error} className={classes.wide} />
      <div className="row wrap justify-end col-span-full">
        <Button variant="quiet" onClick={onDone}>
          Cancel
        </Button>
        <Button type="submit" variant="primary" aria-busy={record.isPending}>
          {verb}
        </Button>
      </div>
    </form>
  )
}
