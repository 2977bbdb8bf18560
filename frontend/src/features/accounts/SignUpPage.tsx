import { Link, useRouter } from '@tanstack/react-router'

import { useTitle } from '@/app/title'

import { useSignUp } from './api'
import { Field, Form, Sheet } from './Form'

export function SignUpPage() {
  useTitle('Open a studio')
  const router = useRouter()
  const signUp = useSignUp()
  return (
    <Sheet>
      <h1>Open a studio</h1>
      <p className="mid">You become its producer: you open projects and invite the others.</p>
      <Form
        action="Open the studio"
        busy={signUp.isPending}
        error={signUp.error}
        onSubmit={(value) =>
          signUp.mutate(
            {
              studio_name: value('studio_name'),
              name: value('name'),
              email: value('email'),
              password: value('password'),
            },
            { onSuccess: () => void router.navigate({ href: '/' }) },
          )
        }
        other={
          <Link className="link small mid" to="/sign-in">
            I have an account
          </Link>
        }
      >
        <Field name="studio_name" label="Name of the studio" autoComplete="organization" />
        <Field name="name" label="Your name" autoComplete="name" />
        <Field name="email" label="Mail address" type="email" autoComplete="username" />
        <Field
          name="password"
          label="Password"
          type="password"
          autoComplete="new-password"
          hint="10 characters or more."
        />
      </Form>
    </Sheet>
  )
}
