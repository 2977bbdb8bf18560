import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { useTitle } from '@/app/title'
import { meQuery } from '@/judging/api'
import { Button, ButtonLink } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Row, Rows } from '@/ui/Rows'
import { Segmented } from '@/ui/Segmented'

import { type Project, useProjects } from './api'
import classes from './Projects.module.css'
import { Refusal } from './Refusal'
import { KIND_WORDS } from './words'

/** What the person at the screen is in a project, in words. */
function partIn({ mine }: Project): string {
  if (mine.engagement_kind) return `you make its sounds, ${KIND_WORDS[mine.engagement_kind]}`
  if (mine.is_decider) return 'you decide'
  if (mine.is_producer) return 'you run it'
  return mine.is_liaison ? 'you speak for the team' : 'you listen and comment'
}

/** Every project in sight, for those with several. */
export function ProjectsPage() {
  useTitle('Projects')
  const [which, setWhich] = useState<'running' | 'away'>('running')
  const { data: me } = useQuery(meQuery)
  const { data, error, hasNextPage, fetchNextPage, isFetchingNextPage } = useProjects(which === 'away')
  const projects = data?.pages.flatMap(({ items }) => items)
  const mayOpen = me?.studios.some(({ roles }) => roles.includes('producer')) ?? false
  const several = new Set(projects?.map(({ studio }) => studio.id)).size > 1
  return (
    <div className="page">
      <div className={classes.head}>
        <h1>Projects</h1>
        <div className="row wrap">
          <Segmented
            label="Which projects"
            options={[
              { value: 'running', label: 'Running' },
              { value: 'away', label: 'Put away' },
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
      <Refusal error={error} />
      {projects?.length === 0 &&
        (which === 'away' ? (
          <EmptyState head="Nothing is put away.">
            A producer puts a project away on its page, once it is done.
          </EmptyState>
        ) : (
          <EmptyState head="You are part of no project.">
            {mayOpen
              ? 'Open one: it holds the sound list, what a file must be, and everybody who works on it.'
              : 'A studio invites you by mail; the link in it opens the project.'}
          </EmptyState>
        ))}
      {projects !== undefined && projects.length > 0 && (
        <Card aria-label="Projects">
          <Rows aria-label="Projects">
            {projects.map((project) => (
              <Row key={project.id} className={classes.project}>
                <Link className={classes.name} to="/projects/$projectId" params={{ projectId: project.id }}>
                  <span className="strong">{project.name}</span>
                  <span className="small mid cut-text">{project.description}</span>
                </Link>
                <span className="small mid">{partIn(project)}</span>
                <span className="small dim">
                  {[
                    project.mine.is_decider ? '' : `${project.decider.name} decides`,
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
      {hasNextPage && (
        <p className={classes.more}>
          <Button aria-busy={isFetchingNextPage} onClick={() => void fetchNextPage()}>
            Earlier projects
          </Button>
        </p>
      )}
    </div>
  )
}
