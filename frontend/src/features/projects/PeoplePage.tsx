import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { studioPeopleQuery, projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'

import { type Project } from './api'
import { DesignersCard } from './people/DesignersCard'
import { TeamCard } from './people/TeamCard'
import classes from './Project.module.css'

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
      <PageHead title="People">
        {`The people on ${project?.name ?? 'the project'} and their roles. `}
        <Link className="link" to="/projects/$projectId/credits" params={{ projectId }}>
          Credits
        </Link>
        {project?.mine.is_producer && (
          <>
            {' · '}
            <Link className="link" to="/projects/$projectId/hours" params={{ projectId }}>
              Hours
            </Link>
          </>
        )}
      </PageHead>
      <Refusal inset error={error ?? noMembers} />
      {project && !isTeam && <p>{`${approversOf(project)} Only the game team can see its members.`}</p>}
      {project && isTeam && (
        <div className={`columns ${classes.columns}`}>
          <DesignersCard project={project} />
          <TeamCard project={project} members={members} />
        </div>
      )}
    </div>
  )
}

/** "Audio director is the approver, Composer of ui." */
function approversOf({ approver, category_approvers: named }: Project): string {
  const others = named.map(({ category, approver: own }) => `, ${own.name} of ${category}`)
  return `${approver.name} is the approver${others.join('')}.`
}
