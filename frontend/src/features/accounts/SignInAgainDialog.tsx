import { answered, api, useMutation } from '@/api'
import type { Me } from '@/api/me'
import { Dialog } from '@/app/Dialog'
import type { OpenedProps } from '@/app/LazyDialog'

import { Field, Form } from '@/app/Form'

interface SignInAgainDialogProps extends OpenedProps {
  me: Me
  onSignedIn: (personId: string) => void
}

export function SignInAgainDialog({ me, opened, onClose, onSignedIn }: SignInAgainDialogProps) {
  const signIn = useMutation({
    mutationFn: (body: { email: string; password: string }) => answered(api.POST('/v1/sign-in', { body })),
    onSuccess: ({ id }) => onSignedIn(id),
  })
  return (
    <Dialog title="Sign in to go on" opened={opened} onClose={onClose}>
      <p className="mid">Your session has ended. What you typed is kept.</p>
      <Form
        action="Sign in"
        busy={signIn.isPending}
        error={signIn.error}
        onSubmit={(value) => signIn.mutate({ email: value('email'), password: value('password') })}
      >
        <Field name="email" label="Email" type="email" autoComplete="username" defaultValue={me.email} />
        <Field name="password" label="Password" type="password" autoComplete="current-password" />
      </Form>
    </Dialog>
  )
}
