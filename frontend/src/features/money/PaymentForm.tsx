import type { UseMutationResult } from '@tanstack/react-query'

import { DraftForm } from '@/app/drafts/DraftForm'
import type { Invoice, PaymentAdd } from '@/money/api'
import { amount, minorOf, money } from '@/money/words'
import { Field, Submit } from '@/ui/Form'
import { today } from '@/ui/format'
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
  return (
    <DraftForm
      className={`grid gap-3 ${classes.form}`}
      aria-label={name}
      draftKey={`payment:${name}`}
      initialValues={{ amount: amount(mostMinor, currency), reference: '', paid_on: today() }}
      mutation={record}
      checks={({ amount: typed }) => ({
        amount: !minorOf(typed, currency) && `Enter an amount in ${currency}, such as 180.00.`,
      })}
      onSubmit={({ amount: typed, reference, paid_on }, onSent) =>
        record.mutate(
          { amount_minor: minorOf(typed, currency) ?? 0, reference: reference.trim(), paid_on },
          {
            onSuccess: () => {
              onSent()
              onDone()
            },
          },
        )
      }
    >
      {({ amount: typed }) => {
        const minor = minorOf(typed, currency)
        const isPart = minor !== null && minor !== 0 && Math.abs(minor) < Math.abs(mostMinor)
        return (
          <>
            <Field
              ref={first}
              name="amount"
              label={`Amount, ${currency}`}
              description={
                isPart
                  ? `Partial: ${money(mostMinor - minor, currency)} remains.`
                  : `The full ${money(mostMinor, currency)}.`
              }
              inputMode="decimal"
            />
            <Field name="reference" label="Reference" description="As on the bank statement." maxLength={200} />
            <Field name="paid_on" label={day} description="Today or earlier." type="date" />
            {note !== undefined && <p className={`small mid ${classes.wide}`}>{note}</p>}
            <Submit className="row wrap justify-end col-span-full" onCancel={onDone}>
              {verb}
            </Submit>
          </>
        )
      }}
    </DraftForm>
  )
}
