import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { Card, CardHead } from '@/ui/Card'
import { Person } from '@/ui/Person'
import { Refusal } from '@/ui/Refusal'

import forms from '../Hiring.module.css'
import { type OwnProject, ownProjectsQuery } from './api'
import classes from './Roster.module.css'

/** Each project of the current person: the credit, the people, and the playlists with their sounds. */
export function OwnProjects() {
  const { data: projects, error } = useQuery(ownProjectsQuery)
  return (
    <>
      <Refusal error={error} />
      {projects?.map((project) => (
        <ProjectCard key={project.project_id} project={project} />
      ))}
    </>
  )
}

function ProjectCard({ project }: { project: OwnProject }) {
  const { project_id: projectId, people, playlists, shown_from: shownFrom } = project
  return (
    <Card aria-labelledby={`project-${projectId}`}>
      <CardHead id={`project-${projectId}`} title={project.project_name} end={project.studio_name} />
      <div className={forms.body}>
        <dl className={`grid ${classes.facts}`}>
          <dt className="mid">Credit</dt>
          <dd>
            {creditOf(project)}{' '}
            <Link
              className="link"
              to="/projects/$projectId/credits"
              params={{ projectId }}
              aria-label={`Change the credit in ${project.project_name}`}
            >
              Change
            </Link>
          </dd>
          {project.agreed_line && (
            <>
              <dt className="mid">As the contract says</dt>
              <dd>{project.agreed_line}</dd>
            </>
          )}
          <dt className="mid">People</dt>
          <dd className="row wrap">
            {people.map(({ person, role }) => (
              <Person key={person.id} name={person.name} picture={person.picture} role={role} />
            ))}
          </dd>
          {shownFrom && (
            <>
              <dt className="mid">May be shown from</dt>
              <dd>{shownFrom}</dd>
            </>
          )}
          <dt className="mid">Playlists with your sounds</dt>
          <dd className="row wrap">
            {playlists.length === 0 && 'None yet. The team makes them.'}
            {playlists.map(({ id, name }) => (
              <Link
                key={id}
                className="link"
                to="/projects/$projectId/playlists/$playlistId"
                params={{ projectId, playlistId: id }}
              >
                {name}
              </Link>
            ))}
          </dd>
        </dl>
      </div>
    </Card>
  )
}

function creditOf({ credit_name: name, credit_roles: roles, is_left_out: isLeftOut }: OwnProject): string {
  if (isLeftOut) return 'None, as you asked.'
  return roles.length > 0 ? `${name}, ${roles.join(', ')}.` : `${name}, once a sound of yours is approved.`
}
