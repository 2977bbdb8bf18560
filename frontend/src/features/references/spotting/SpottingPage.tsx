import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { titleOf } from '@/references'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'

import { clipQuery } from './api'
import classes from './Spotting.module.css'
import { Spotting } from './Spotting'

/** Marks in a clip where sounds are needed, which become cues together. */
export function SpottingPage() {
  useTitle('Spotting')
  const { projectId, referenceId } = useParams({ from: '/shell/projects/$projectId/references/$referenceId/spotting' })
  const { data: clip, error, isPending } = useQuery(clipQuery(projectId, referenceId))
  const back = (
    <Link className="link" to="/projects/$projectId/references" params={{ projectId }} search={{ cue: undefined }}>
      All references
    </Link>
  )
  const refusal = clip !== undefined && whyNot(clip)
  return (
    <div className={`page stack content-start ${classes.page}`} aria-busy={isPending}>
      <Refusal error={error} />
      {refusal && (
        <EmptyState head={refusal} level={1} action={back}>
          Spotting marks, in a clip on the board, where sounds are needed.
        </EmptyState>
      )}
      {clip && !refusal && (
        <>
          <header className="flex wrap items-baseline gap-2-4 wrap-anywhere">
            <h1>{`Spotting: ${titleOf(clip)}`}</h1>
            {back}
          </header>
          <Spotting key={clip.id} clip={clip} />
        </>
      )}
    </div>
  )
}

function whyNot(clip: { may_change: boolean; version: { kind: string } } | null): string | null {
  if (clip === null) return 'This clip is not on the board'
  if (clip.version.kind !== 'video') return 'Only clips are spotted'
  return clip.may_change ? null : 'Only producers, audio leads and approvers spot clips'
}
