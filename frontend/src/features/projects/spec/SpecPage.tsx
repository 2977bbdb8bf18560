import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { projectQuery, specQuery } from '@/api/project'
import { RefusedNamesNote } from '@/app/RefusedNames'
import { useTitle } from '@/app/title'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'

import { checksQuery } from '../api'
import { canActForStudio } from '../words'
import { SpecEditor } from './SpecEditor'

/** Change what a file must be, by form or as TOML. */
export function SpecPage() {
  useTitle('Delivery spec')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/spec' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const { data: spec, error: noSpec } = useQuery(specQuery(projectId))
  const { data: checks, error: noChecks } = useQuery(checksQuery)
  if (project && !canActForStudio(project)) {
    return (
      <div className="page page-narrow">
        <EmptyState
          head="Only producers and audio leads can edit the spec"
          level={1}
          action={
            <>
              <Link className="link" to="/projects/$projectId/spec/versions" params={{ projectId }} search={{}}>
                View the spec and its versions
              </Link>
              <Link className="link" to="/projects/$projectId" params={{ projectId }}>
                Go to project
              </Link>
            </>
          }
        >
          {`Ask ${project.approver.name} if you need a change.`}
        </EmptyState>
      </div>
    )
  }
  return (
    <div className="page">
      {project && spec && checks ? (
        <>
          <SpecEditor key={projectId} project={project} spec={spec} />
          <RefusedNamesNote projectId={projectId} edits />
        </>
      ) : (
        <h1>Delivery spec</h1>
      )}
      <Refusal inset error={error ?? noSpec ?? noChecks} />
    </div>
  )
}
