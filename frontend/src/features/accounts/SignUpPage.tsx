import { useQuery } from '@tanstack/react-query'
import { Link, useParams, useRouter } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { Refusal } from '@/ui/Refusal'

import { signUpLinkQuery, signUpQuery, useAskSignUp, useFinishSignUp, useSignUp } from './api'
import { Field, Form, Submit } from '@/ui/Form'
import { Sheet } from '@/ui/Sheet'
import { Skeleton } from '@/ui/Skeleton'

const toSignIn = (
  <Link className="link small mid" to="/sign-in">
    I already have an account
  </Link>
)

const NO_CARD = 'No card, no studio details. You can delete the account at any time.'

/** The fields of an account. */
function AccountFields({ isVerified = false }: { isVerified?: boolean }) {
  return (
    <>
      <Field name="name" label="Your name" autoComplete="name" />
      <Field
        name="email"
        label="Work email"
        type="email"
        autoComplete="username"
        readOnly={isVerified}
        description={isVerified ? 'Verified by the link in your email.' : undefined}
      />
      <Field
        name="password"
        label="Password"
        type="password"
        autoComplete="new-password"
        description="At least 10 characters. Four unrelated words make a good password."
      />
    </>
  )
}

/** The page while it is asked how studios are created here. */
function Opening() {
  return (
    <Sheet>
      <h1>Create your account</h1>
      <Skeleton />
    </Sheet>
  )
}

/** Open an account and a studio, in the way that this server takes. */
export function SignUpPage() {
  useTitle('Create your account')
  const { data: way, error } = useQuery(signUpQuery)
  if (error) {
    return (
      <Sheet>
        <h1>Create your account</h1>
        <Refusal error={error} />
      </Sheet>
    )
  }
  if (way === undefined) return <Opening />
  if (!way.open) {
    return (
      <Sheet>
        <h1>Create your account</h1>
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
    description="This server has no account yet. The command soundlist serve prints the code when it starts: look in the server’s log."
  />
)

function AtOnce({ setupCode }: { setupCode: boolean }) {
  const router = useRouter()
  const signUp = useSignUp()
  return (
    <Sheet>
      <h1>Create your account</h1>
      <Form
        initialValues={{ name: '', email: '', password: '', setup_code: '' }}
        mutation={signUp}
        onSubmit={({ setup_code, ...values }) =>
          signUp.mutate(
            { ...values, ...(setupCode && { setup_code }) },
            { onSuccess: () => void router.navigate({ to: '/projects/new' }) },
          )
        }
      >
        {setupCode && setupCodeField}
        <AccountFields />
        <Submit keys="Enter" beside={toSignIn}>
          Create account
        </Submit>
        <p className="small mid">{NO_CARD}</p>
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
      <h1>Create your account</h1>
      <p className="mid">We’ll email you a link to continue.</p>
      <Form
        initialValues={{ email: '', setup_code: '' }}
        mutation={asking}
        onSubmit={({ email, setup_code }) => asking.mutate({ email, ...(setupCode && { setup_code }) })}
      >
        {setupCode && setupCodeField}
        <Field name="email" label="Work email" type="email" autoComplete="username" />
        <Submit keys="Enter" beside={toSignIn}>
          Email me a link
        </Submit>
        <p className="small mid">{NO_CARD}</p>
      </Form>
    </Sheet>
  )
}

/** The page of the mailed link that opens an account. */
export function FinishSignUpPage() {
  useTitle('Create your account')
  const { secret } = useParams({ from: '/guest/sign-up/$secret' })
  const router = useRouter()
  const { data: begun, error } = useQuery(signUpLinkQuery(secret))
  const finish = useFinishSignUp(secret)
  if (error) {
    return (
      <Sheet>
        <h1>Create your account</h1>
        <Refusal error={error} />
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
      <h1>Create your account</h1>
      <Form
        initialValues={{ name: '', email: begun.email, password: '' }}
        mutation={finish}
        onSubmit={({ name, password }) =>
          finish.mutate({ name, password }, { onSuccess: () => void router.navigate({ to: '/projects/new' }) })
        }
      >
        <AccountFields isVerified />
        <Submit keys="Enter">Create account</Submit>
        <p className="small mid">{NO_CARD}</p>
      </Form>
    </Sheet>
  )
}
