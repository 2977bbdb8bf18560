import { Link, Navigate, useParams, useSearch } from '@tanstack/react-router'

import type { ReactNode } from 'react'

import { useMyProject } from '@/api/me'
import { useTitle } from '@/app/title'
import { isNoted } from '@/verdicts/afterVerdict'
import { Drafts } from '@/verdicts/Drafts'
import { filterOf, isFiltered } from '@/verdicts/queueFilter'
import { useQueue } from '@/verdicts/useQueue'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'

import { JudgedLately } from './JudgedLately'

/** The review room without a cue: it opens the first that waits, or says that none does. */
export function ReviewStart(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  useTitle('Review')
  const filter = filterOf(useSearch({ strict: false }))
  const queue = useQueue(projectId, undefined, filter)
  const project = useMyProject(projectId)
  const noted = queue.items.filter(isNoted)
  const first = queue.open[0]
  if (first) {
    return (
      <Navigate
        to="/projects/$projectId/review/$cueId"
        params={{ projectId, cueId: first.cue.id }}
        search={filter}
        replace
      />
    )
  }
  if (queue.error) {
    return (
      <div className="page">
        <h1>Review</h1>
        <Refusal error={queue.error} />
      </div>
    )
  }
  if (!queue.isKnown) return <h1 className="visually-hidden">Review</h1>
  if (isFiltered(filter)) {
    return (
      <div className="page max-w-720px grid gap-4">
        <EmptyState
          head="No cues match this filter"
          level={1}
          action={
            <Link to="/projects/$projectId/review" params={{ projectId }} search={{}} className="link">
              Show all
            </Link>
          }
        >
          Other cues may be waiting.
        </EmptyState>
      </div>
    )
  }
  return (
    <div className="page max-w-720px grid gap-4">
      <EmptyState
        head="Nothing to review"
        level={1}
        action={
          <Link to="/projects/$projectId/today" params={{ projectId }} className="link">
            Go to Today
          </Link>
        }
      >
        {noted.length > 0
          ? 'Your draft change requests are sent when you send them all.'
          : 'New versions appear here once they are checked and their game files are rendered.'}
      </EmptyState>
      {noted.length > 0 && (
        <Card aria-labelledby="drafts">
          <CardHead id="drafts" title="Changes to send" />
          <Drafts projectId={projectId} mayApprove={project?.is_approver ?? false} />
        </Card>
      )}
      <Card aria-label="Recently reviewed">
        <JudgedLately projectId={projectId} />
      </Card>
    </div>
  )
}
