import { useQuery } from '@tanstack/react-query'

import { useTitle } from '@/app/title'

import { sessionQuery } from './api'
import { DeskTokensCard } from './DeskTokensCard'
import { MailCard } from './MailCard'

/** Which emails the person gets, and when. */
export function NotificationsPage() {
  useTitle('Notifications')
  return (
    <div className="page page-narrow stack">
      <h1>Notifications</h1>
      <MailCard />
    </div>
  )
}

/** The person's own tokens, with which `soundlist desk` signs in. */
export function DeskTokensPage() {
  useTitle('Tokens')
  const { data: session } = useQuery(sessionQuery)
  return (
    <div className="page page-narrow stack">
      <h1>Tokens</h1>
      {session?.demo === true && <p className="mid">Demo accounts have no tokens.</p>}
      {session?.demo === false && <DeskTokensCard />}
    </div>
  )
}
