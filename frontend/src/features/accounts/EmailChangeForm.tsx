import { useQuery } from '@tanstack/react-query'

import { Field, Form, Submit } from '@/ui/Form'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'

import { CardProblem } from './CardProblem'
import { emailChangeQuery, useAskEmailChange, useCancelEmailChange } from './emailChangeApi'

/** Asks for another email, or shows what the change that was asked for still waits for. */
export function EmailChangeForm({ email }: { email: string }) {
  const { data: pending, error } = useQuery(emailChangeQuery)
  const ask = useAskEmailChange()
  const cancel = useCancelEmailChange()
  if (error !== null) return <CardProblem error={error} />
  if (pending === undefined) return null
  if (pending === null) {
    return (
      <Form initialValues={{ email: '' }} mutation={ask} onSubmit={(values) => ask.mutate(values.email)}>
        <Field
          name="email"
          label="New email"
          type="email"
          autoComplete="email"
          description="We send a link to both emails. Nothing changes until you have followed both."
        />
        <Submit>Change email</Submit>
      </Form>
    )
  }
  const waiting = [...(pending.old_confirmed ? [] : [email]), ...(pending.new_confirmed ? [] : [pending.new_email])]
  return (
    <div className="grid gap-3 wrap-anywhere pt-3">
      <p role="status">
        <span className="strong">Change to {pending.new_email}</span>{' '}
        <span className="mid">Follow the link that was sent to {waiting.join(' and to ')}, within a day.</span>
      </p>
      <CardProblem error={cancel.error} />
      <div>
        <Button
          aria-busy={cancel.isPending}
          onClick={() => cancel.mutate(undefined, { onSuccess: () => showToast('Your email stays as it is.') })}
        >
          Stop the change
        </Button>
      </div>
    </div>
  )
}
