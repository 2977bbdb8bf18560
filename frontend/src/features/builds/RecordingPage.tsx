import { useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useEffect } from 'react'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { boardQuery, type Reference, titleOf } from '@/references'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'

import { listeningQuery } from './api'
import { Recording } from './Recording'

/** A recording of the game, in which moments are marked and become notes of the listening pass. */
export function RecordingPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const { recording, at } = useSearch({ strict: false })
  const navigate = useNavigate()
  const { data: now, error } = useQuery(listeningQuery(projectId))
  const { data: me } = useQuery(meQuery)
  const { recordings, isPending } = useRecordings(projectId)
  useTitle('Recording')
  const listening = now?.listening_pass
  const chosen = recordings.find(({ version }) => version.id === recording) ?? recordings[0]
  const board = (
    <Link className="link" to="/projects/$projectId/references" params={{ projectId }}>
      Add a recording to the references
    </Link>
  )
  return (
    <div className="page stack" aria-busy={now === undefined || isPending}>
      <header className="flex wrap items-end gap-2-4">
        <h1>Recording of the game</h1>
        {recordings.length > 0 && (
          <Select
            label="Recording"
            value={chosen?.version.id}
            onChange={({ currentTarget: { value } }) =>
              void navigate({
                to: '/projects/$projectId/recording',
                params: { projectId },
                search: { recording: value },
              })
            }
          >
            {recordings.map((item) => (
              <option key={item.version.id} value={item.version.id}>
                {titleOf(item)}
              </option>
            ))}
          </Select>
        )}
        {board}
        <Link className="link" to="/projects/$projectId/listening" params={{ projectId }}>
          Listening pass
        </Link>
      </header>
      <Refusal error={error} />
      {now && !listening && (
        <EmptyState head="No listening pass is open" level={2}>
          Begin one on the page of the listening pass: its sounds are those that a moment can be about.
        </EmptyState>
      )}
      {listening && !isPending && !chosen && (
        <EmptyState head="No recording yet" level={2}>
          Record the screen while you play, and add the MP4 or WebM to the references; a lost connection does not stop
          it. Then play it here, and press a key whenever a sound is not as it should be.
        </EmptyState>
      )}
      {listening && me && chosen && (
        <Recording
          key={chosen.version.id}
          reference={chosen}
          listening={listening}
          projectId={projectId}
          personId={me.person.id}
          beginsAtS={chosen.version.id === recording ? at : undefined}
        />
      )}
    </div>
  )
}

/** The clips and sounds among the references of a project, the newest first. */
function useRecordings(projectId: string): { recordings: readonly Reference[]; isPending: boolean } {
  const { data, hasNextPage, isFetchingNextPage, fetchNextPage, isPending } = useInfiniteQuery(boardQuery(projectId))
  useEffect(() => {
    if (hasNextPage && !isFetchingNextPage) void fetchNextPage()
  }, [hasNextPage, isFetchingNextPage, fetchNextPage])
  const all = data?.pages.flatMap(({ items }) => items) ?? []
  return {
    recordings: all.filter(({ version: { kind } }) => kind === 'video' || kind === 'audio'),
    isPending: isPending || hasNextPage,
  }
}
