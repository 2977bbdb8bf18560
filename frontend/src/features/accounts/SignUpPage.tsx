import { useQuery } from '@tanstack/react-query'
import { Link, useParams, useRouter } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { ProblemNote } from '@/ui/ProblemNote'

import { signUpLinkQuery, signUpQuery, useAskSignUp, useFinishSignUp, useSignUp } from './api'
import { Field, Form, refusalOf, sentence, Sheet } from '@/app/Form'
import { Skeleton } from '@/ui/Skeleton'

const toSignIn = (
  <Link className="link small mid" to="/sign-in">
    I already have an account
  </Link>
)

/** The fields of an account besides its address. */
function AccountFields({ email }: { email?: string }) {
  return (
    <>
      <Field name="studio_name" label="Studio name" autoComplete="organization" />
      <Field name="name" label="Your name" autoComplete="name" />
      <Field
        name="email"
        label="Email"
        type="email"
        autoComplete="username"
        defaultValue={email}
        readOnly={email !== undefined}
        hint={email === undefined ? undefined : 'Verified by the link in your email.'}
      />
      <Field
        name="password"
        label="Password"
        type="password"
        autoComplete="new-password"
        hint="At least 10 characters. Four unrelated words make a good password."
      />
    </>
  )
}

/** The page while it is asked how studios are created here. */
function Opening() {
  return (
    <Sheet>
      <h1>Create a studio</h1>
      <Skeleton />
    </Sheet>
  )
}

/** Open an account and a studio, in the way that this server takes. */
export function SignUpPage() {
  useTitle('Create a studio')
  const { data: way, error } = useQuery(signUpQuery)
  if (error) {
    return (
      <Sheet>
        <h1>Create a studio</h1>
        <ProblemNote detail={sentence(refusalOf(error)?.detail ?? 'Can’t reach Soundlist.')} />
      </Sheet>
    )
  }
  if (way === undefined) return <Opening />
  if (!way.open) {
    return (
      <Sheet>
        <h1>Create a studio</h1>
        <p className="mid">
          Sign-up is by invitation only. Ask a studio on this server for an invitation, or its administrator to allow
          sign-ups.
        </p>
        <p style={{ marginTop: 'var(--sl-4)' }}>{toSignIn}</p>
      </Sheet>
    )
  }
  return way.by_mail ? <AskByMail setupCode={way.setup_code} /> : <AtOnce setupCode={way.setup_code} />
}

/** The code that the first account of a server needs. */
const setupCodeField = (
  <Field
    name="setup_code"
    label="Set-up code"
    autoComplete="off"
    hint="This server has no account yet. The command soundlist serve prints the code when it starts: look in the server’s log."
  />
)

function AtOnce({ setupCode }: { setupCode: boolean }) {
  const router = useRouter()
  const signUp = useSignUp()
  return (
    <Sheet>
      <h1>Create a studio</h1>
      <p className="mid">You become its producer: you create projects and invite others.</p>
      <Form
        action="Create studio"
        busy={signUp.isPending}
        error={signUp.error}
        onSubmit={(value) =>
          signUp.mutate(
            {
              studio_name: value('studio_name'),
              name: value('name'),
              email: value('email'),
              password: value('password'),
              ...(setupCode && { setup_code: value('setup_code') }),
            },
            { onSuccess: () => void router.navigate({ href: '/' }) },
          )
        }
        other={toSignIn}
      >
        {setupCode && setupCodeField}
        <AccountFields />
      </Form>
    </Sheet>
  )
}

function AskByMail({ setupCode }: { setupCode: boolean }) {
  const asking = useAskSignUp()
  if (asking.isSuccess) {
    return (
      <Sheet>
        <h1>Check your inbox</h1>
        <p className="mid">
          We have sent an email to {asking.variables.email} with a link to continue. The link works once, within a day.
          If nothing arrives in a few minutes, check your spam folder.
        </p>
        <p className="small mid" style={{ marginTop: 'var(--sl-4)' }}>
          <button type="button" className="link" onClick={() => asking.reset()}>
            Use another email, or send it again
          </button>
        </p>
        <p style={{ marginTop: 'var(--sl-4)' }}>{toSignIn}</p>
      </Sheet>
    )
  }
  return (
    <Sheet>
      <h1>Create a studio</h1>
      <p className="mid">You become its producer. We’ll email you a link to continue.</p>
      <Form
        action="Email me a link"
        busy={asking.isPending}
        error={asking.error}
        onSubmit={(value) =>
          asking.mutate({ email: value('email'), ...(setupCode && { setup_code: value('setup_code') }) })
        }
        other={toSignIn}
      >
        {setupCode && setupCodeField}
        <Field name="email" label="Email" type="email" autoComplete="username" />
      </Form>
    </Sheet>
  )
}

/** The page of the mailed link that opens an account. */
export function FinishSignUpPage() {
  useTitle('Create a studio')
  const { secret } = useParams({ from: '/guest/sign-up/$secret' })
  const router = useRouter()
  const { data: begun, error } = useQuery(signUpLinkQuery(secret))
  const finish = useFinishSignUp(secret)
  if (error) {
    const problem = refusalOf(error)
    return (
      <Sheet>
        <h1>Create a studio</h1>
        <ProblemNote
          detail={sentence(problem?.detail ?? 'The link could not be checked.')}
          fix={sentence(problem?.fix || 'sign up again for a new link')}
        />
        <p style={{ marginTop: 'var(--sl-4)' }}>
          <Link className="link" to="/sign-up">
            Sign up again
          </Link>
        </p>
      </Sheet>
    )
  }
  if (begun === undefined) return <Opening />
  return (
    <Sheet>
      <h1>Create a studio</h1>
      <p className="mid">You become its producer: you create projects and invite others.</p>
      <Form
        action="Create studio"
        busy={finish.isPending}
        error={finish.error}
        onSubmit={(value) =>
          finish.mutate(
            { studio_name: value('studio_name'), name: value('name'), password: value('password') },
            { onSuccess: () => void router.navigate({ href: '/' }) },
          )
        }
      >
        <AccountFields email={begun.email} />
      </Form>
    </Sheet>
  )
}
