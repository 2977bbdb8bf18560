import { useQueryClient } from '@tanstack/react-query'
import { useRouter } from '@tanstack/react-router'
import { useEffect, useState } from 'react'

import { onSessionEnd, type SignInReason } from '@/api'
import type { Me } from '@/api/me'
import { LazyDialog } from '@/app/LazyDialog'

const loadDialog = () => import('./SignInAgainDialog').then(({ SignInAgainDialog }) => SignInAgainDialog)

/** Opens where the server asks for a sign-in: the same person signs in without leaving the page. */
export function SignInAgain({ me }: { me: Me }) {
  const client = useQueryClient()
  const router = useRouter()
  const [asked, setAsked] = useState<{ reason: SignInReason; answer: (again: boolean) => void } | null>(null)
  useEffect(() => onSessionEnd((reason) => new Promise((answer) => setAsked({ reason, answer }))), [])
  const goOn = (personId: string) => {
    if (personId !== me.person.id) {
      globalThis.location.reload() // nothing of one person is shown to another
      return
    }
    asked?.answer(true)
    setAsked(null)
  }
  const leave = () => {
    const next = router.state.location.href
    asked?.answer(false)
    setAsked(null)
    if (asked?.reason === 'recent') return // still signed in; only the act is not done
    client.clear()
    void router.navigate({ to: '/sign-in', search: { next } })
  }
  const given = { me, reason: asked?.reason ?? 'ended', onSignedIn: goOn }
  return <LazyDialog load={loadDialog} opened={asked !== null} onClose={leave} given={given} />
}
