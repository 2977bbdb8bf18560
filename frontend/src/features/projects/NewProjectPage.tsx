import { Select, Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate } from '@tanstack/react-router'
import { useState } from 'react'

import { meQuery } from '@/api/me'
import { formDraft, keepDraft } from '@/app/drafts'
import { useOpenSample } from '@/app/SampleProject'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { Sheet } from '@/ui/Sheet'
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

/** Open a project. */
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

/** One question. The rest has defaults, which a sentence says and "More options" changes. */
function NewProjectForm({ studios, isFirst }: NewProjectFormProps) {
  const navigate = useNavigate()
  const open = useOpenProject()
  const draft = formDraft('new-project', { name: '', description: '' })
  const [name, setName] = useState(draft.initialValues.name)
  const [typedPrefix, setTypedPrefix] = useState<string | null>(null) // once typed, it follows the name no longer
  const [preset, setPreset] = useState<Preset>('48k')
  const [studioId, setStudioId] = useState(studios[0]?.id ?? '')
  const [showsOptions, setShowsOptions] = useState(false)
  const [isSample, setSample] = useState(false)
  const sample = useOpenSample(studioId)
  const prefix = typedPrefix ?? proposedPrefix(name)
  const isShown = showsOptions || against(open.error, 'cue_prefix') !== undefined
  return (
    <Sheet wide>
      <h1>{isFirst ? 'What is the game called?' : 'New project'}</h1>
      {isFirst && <FirstChoice isSample={isSample} onChange={setSample} />}
      {isSample ? (
        <>
          <Button variant="primary" aria-busy={sample.isPending} onClick={() => sample.mutate()}>
            Open sample project
          </Button>
          <Refusal error={sample.error} />
        </>
      ) : (
        <Form
          {...draft}
          mutation={open}
          onSubmit={(values) =>
            open.mutate(
              { ...values, studio_id: studioId, cue_prefix: prefix, preset },
              {
                onSuccess: ({ id: projectId }) => {
                  keepDraft('new-project', null)
                  void navigate({ to: '/projects/$projectId/sound-list', params: { projectId } })
                },
              },
            )
          }
        >
          <Field name="name" label="Game title" autoComplete="off" onValue={setName} />
          <p className="small mid">
            {prefix === '' ? 'Cues are numbered by the initials of the title.' : `Cue numbers start with ${prefix}.`}{' '}
            {PRESETS[preset].accepts} You can change everything later.
          </p>
          {isShown && (
            <>
              {studios.length > 1 && (
                <Select
                  label="Studio"
                  data={studios.map(({ id, name: label }) => ({ value: id, label }))}
                  value={studioId}
                  onChange={(value) => setStudioId(value ?? studioId)}
                  allowDeselect={false}
                />
              )}
              <TextInput
                label="Cue ID prefix"
                description="1–8 letters or digits"
                value={prefix}
                onChange={({ currentTarget }) => setTypedPrefix(currentTarget.value.toUpperCase())}
                error={against(open.error, 'cue_prefix')}
              />
              <Field
                as={Textarea}
                optional
                name="description"
                label="Description (optional)"
                description="What kind of game is it, and on what will it be played? Designers read this first."
                rows={2}
                resize="vertical"
              />
              <fieldset className={`grid gap-2-3 grid-cols-1fr-1fr p-0 border-0 narrow-grid-cols-1 ${classes.presets}`}>
                <legend>Delivery spec</legend>
                {(Object.keys(PRESETS) as Preset[]).map((key) => {
                  const { head, accepts, makes, when } = PRESETS[key]
                  return (
                    <label
                      key={key}
                      className={`flex items-start gap-2 hover p-3 border-edge rounded pointer ${classes.preset}`}
                      data-chosen={preset === key || undefined}
                    >
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
                        <span id={`preset-${key}`} className="mid grid gap-1 mt-1">
                          <span>{accepts}</span>
                          <span>{makes}</span>
                          <span className="dim">{when}</span>
                        </span>
                      </span>
                    </label>
                  )
                })}
              </fieldset>
            </>
          )}
          <Submit
            keys="Enter"
            beside={
              <Button variant="quiet" aria-expanded={isShown} onClick={() => setShowsOptions(!showsOptions)}>
                More options
              </Button>
            }
          >
            Create project
          </Submit>
          {isFirst && <p className="small mid">Invited to a project? Open the link in the email that invited you.</p>}
        </Form>
      )}
    </Sheet>
  )
}

/** Their own sounds, or a look around first. */
function FirstChoice({ isSample, onChange }: { isSample: boolean; onChange: (isSample: boolean) => void }) {
  const choices = [
    { value: false, head: 'My own sounds', about: 'Paste a sheet or type a few names.' },
    { value: true, head: 'A sample project', about: '24 sounds to hear and review. Delete it when done.' },
  ]
  return (
    <fieldset
      className={`grid gap-2-3 grid-cols-1fr-1fr p-0 border-0 narrow-grid-cols-1 ${classes.presets} ${classes.begin}`}
    >
      <legend>Begin with</legend>
      {choices.map(({ value, head, about }) => (
        <label
          key={head}
          className={`flex items-start gap-2 hover p-3 border-edge rounded pointer ${classes.preset}`}
          data-chosen={isSample === value || undefined}
        >
          <input
            type="radio"
            name="begin"
            aria-label={`${head}. ${about}`}
            checked={isSample === value}
            onChange={() => onChange(value)}
          />
          <span>
            <span className="strong">{head}</span>
            <span className="mid grid gap-1 mt-1">{about}</span>
          </span>
        </label>
      ))}
    </fieldset>
  )
}
