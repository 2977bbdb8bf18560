import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { useTitle } from '@/app/title'

import { membersQuery, projectQuery } from './api'
import { ApproverCard } from './people/ApproverCard'
import { DesignersCard } from './people/DesignersCard'
import { TeamCard } from './people/TeamCard'
import classes from './Project.module.css'
import { Refusal } from './Refusal'

/** Who speaks for the team, who has the last word, who makes the sounds. */
export function PeoplePage() {
  useTitle('People')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/people' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const isTeam = project?.mine.is_team ?? false
  const { data: members, error: noMembers } = useQuery({
    ...membersQuery(project?.studio.id ?? ''),
    enabled: isTeam,
  })
  return (
    <div className="page stack">
      <div>
        <h1>People</h1>
        <p className="mid">
          Who works on{' '}
          <Link className="link" to="/projects/$projectId" params={{ projectId }}>
            {project?.name ?? 'the project'}
          </Link>
          {', and what they may do.'}
        </p>
      </div>
      <Refusal error={error ?? noMembers} />
      {project && !isTeam && <p>{`${project.decider.name} decides. The team keeps its own list of people.`}</p>}
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
