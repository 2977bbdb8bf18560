import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { Sheet } from '@/ui/Sheet'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { sessionQuery } from './api'
import { CardProblem } from './CardProblem'
import { emailChangeLinkQuery, useConfirmEmailChange, useStopEmailChange } from './emailChangeApi'

/** The page of a mailed link that confirms or stops a change of email; a press, since mail filters open links. */
export function EmailChangePage() {
  useTitle('Change of email')
  const { secret } = useParams({ from: '/guest/change-email/$secret' })
  const { data: change, error } = useQuery(emailChangeLinkQuery(secret))
  const { data: session } = useQuery(sessionQuery)
  const confirm = useConfirmEmailChange(secret)
  const stop = useStopEmailChange(secret)
  if (confirm.isSuccess || stop.isSuccess) {
    const isDone = confirm.data?.email === change?.new_email
    return (
      <Sheet>
        <h1>{stop.isSuccess ? 'Change stopped' : isDone ? 'Email changed' : 'Confirmed'}</h1>
        <p className="mid" role="status">
          {stop.isSuccess
            ? 'The email of the account stays as it is. If someone else asked for the change, set a new password.'
            : isDone
              ? `The email of your account is ${change?.new_email} now.`
              : 'The email changes once you follow the link that was sent to the other email, too.'}
        </p>
        <p style={{ marginTop: 'var(--sl-4)' }}>
          <Link className="link" to={stop.isSuccess ? '/forgotten-password' : '/account'}>
            {stop.isSuccess ? 'Set a new password' : 'Continue'}
          </Link>
        </p>
      </Sheet>
    )
  }
  if (error !== null) {
    return (
      <Sheet>
        <h1>Change of email</h1>
        <Refusal error={error} />
      </Sheet>
    )
  }
  if (change === undefined || session === undefined) return <Sheet>{null}</Sheet>
  return (
    <Sheet>
      <h1>Change of email</h1>
      <p className="mid">
        {change.is_new_end
          ? `The holder of an account wants to use ${change.new_email} for it.`
          : `The email of your account is to become ${change.new_email}.`}{' '}
        Nothing changes until both emails have confirmed it.
      </p>
      <CardProblem error={confirm.error ?? stop.error} />
      <div className="row wrap" style={{ marginTop: 'var(--sl-4)' }}>
        {session.signed_in ? (
          <Button variant="primary" aria-busy={confirm.isPending} onClick={() => confirm.mutate()}>
            Confirm
          </Button>
        ) : (
          <Link className="link" to="/sign-in" search={{ next: `/change-email/${secret}` }}>
            Sign in to confirm
          </Link>
        )}
        <Button aria-busy={stop.isPending} onClick={() => stop.mutate()}>
          Stop the change
        </Button>
      </div>
    </Sheet>
  )
}
