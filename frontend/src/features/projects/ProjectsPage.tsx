import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'
import { Segmented } from '@/ui/Segmented'
import { ShowMore } from '@/ui/ShowMore'

import { type Project, useProjects } from './api'
import { OwnPostingsCard } from './OwnPostingsCard'
import classes from './Projects.module.css'
import { KIND_WORDS } from './words'

/** The current person's roles in a project, in words. */
function partIn({ mine }: Project): string {
  if (mine.engagement_kind) return `sound designer, ${KIND_WORDS[mine.engagement_kind]}`
  if (mine.is_approver) return 'you are the approver'
  if (mine.is_producer) return 'you are a producer'
  return mine.is_liaison ? 'you are an audio lead' : 'you are a reviewer'
}

/** Every project in sight, for those with several. */
export function ProjectsPage() {
  useTitle('Projects')
  const [which, setWhich] = useState<'running' | 'away'>('running')
  const { data: me } = useQuery(meQuery)
  const pages = useProjects(which === 'away')
  const { data, error } = pages
  const projects = data?.pages.flatMap(({ items }) => items)
  const mayOpen = me?.studios.some(({ roles }) => roles.includes('producer')) ?? false
  const several = new Set(projects?.map(({ studio }) => studio.id)).size > 1
  return (
    <div className="page stack">
      <div className="flex wrap items-end between gap-2-4">
        <h1>Projects</h1>
        <div className="row wrap">
          <Segmented
            label="Filter projects"
            options={[
              { value: 'running', label: 'Active' },
              { value: 'away', label: 'Archived' },
            ]}
            value={which}
            onChange={setWhich}
          />
          {mayOpen && (
            <ButtonLink component={Link} variant="primary" icon="plus" to="/projects/new">
              New project
            </ButtonLink>
          )}
        </div>
      </div>
      <Refusal inset error={error} />
      <OwnPostingsCard />
      {projects?.length === 0 &&
        (which === 'away' ? (
          <EmptyState head="No archived projects">Producers can archive a finished project on its page.</EmptyState>
        ) : (
          <EmptyState head="No projects yet">
            {mayOpen
              ? 'Create one. It holds the sound list, the delivery spec and the people who work on it.'
              : 'A studio can invite you by email. The link opens the project.'}
          </EmptyState>
        ))}
      {projects !== undefined && projects.length > 0 && (
        <Card aria-label="Projects">
          <Rows aria-label="Projects">
            {projects.map((project) => (
              <Row key={project.id} className={classes.project}>
                <Link
                  className={`grid min-w-0 ${classes.name}`}
                  to="/projects/$projectId"
                  params={{ projectId: project.id }}
                >
                  <span className="strong">{project.name}</span>
                  <span className="small mid cut-text">{project.description}</span>
                </Link>
                <span className="small mid">{partIn(project)}</span>
                <span className="small dim">
                  {[
                    project.mine.is_approver ? '' : `approver: ${project.approver.name}`,
                    several ? project.studio.name : '',
                  ]
                    .filter(Boolean)
                    .join(', ')}
                </span>
                <span className="mono small dim">{project.cue_prefix}</span>
              </Row>
            ))}
          </Rows>
        </Card>
      )}
      {pages.hasNextPage && (
        <p className="mt-3">
          <ShowMore list={pages}>Earlier projects</ShowMore>
        </p>
      )}
    </div>
  )
}
