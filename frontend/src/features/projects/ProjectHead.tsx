import { studioPeopleQuery } from '@/api/project'
import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps } from '@tanstack/react-router'
import { type FormEvent, useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { Face } from '@/ui/Face'
import { Refusal } from '@/ui/Refusal'

import { type Project, useChangeProject } from './api'
import classes from './Project.module.css'
import { against, KIND_WORDS, otherMembers, speaks } from './words'

interface Someone {
  id: string
  name: string
  picture?: string | null
  part: string
}

/** Those who run, decide and make, in this order; the rest of the studio is a number. */
function usePeople(project: Project): Someone[] {
  const { data: members } = useQuery({ ...studioPeopleQuery(project.studio.id), enabled: project.mine.is_team })
  const { approver } = project
  const designers = project.engagements.filter(({ ended_at }) => ended_at === null)
  const producers = (members ?? []).filter(
    ({ roles, person }) => roles.includes('producer') && person.id !== approver.id,
  )
  return [
    { ...approver, part: `${approver.name}, approver` },
    ...producers.map(({ person: { id, name, picture } }) => ({
      id,
      name,
      picture,
      part: /producer/i.test(name) ? name : `${name}, producer`,
    })),
    ...designers.map(({ designer, kind }) => ({ ...designer, part: `${designer.name}, ${KIND_WORDS[kind]}` })),
  ]
}

interface ProjectHeadProps {
  project: Project
  /** How many members the studio has. */
  members?: number
}

export function ProjectHead({ project, members = 0 }: ProjectHeadProps) {
  const people = usePeople(project)
  const [changing, setChanging] = useState(false)
  const designers = project.engagements.filter(({ ended_at }) => ended_at === null).length
  const others = members - (people.length - designers)
  const { mine, id: projectId } = project
  if (changing) return <ChangeProject project={project} onDone={() => setChanging(false)} />
  return (
    <div className={classes.head}>
      <div>
        <h1>{project.name}</h1>
        <p className="mid">
          {project.description ||
            (mine.is_producer ? 'No description yet. What kind of game is it, and on what will it be played?' : '')}
          {mine.is_producer && (
            <>
              {' '}
              <button type="button" className={`link small ${classes.inline}`} onClick={() => setChanging(true)}>
                Change <span className="visually-hidden">name, prefix and description</span>
              </button>
            </>
          )}
        </p>
      </div>
      <div className={`${classes.people} small mid`}>
        <ul>
          {people.map(({ id, name, picture, part }) => (
            <li key={id}>
              <Face name={name} picture={picture} />
              {part}
            </li>
          ))}
          {mine.is_team && others > 0 && <li className="wide-only">{otherMembers(others)}</li>}
        </ul>
        <Link className="link" to={`/projects/${projectId}/brief` as LinkProps['to']}>
          Brief
        </Link>
        <Link className="link" to="/projects/$projectId/references" params={{ projectId }} search={{}}>
          References
        </Link>
        <Link className="link" to="/projects/$projectId/reasons" params={{ projectId }} search={{}}>
          Reasons
        </Link>
        <Link className="link" to={`/projects/${projectId}/voice-lines` as LinkProps['to']}>
          Voice lines
        </Link>
        <Link className="link" to={`/projects/${projectId}/listening` as LinkProps['to']}>
          Listening pass
        </Link>
        {mine.is_team && (
          <Link className="link" to="/projects/$projectId/people" params={{ projectId }}>
            People
          </Link>
        )}
        {mine.is_team && speaks(project) && (
          <Link className="link" to={`/projects/${projectId}/postings` as LinkProps['to']}>
            Postings
          </Link>
        )}
        {mine.is_producer && (
          <Link className="link" to="/projects/$projectId/hours" params={{ projectId }}>
            Hours
          </Link>
        )}
        {(!mine.is_team || speaks(project)) && (
          <Link className="link" to={`/projects/${projectId}/money` as LinkProps['to']}>
            Money
          </Link>
        )}
      </div>
      {project.archived_at !== null && (
        <p className={classes.away}>
          This project is archived. It is read-only in lists of active projects and can be restored.
        </p>
      )}
    </div>
  )
}

/** What a project is called, in place of its head. */
function ChangeProject({ project, onDone }: { project: Project; onDone: () => void }) {
  const change = useChangeProject(project.id)
  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    const data = new FormData(event.currentTarget)
    const said = (name: string) => {
      const value = data.get(name)
      return typeof value === 'string' ? value : ''
    }
    change.mutate(
      { name: said('name'), description: said('description'), cue_prefix: said('cue_prefix') },
      {
        onSuccess: ({ name }) => {
          showToast(`${name} updated.`, () => void change.mutate(named(project)))
          onDone()
        },
      },
    )
  }
  const putAway = (archived: boolean) =>
    change.mutate(
      { archived },
      {
        onSuccess: ({ name }) => {
          showToast(
            archived ? `${name} archived.` : `${name} restored.`,
            () => void change.mutate({ archived: !archived }),
          )
          onDone()
        },
      },
    )
  const isAway = project.archived_at !== null
  return (
    <Card className={classes.change}>
      <h1 className="visually-hidden">{project.name}</h1>
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
          <Button variant="quiet" onClick={onDone}>
            Cancel
          </Button>
          <Button variant="quiet" className="end" onClick={() => putAway(!isAway)}>
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
