import { Link, useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useTitle } from '@/app/title'

import { TasksCard } from './TasksCard'

/** The tasks of a project's sounds in the game: all of them for the team, their own for designers. */
export function TasksPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  useTitle('Implementation tasks')
  return (
    <div className="page stack">
      <div>
        <h1>Implementation tasks</h1>
        <p className="mid">
          From notes of the{' '}
          <Link className="link" to="/projects/$projectId/listening" params={{ projectId }}>
            listening pass
          </Link>{' '}
          and from drift that was sent back.
        </p>
      </div>
      <TasksCard projectId={projectId} />
    </div>
  )
}
