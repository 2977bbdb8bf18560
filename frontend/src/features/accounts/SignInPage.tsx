import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link, useRouter, useSearch } from '@tanstack/react-router'
import { useState } from 'react'

import { useTitle } from '@/app/title'

import { sessionQuery, signUpQuery, useSignIn } from './api'
import { CodeField, useSecondFactorAsked } from './CodeField'
import { PasskeyButton } from './PasskeyButton'
import { ProviderButton } from './ProviderButton'
import { Field, Form, Submit } from '@/ui/Form'
import { Sheet } from '@/ui/Sheet'

/** An address of this site, whatever was written after `next=`. */
export const ownPath = (next: string | undefined): string =>
  next !== undefined && /^\/(?![/\\])/.test(next) ? next : '/'

export function SignInPage() {
  useTitle('Sign in')
  const { next } = useSearch({ from: '/guest/sign-in' })
  const client = useQueryClient()
  const router = useRouter()
  const signIn = useSignIn()
  const isCodeAsked = useSecondFactorAsked(signIn.error)
  const { data: session } = useQuery(sessionQuery)
  const { data: way } = useQuery(signUpQuery)
  const [email, setEmail] = useState('')
  return (
    <Sheet>
      <h1>Sign in</h1>
      {session?.demo && (
        <p className="mid">
          This is the demo. You need no account:{' '}
          <Link className="link" to="/" reloadDocument>
            continue as {session.person?.name}
          </Link>
          .
        </p>
      )}
      <Form
        initialValues={{ email: '', password: '', code: '' }}
        mutation={signIn}
        onSubmit={({ code, ...values }) =>
          signIn.mutate(
            { ...values, ...(isCodeAsked && { code }) },
            { onSuccess: () => void router.navigate({ href: ownPath(next) }) },
          )
        }
      >
        <Field name="email" label="Email" type="email" autoComplete="username" onValue={setEmail} />
        <Field name="password" label="Password" type="password" autoComplete="current-password" />
        {isCodeAsked && <CodeField />}
        <Submit
          beside={
            <Link className="link small mid" to="/forgotten-password">
              Forgot password?
            </Link>
          }
        >
          Sign in
        </Submit>
      </Form>
      <ProviderButton verb="Sign in" email={email} nextPath={ownPath(next)} />
      <PasskeyButton
        action="Sign in with a passkey"
        onSignedIn={() => {
          client.clear()
          void router.navigate({ href: ownPath(next) })
        }}
      />
      <p className="small mid" style={{ marginTop: 'var(--sl-5)' }}>
        {way?.open === false ? (
          'You need an invitation to join. '
        ) : (
          <>
            New game team?{' '}
            <Link className="link" to="/sign-up">
              Create an account
            </Link>
            .{' '}
          </>
        )}
        Sound designers join with the link in a studio’s email.
      </p>
    </Sheet>
  )
}
