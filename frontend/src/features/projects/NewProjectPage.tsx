import { Select, Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps, useNavigate } from '@tanstack/react-router'
import { type FormEvent, useState } from 'react'

import { ApiProblem } from '@/api'
import { meQuery } from '@/api/me'
import { DraftNote, useDraft } from '@/app/drafts'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { PageSkeleton } from '@/ui/Skeleton'

import { useOpenProject } from './api'
import classes from './New.module.css'
import { against, proposedPrefix } from './words'

type Preset = '48k' | '44k1'

/** The specs to start from, the usual one first. */
const PRESETS: Record<Preset, { head: string; accepts: string; makes: string; when: string }> = {
  '48k': {
    head: 'Game standard: 48 kHz / 24 bit',
    accepts: 'Masters: 48 or 96 kHz, 24-bit, mono or stereo.',
    makes: 'Game files: “game” at 48 kHz/16-bit.',
    when: 'For current engines and consoles. The usual choice.',
  },
  '44k1': {
    head: 'CD rate: 44.1 kHz / 16 bit',
    accepts: 'Masters: 44.1, 48 or 96 kHz, 16- or 24-bit, mono or stereo.',
    makes: 'Game files: “game” at 44.1 kHz/16-bit and “handheld” at 22.05 kHz/16-bit mono.',
    when: 'For CD-rate projects and legacy libraries.',
  },
}

/** Open a project: a name, a prefix, what game it is, and the spec to begin from. */
export function NewProjectPage() {
  useTitle('New project')
  const { data: me } = useQuery(meQuery)
  if (me === undefined) return <PageSkeleton />
  const studios = me.studios.filter(({ roles }) => roles.includes('producer'))
  if (studios.length === 0) {
    return (
      <div className="page page-narrow">
        <EmptyState
          head="Only producers create projects"
          level={1}
          action={
            <Link className="link" to="/account">
              Create your own studio
            </Link>
          }
        >
          {me.studios.length > 0
            ? `You are not a producer of ${me.studios.map(({ name }) => name).join(' or ')}. Ask one to create the project and make you its approver.`
            : 'You are not in a studio. Studios invite sound designers to their projects.'}
        </EmptyState>
      </div>
    )
  }
  return <NewProjectForm studios={studios} isFirst={me.projects.length === 0} />
}

interface NewProjectFormProps {
  studios: readonly { id: string; name: string }[]
  isFirst: boolean
}

function NewProjectForm({ studios, isFirst }: NewProjectFormProps) {
  const navigate = useNavigate()
  const open = useOpenProject()
  const [name, setName, nameDraft] = useDraft('new-project:name', '')
  // Once typed, the prefix follows the name no longer.
  const [typed, setTyped] = useState<string | null>(null)
  const [description, setDescription, descriptionDraft] = useDraft('new-project:description', '')
  const [preset, setPreset] = useState<Preset>('48k')
  const [studioId, setStudioId] = useState(studios[0]?.id ?? '')
  const prefix = typed ?? proposedPrefix(name)
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (open.isPending) return
    open.mutate(
      { studio_id: studioId, name, cue_prefix: prefix, description, preset },
      {
        onSuccess: ({ id }) => {
          nameDraft.discard()
          descriptionDraft.discard()
          void navigate({ to: `/projects/${id}/sound-list` as LinkProps['to'] })
        },
      },
    )
  }
  const hasFields = open.error instanceof ApiProblem && open.error.errors.length > 0
  return (
    <div className="page">
      <div className={classes.head}>
        <h1>New project</h1>
        <p className="mid">
          {isFirst
            ? 'Start with a project. It holds the sound list, the delivery spec and the people who work on it.'
            : 'It starts with an empty sound list and a standard delivery spec.'}
        </p>
      </div>
      <Card className={classes.card}>
        <form onSubmit={send} noValidate className={classes.form}>
          <DraftNote draft={nameDraft} />
          {studios.length > 1 && (
            <Select
              className={classes.whole}
              label="Studio"
              data={studios.map(({ id, name: label }) => ({ value: id, label }))}
              value={studioId}
              onChange={(value) => setStudioId(value ?? studioId)}
              allowDeselect={false}
            />
          )}
          <TextInput
            label="Game title"
            value={name}
            onChange={({ currentTarget }) => setName(currentTarget.value)}
            error={against(open.error, 'name')}
          />
          <TextInput
            label="Cue ID prefix"
            value={prefix}
            onChange={({ currentTarget }) => setTyped(currentTarget.value.toUpperCase())}
            inputWrapperOrder={['label', 'input', 'description', 'error']}
            description={prefix === '' ? '1–8 letters or digits' : `Cues are numbered ${prefix}-001, ${prefix}-002 …`}
            error={against(open.error, 'cue_prefix')}
          />
          <Textarea
            className={classes.whole}
            label="Description (optional)"
            inputWrapperOrder={['label', 'input', 'description', 'error']}
            description="What kind of game is it, and on what will it be played? Designers read this first."
            rows={2}
            resize="vertical"
            value={description}
            onChange={({ currentTarget }) => setDescription(currentTarget.value)}
            error={against(open.error, 'description')}
          />
          <fieldset className={`${classes.presets} ${classes.whole}`}>
            <legend>Delivery spec (you can change everything later)</legend>
            {(Object.keys(PRESETS) as Preset[]).map((key) => {
              const { head, accepts, makes, when } = PRESETS[key]
              return (
                <label key={key} className={classes.preset} data-chosen={preset === key || undefined}>
                  <input
                    type="radio"
                    name="preset"
                    value={key}
                    checked={preset === key}
                    onChange={() => setPreset(key)}
                    aria-describedby={`preset-${key}`}
                    aria-label={head}
                  />
                  <span>
                    <span className="strong">{head}</span>
                    <span id={`preset-${key}`} className={`mid ${classes.facts}`}>
                      <span>{accepts}</span>
                      <span>{makes}</span>
                      <span className="dim">{when}</span>
                    </span>
                  </span>
                </label>
              )
            })}
          </fieldset>
          {!hasFields && <Refusal inset error={open.error} />}
          <div className={`row wrap ${classes.whole}`}>
            <Button type="submit" variant="primary" aria-busy={open.isPending}>
              Create project
            </Button>
            <span className="small mid">You are the approver until you name someone else.</span>
          </div>
        </form>
      </Card>
    </div>
  )
}
