import { post, type SignInReason, useMutation } from '@/api'
import type { Me } from '@/api/me'
import { Dialog } from '@/app/Dialog'
import type { OpenedProps } from '@/app/LazyDialog'

import { Field, Form, Submit } from '@/ui/Form'

import { PasskeyButton } from './PasskeyButton'
import { ProviderButton } from './ProviderButton'
import { CodeField, useSecondFactorAsked } from './CodeField'

interface SignInAgainDialogProps extends OpenedProps {
  me: Me
  reason: SignInReason
  onSignedIn: (personId: string) => void
}

export function SignInAgainDialog({ me, reason, opened, onClose, onSignedIn }: SignInAgainDialogProps) {
  const signIn = useMutation({
    mutationFn: (body: { email: string; password: string; code?: string }) => post('/v1/sign-in', {}, body),
    onSuccess: ({ id }) => onSignedIn(id),
  })
  const isCodeAsked = useSecondFactorAsked(signIn.error)
  const isRecent = reason === 'recent'
  return (
    <Dialog title={isRecent ? 'Confirm your password' : 'Sign in to go on'} opened={opened} onClose={onClose}>
      <p className="mid">
        {isRecent
          ? 'You signed in a while ago, and this needs a recent sign-in. What you typed is kept.'
          : 'Your session has ended. What you typed is kept.'}
      </p>
      <Form
        initialValues={{ email: me.email, password: '', code: '' }}
        mutation={signIn}
        onSubmit={({ code, ...values }) => signIn.mutate({ ...values, ...(isCodeAsked && { code }) })}
      >
        <Field name="email" label="Email" type="email" autoComplete="username" readOnly={isRecent} />
        <Field name="password" label="Password" type="password" autoComplete="current-password" />
        {isCodeAsked && <CodeField />}
        <Submit>{isRecent ? 'Confirm' : 'Sign in'}</Submit>
      </Form>
      <ProviderButton
        verb={isRecent ? 'Confirm' : 'Sign in'}
        email={me.email}
        nextPath={location.pathname + location.search}
      />
      <PasskeyButton action={isRecent ? 'Confirm with a passkey' : 'Sign in with a passkey'} onSignedIn={onSignedIn} />
    </Dialog>
  )
}
