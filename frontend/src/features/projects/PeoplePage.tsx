import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { projectQuery, studioPeopleQuery } from '@/api/project'
import { useTitle } from '@/app/title'

import { ApproverCard } from './people/ApproverCard'
import { DesignersCard } from './people/DesignersCard'
import { TeamCard } from './people/TeamCard'
import classes from './Project.module.css'
import { Refusal } from './Refusal'

/** The liaisons, the approver and the designers. */
export function PeoplePage() {
  useTitle('People')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/people' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const isTeam = project?.mine.is_team ?? false
  const { data: members, error: noMembers } = useQuery({
    ...studioPeopleQuery(project?.studio.id ?? ''),
    enabled: isTeam,
  })
  return (
    <div className="page stack">
      <div>
        <h1>People</h1>
        <p className="mid">
          The people on{' '}
          <Link className="link" to="/projects/$projectId" params={{ projectId }}>
            {project?.name ?? 'the project'}
          </Link>
          {' and their roles.'}
        </p>
      </div>
      <Refusal error={error ?? noMembers} />
      {project && !isTeam && (
        <p>{`${project.approver.name} is the approver. Only the game team can see its members.`}</p>
      )}
      {project && isTeam && (
        <div className={`columns ${classes.columns}`}>
          <div className="stack">
            <DesignersCard project={project} />
            <TeamCard project={project} members={members} />
          </div>
          <ApproverCard project={project} members={members} />
        </div>
      )}
    </div>
  )
}
