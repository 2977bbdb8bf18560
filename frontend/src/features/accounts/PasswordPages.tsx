import { useQuery } from '@tanstack/react-query'
import { Link, useParams, useRouter } from '@tanstack/react-router'

import { useTitle } from '@/app/title'

import { signUpQuery, useAskReset, useNewPassword } from './api'
import { Field, Form, Submit } from '@/ui/Form'
import { Sheet } from '@/ui/Sheet'

/** Ask for a mail with a link; the answer never says whether the address is known. */
export function ForgottenPasswordPage() {
  useTitle('Forgot password?')
  const asking = useAskReset()
  const { data: way } = useQuery(signUpQuery)
  const sendsMail = way?.by_mail !== false
  if (asking.isSuccess) {
    return (
      <Sheet>
        <h1>{sendsMail ? 'Check your inbox' : 'Ask the administrator for your link'}</h1>
        <p className="mid">
          {sendsMail
            ? `If ${asking.variables} has an account, we have sent it a link to set a new password. `
            : `If ${asking.variables} has an account, a link to set a new password is ready. `}
          The link works once, within an hour.
        </p>
        <p className="small mid" style={{ marginTop: 'var(--sl-4)' }}>
          {sendsMail ? (
            <>
              No email?{' '}
              <button type="button" className="link" onClick={() => asking.reset()}>
                Send it again
              </button>
            </>
          ) : (
            <>
              This server sends no email. Its administrator can read the link with{' '}
              <code>soundlist mails {asking.variables}</code> and pass it to you.
            </>
          )}
        </p>
      </Sheet>
    )
  }
  return (
    <Sheet>
      <h1>Forgot password?</h1>
      <p className="mid">
        {sendsMail
          ? 'We’ll email you a link to set a new one.'
          : 'This server sends no email: its administrator passes you the link to set a new one.'}
      </p>
      <Form initialValues={{ email: '' }} mutation={asking} onSubmit={({ email }) => asking.mutate(email)}>
        <Field name="email" label="Email" type="email" autoComplete="username" />
        <Submit
          beside={
            <Link className="link small mid" to="/sign-in">
              Back to sign in
            </Link>
          }
        >
          {sendsMail ? 'Email me a link' : 'Create a link'}
        </Submit>
      </Form>
    </Sheet>
  )
}

export function NewPasswordPage() {
  useTitle('New password')
  const { secret } = useParams({ from: '/guest/new-password/$secret' })
  const router = useRouter()
  const setting = useNewPassword(secret)
  return (
    <Sheet>
      <h1>New password</h1>
      <p className="mid">You will be signed out everywhere else.</p>
      <Form
        initialValues={{ password: '' }}
        mutation={setting}
        onSubmit={({ password }) => setting.mutate(password, { onSuccess: () => void router.navigate({ href: '/' }) })}
      >
        <Field
          name="password"
          label="New password"
          type="password"
          autoComplete="new-password"
          description="At least 10 characters."
        />
        <Submit
          beside={
            <Link className="link small mid" to="/forgotten-password">
              Request a new link
            </Link>
          }
        >
          Set password
        </Submit>
      </Form>
    </Sheet>
  )
}
