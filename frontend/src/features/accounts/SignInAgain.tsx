import { useQueryClient } from '@tanstack/react-query'
import { useRouter } from '@tanstack/react-router'
import { useEffect, useState } from 'react'

import { onSessionEnd } from '@/api'
import type { Me } from '@/api/me'
import { LazyDialog } from '@/app/LazyDialog'

const loadDialog = () => import('./SignInAgainDialog').then(({ SignInAgainDialog }) => SignInAgainDialog)

/** Opens where the session has ended: the same person signs in without leaving the page. */
export function SignInAgain({ me }: { me: Me }) {
  const client = useQueryClient()
  const router = useRouter()
  const [answer, setAnswer] = useState<((again: boolean) => void) | null>(null)
  useEffect(() => onSessionEnd(() => new Promise((resolve) => setAnswer(() => resolve))), [])
  const goOn = (personId: string) => {
    if (personId !== me.person.id) {
      globalThis.location.reload() // nothing of one person is shown to another
      return
    }
    answer?.(true)
    setAnswer(null)
  }
  const leave = () => {
    const next = router.state.location.href
    answer?.(false)
    setAnswer(null)
    client.clear()
    void router.navigate({ to: '/sign-in', search: { next } })
  }
  return <LazyDialog load={loadDialog} opened={answer !== null} onClose={leave} given={{ me, onSignedIn: goOn }} />
}
