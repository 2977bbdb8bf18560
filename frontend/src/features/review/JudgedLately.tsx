import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { StatusBadge } from '@/ui/StatusBadge'

import { judgedQuery } from './api'
import classes from './Queue.module.css'

/** What was decided within a week, each still there to be heard again. */
export function JudgedLately({ projectId }: { projectId: string }) {
  const { data: judged = [] } = useQuery(judgedQuery(projectId))
  if (judged.length === 0) return null
  return (
    <>
      <h3 className={`dim ${classes.sub} small`}>Reviewed in the last 7 days</h3>
      <ul>
        {judged.map(({ cue, status }) => (
          <li key={cue.id}>
            <Link
              className={`row hover border-b ${classes.judged}`}
              to="/projects/$projectId/review/$cueId"
              params={{ projectId, cueId: cue.id }}
              search={{}}
            >
              <span className="grow cut-text">{cue.name}</span>{' '}
              <StatusBadge kind={status === 'accepted' ? 'approved' : 'change_requested'} />
            </Link>
          </li>
        ))}
      </ul>
    </>
  )
}
