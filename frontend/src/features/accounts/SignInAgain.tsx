import { useMutation, useQueryClient } from '@tanstack/react-query'
import { useRouter } from '@tanstack/react-router'
import { useEffect, useState } from 'react'

import { answered, api, onSessionEnd } from '@/api'
import type { Me } from '@/api/me'
import { Dialog } from '@/app/Dialog'

import { Field, Form } from './Form'

/** Opens where the session has ended: the same person signs in without leaving the page. */
export function SignInAgain({ me }: { me: Me }) {
  const client = useQueryClient()
  const router = useRouter()
  const [answer, setAnswer] = useState<((again: boolean) => void) | null>(null)
  useEffect(() => onSessionEnd(() => new Promise((resolve) => setAnswer(() => resolve))), [])
  const signIn = useMutation({
    mutationFn: (body: { email: string; password: string }) => answered(api.POST('/v1/sign-in', { body })),
    onSuccess: (person) => {
      if (person.id !== me.person.id) {
        globalThis.location.reload() // nothing of one person is shown to another
        return
      }
      answer?.(true)
      setAnswer(null)
    },
  })
  const leave = () => {
    const next = router.state.location.href
    answer?.(false)
    setAnswer(null)
    client.clear()
    void router.navigate({ to: '/sign-in', search: { next } })
  }
  return (
    <Dialog title="Sign in to go on" opened={answer !== null} onClose={leave}>
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
