import { Link, useParams, useRouter } from '@tanstack/react-router'

import { useTitle } from '@/app/title'

import { useAskReset, useNewPassword } from './api'
import { Field, Form, Sheet } from './Form'

/** Ask for a mail with a link; the answer never says whether the address is known. */
export function ForgottenPasswordPage() {
  useTitle('Forgotten password')
  const asking = useAskReset()
  if (asking.isSuccess) {
    return (
      <Sheet>
        <h1>Look into your mail</h1>
        <p className="mid">
          If {asking.variables} has an account, a link to set a new password is on its way. It works for an hour, once.
        </p>
        <p className="small mid" style={{ marginTop: 'var(--sl-4)' }}>
          Nothing comes?{' '}
          <button type="button" className="link" onClick={() => asking.reset()}>
            Ask again
          </button>{' '}
          If this server has no mail server, whoever runs it can read the link with <code>soundlist mails</code>.
        </p>
      </Sheet>
    )
  }
  return (
    <Sheet>
      <h1>Forgotten password</h1>
      <p className="mid">A link to set a new one comes by mail.</p>
      <Form
        action="Mail me the link"
        busy={asking.isPending}
        error={asking.error}
        onSubmit={(value) => asking.mutate(value('email'))}
        other={
          <Link className="link small mid" to="/sign-in">
            Back to sign in
          </Link>
        }
      >
        <Field name="email" label="Mail address" type="email" autoComplete="username" />
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
      <p className="mid">It signs you in here and ends every other sign-in.</p>
      <Form
        action="Set the password"
        busy={setting.isPending}
        error={setting.error}
        onSubmit={(value) =>
          setting.mutate(value('password'), { onSuccess: () => void router.navigate({ href: '/' }) })
        }
        other={
          <Link className="link small mid" to="/forgotten-password">
            Ask for a new link
          </Link>
        }
      >
        <Field
          name="password"
          label="New password"
          type="password"
          autoComplete="new-password"
          hint="10 characters or more."
        />
      </Form>
    </Sheet>
  )
}
