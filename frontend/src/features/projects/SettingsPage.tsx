import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps, useParams } from '@tanstack/react-router'
import type { FormEvent } from 'react'

import { projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'

import { type Project, useChangeProject } from './api'
import classes from './Project.module.css'
import { against } from './words'

/** The name of a project, its prefix and its description; archived and erased here too. */
export function SettingsPage() {
  useTitle('Project settings')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/settings' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  return (
    <div className="page page-narrow stack">
      <h1>Project settings</h1>
      <Refusal inset error={error} />
      {project?.mine.is_producer === false && <p>Only producers change the name of a project.</p>}
      {project?.mine.is_producer && <ProjectForm key={project.name} project={project} />}
    </div>
  )
}

function ProjectForm({ project }: { project: Project }) {
  const change = useChangeProject(project.id)
  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    const data = new FormData(event.currentTarget)
    const field = (name: string) => {
      const value = data.get(name)
      return typeof value === 'string' ? value : ''
    }
    change.mutate(
      { name: field('name'), description: field('description'), cue_prefix: field('cue_prefix') },
      {
        onSuccess: ({ name }) => {
          showToast(`${name} updated.`, () => void change.mutate(named(project)))
        },
      },
    )
  }
  const setArchived = (archived: boolean) =>
    change.mutate(
      { archived },
      {
        onSuccess: ({ name }) => {
          showToast(
            archived ? `${name} archived.` : `${name} restored.`,
            () => void change.mutate({ archived: !archived }),
          )
        },
      },
    )
  const isAway = project.archived_at !== null
  return (
    <Card className={classes.change}>
      <form onSubmit={send} noValidate aria-label="Project details">
        <TextInput name="name" label="Name" defaultValue={project.name} error={against(change.error, 'name')} />
        <TextInput
          name="cue_prefix"
          label="Cue ID prefix"
          defaultValue={project.cue_prefix}
          error={against(change.error, 'cue_prefix')}
        />
        <Textarea
          className={classes.whole}
          name="description"
          label="Description"
          rows={2}
          resize="vertical"
          defaultValue={project.description}
          error={against(change.error, 'description')}
        />
        <div className={`row wrap ${classes.whole}`}>
          <Button type="submit" variant="primary" aria-busy={change.isPending}>
            Save
          </Button>
          <Button variant="quiet" className="end" onClick={() => setArchived(!isAway)}>
            {isAway ? 'Restore' : 'Archive'}
          </Button>
          <Link className="link small" to={`/erase/projects/${project.id}` as LinkProps['to']}>
            Erase…
          </Link>
        </div>
      </form>
      <Refusal inset error={change.error} />
    </Card>
  )
}

const named = ({ name, description, cue_prefix }: Project) => ({ name, description, cue_prefix })
