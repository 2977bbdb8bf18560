import { Link, useRouter, useSearch } from '@tanstack/react-router'
import { useEffect, useRef } from 'react'

import { Form, Submit } from '@/ui/Form'
import { Sheet } from '@/ui/Sheet'
import { useTitle } from '@/app/title'
import { ErrorBanner } from '@/ui/ErrorBanner'

import { CardProblem } from './CardProblem'
import { CodeField } from './CodeField'
import { useFinishProviderSignIn, useProviderSignInCode } from './providerApi'
import { ownPath } from './SignInPage'

/** The page that a sign-in provider sends the browser back to. */
export function ProviderSignInPage() {
  useTitle('Sign in')
  const { code, state, iss } = useSearch({ from: '/guest/sign-in/provider' })
  const router = useRouter()
  const { mutate, data, error } = useFinishProviderSignIn()
  const giveCode = useProviderSignInCode()
  const isSent = useRef(false)
  const goOn = (done: { next_path: string }) => void router.navigate({ href: ownPath(done.next_path), replace: true })
  useEffect(() => {
    if (isSent.current || code === undefined || state === undefined) return
    isSent.current = true // a code counts once
    mutate(
      { code, state, iss },
      {
        onSuccess: (done) => {
          if (!done.second_factor_needed) void router.navigate({ href: ownPath(done.next_path), replace: true })
        },
      },
    )
  }, [code, state, iss, mutate, router])
  const isRefused = code === undefined || state === undefined
  return (
    <Sheet>
      <h1>Sign in</h1>
      {isRefused && (
        <ErrorBanner
          detail="The provider did not sign you in."
          fix="Begin again, or ask whoever runs the provider of your studio."
        />
      )}
      <CardProblem error={error} />
      {!isRefused && error === null && data === undefined && (
        <p className="mid" role="status">
          Signing in…
        </p>
      )}
      {data?.second_factor_needed === true && (
        <Form
          initialValues={{ code: '' }}
          mutation={giveCode}
          onSubmit={({ code: secondFactor }) => giveCode.mutate(secondFactor, { onSuccess: goOn })}
        >
          <CodeField />
          <Submit>Sign in</Submit>
        </Form>
      )}
      {(isRefused || error !== null) && (
        <p style={{ marginTop: 'var(--sl-4)' }}>
          <Link className="link" to="/sign-in" search={{}}>
            Back to Sign in
          </Link>
        </p>
      )}
    </Sheet>
  )
}
