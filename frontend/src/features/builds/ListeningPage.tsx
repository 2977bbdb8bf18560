import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ago, plural } from '@/ui/format'

import { listeningQuery, useStartPass } from './api'
import { ListeningRoom } from './ListeningRoom'

/** The listening pass: each cue of a build judged in the running game. */
export function ListeningPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const { data, error, isPending } = useQuery(listeningQuery(projectId))
  const { data: me } = useQuery(meQuery)
  const start = useStartPass(projectId)
  useTitle('Listening pass')
  const current = data?.listening_pass
  if (current && me) return <ListeningRoom key={current.id} listening={current} projectId={projectId} />
  const refused = error ?? start.error
  return (
    <div className="page stack" aria-busy={isPending}>
      <Refusal error={refused} />
      {data?.newest_audit && (
        <EmptyState
          head="Listening pass"
          level={1}
          action={
            <Button
              variant="primary"
              icon="headphones"
              aria-busy={start.isPending}
              onClick={() => start.mutate(undefined)}
            >
              {`Begin with build ${data.newest_audit.label}`}
            </Button>
          }
        >
          {`Play the game with this page beside it, and say of each sound what it is like: one key, then Enter. Build ${data.newest_audit.label} has ${plural(data.newest_audit.sounds, 'file')} and came ${ago(data.newest_audit.created_at)}.`}
        </EmptyState>
      )}
      {data && !data.newest_audit && (
        <EmptyState head="Nothing to hear yet" level={1}>
          The list of sounds comes with the first build that is audited. The commands for the game’s CI are on the page
          of{' '}
          <Link className="link" to="/projects/$projectId/drift" params={{ projectId }}>
            levels in the game
          </Link>
          .
        </EmptyState>
      )}
    </div>
  )
}
