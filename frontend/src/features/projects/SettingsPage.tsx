import { Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps, useParams } from '@tanstack/react-router'

import { projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'

import { type Project, useChangeProject } from './api'
import classes from './Project.module.css'

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
  const isArchived = project.archived_at !== null
  return (
    <Card className={classes.change}>
      <Form
        className=""
        aria-label="Project details"
        initialValues={named(project)}
        mutation={change}
        onSubmit={(typed) =>
          change.mutate(typed, {
            onSuccess: ({ name }) => showToast(`${name} updated.`, () => void change.mutate(named(project))),
          })
        }
      >
        <Field name="name" label="Name" />
        <Field name="cue_prefix" label="Cue ID prefix" />
        <Field
          as={Textarea}
          optional
          className={classes.whole}
          name="description"
          label="Description"
          rows={2}
          resize="vertical"
        />
        <Submit
          className={`row wrap ${classes.whole}`}
          beside={
            <>
              <Button variant="quiet" className="end" onClick={() => setArchived(!isArchived)}>
                {isArchived ? 'Restore' : 'Archive'}
              </Button>
              <Link className="link small" to={`/erase/projects/${project.id}` as LinkProps['to']}>
                Erase…
              </Link>
            </>
          }
        >
          Save
        </Submit>
      </Form>
    </Card>
  )
}

const named = ({ name, description, cue_prefix }: Project) => ({ name, description, cue_prefix })
