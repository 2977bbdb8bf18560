import { Select, Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps, useNavigate } from '@tanstack/react-router'
import { type FormEvent, useState } from 'react'

import { ApiProblem } from '@/api'
import { useTitle } from '@/app/title'
import { meQuery } from '@/judging/api'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'

import { useOpenProject } from './api'
import classes from './New.module.css'
import { Refusal } from './Refusal'
import { against, proposedPrefix } from './words'

type Preset = '44k1' | '48k'

/** The two beginnings, told by what they let in and what they make. */
const PRESETS: Record<Preset, { head: string; accepts: string; makes: string; when: string }> = {
  '44k1': {
    head: '44.1 kHz game',
    accepts: 'Masters at 44.1, 48 or 96 kHz, 16 or 24 bit, mono or stereo.',
    makes: 'Two game files of each: “game” at 44.1 kHz, 16 bit, and “handheld” at 22.05 kHz, 16 bit, mono.',
    when: 'For most engines, and where old libraries are used too.',
  },
  '48k': {
    head: '48 kHz game',
    accepts: 'Masters at 48 or 96 kHz, 24 bit, mono or stereo.',
    makes: 'One game file of each: “game” at 48 kHz, 16 bit.',
    when: 'For consoles and film-like work, where all is recorded new.',
  },
}

/** Open a project: a name, a prefix, what game it is, and the spec to begin from. */
export function NewProjectPage() {
  useTitle('New project')
  const { data: me } = useQuery(meQuery)
  if (me === undefined) return null
  const studios = me.studios.filter(({ roles }) => roles.includes('producer'))
  if (studios.length === 0) {
    return (
      <div className="page page-narrow">
        <EmptyState
          head="A producer opens projects."
          level={1}
          action={
            <Link className="link" to="/account">
              Open a studio of your own
            </Link>
          }
        >
          {me.studios.length > 0
            ? `You are no producer of ${me.studios.map(({ name }) => name).join(' or ')}. A producer there can open one and name you approver.`
            : 'You belong to no studio. A designer is invited to a project by its studio.'}
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
  const [name, setName] = useState('')
  // Once typed, the prefix follows the name no longer.
  const [typed, setTyped] = useState<string | null>(null)
  const [description, setDescription] = useState('')
  const [preset, setPreset] = useState<Preset>('44k1')
  const [studioId, setStudioId] = useState(studios[0]?.id ?? '')
  const prefix = typed ?? proposedPrefix(name)
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (open.isPending) return
    open.mutate(
      { studio_id: studioId, name, cue_prefix: prefix, description, preset },
      {
        onSuccess: ({ id }) => void navigate({ to: `/projects/${id}/sound-list` as LinkProps['to'] }),
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
            ? 'You have no project yet, so you begin here: it holds the sound list, what a file must be, and everybody who works on it.'
            : 'It begins with an empty sound list and a delivery spec of the field’s defaults.'}
        </p>
      </div>
      <Card className={classes.card}>
        <form onSubmit={send} noValidate className={classes.form}>
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
            label="Name of the game"
            value={name}
            onChange={({ currentTarget }) => setName(currentTarget.value)}
            error={against(open.error, 'name')}
          />
          <TextInput
            label="Prefix of cue numbers"
            value={prefix}
            onChange={({ currentTarget }) => setTyped(currentTarget.value.toUpperCase())}
            inputWrapperOrder={['label', 'input', 'description', 'error']}
            description={
              prefix === '' ? 'One to eight capitals or digits' : `Cues are numbered ${prefix}-001, ${prefix}-002 …`
            }
            error={against(open.error, 'cue_prefix')}
          />
          <Textarea
            className={classes.whole}
            label="What game is it, and where is it heard?"
            inputWrapperOrder={['label', 'input', 'description', 'error']}
            description="A designer reads this first. It may stay empty."
            rows={2}
            resize="vertical"
            value={description}
            onChange={({ currentTarget }) => setDescription(currentTarget.value)}
            error={against(open.error, 'description')}
          />
          <fieldset className={`${classes.presets} ${classes.whole}`}>
            <legend>Delivery spec to begin from; everything in it can be changed later</legend>
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
          {!hasFields && <Refusal error={open.error} />}
          <div className={`row wrap ${classes.whole}`}>
            <Button type="submit" variant="primary" aria-busy={open.isPending}>
              Open the project
            </Button>
            <span className="small mid">You have the last word until you name an approver.</span>
          </div>
        </form>
      </Card>
    </div>
  )
}
