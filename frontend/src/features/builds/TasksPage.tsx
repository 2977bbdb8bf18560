import { Link, useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useTitle } from '@/app/title'
import { PageHead } from '@/ui/PageHead'

import { TasksCard } from './TasksCard'

/** The tasks of a project's sounds in the game: all of them for the team, their own for designers. */
export function TasksPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  useTitle('Implementation tasks')
  return (
    <div className="page stack">
      <PageHead title="Implementation tasks">
        From notes of the{' '}
        <Link className="link" to="/projects/$projectId/listening" params={{ projectId }}>
          listening pass
        </Link>{' '}
        and from drift that was sent back.
      </PageHead>
      <TasksCard projectId={projectId} />
    </div>
  )
}
