import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useRef, useState } from 'react'

import { Dialog } from '@/app/Dialog'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { kindName, type Reference, titleOf } from '@/references'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, plural } from '@/ui/format'

import { useChangeReference, useOpenings, useRemoveReference, versionsQuery } from './api'
import { bodyOfPin, pinOf, secondsOf } from './pins'
import { PinSelect } from './PinSelect'
import classes from './Board.module.css'

interface EditDialogProps {
  reference: Reference | null
  onNewVersion: (reference: Reference, files: FileList) => void
  onClose: () => void
}

/** What is said of a reference, its versions, and who opened it. */
export function EditDialog({ reference, onNewVersion, onClose }: EditDialogProps) {
  return (
    <Dialog title={reference ? titleOf(reference) : ''} opened={reference !== null} onClose={onClose} size={640}>
      {reference && <Edit reference={reference} onNewVersion={onNewVersion} onClose={onClose} />}
    </Dialog>
  )
}

const typedSeconds = (s: number | null): string => (s === null ? '' : String(s))

function Edit({ reference, onNewVersion, onClose }: EditDialogProps & { reference: Reference }) {
  const { id, project_id: projectId, version } = reference
  const change = useChangeReference(projectId, id)
  const remove = useRemoveReference(projectId, id)
  const { data: versions } = useQuery(versionsQuery(projectId, id))
  const { data: openings } = useOpenings(projectId, id)
  const files = useRef<HTMLInputElement>(null)
  const [typed, setTyped, draft] = useDraft(`reference:${projectId}:${id}`, {
    caption: reference.caption,
    terms: reference.terms,
    words: reference.words,
    start: typedSeconds(reference.start_s),
    end: typedSeconds(reference.end_s),
    pin: pinOf(reference),
  })
  const [wrong, setWrong] = useState<{ start?: string; end?: string }>({})
  const plays = version.kind === 'audio' || version.kind === 'video' || version.kind === 'link'
  const save = () => {
    const start = secondsOf(typed.start)
    const end = secondsOf(typed.end)
    const hint = 'Seconds, as in 41.2, or minutes and seconds, as in 0:41.2.'
    setWrong({ start: start === undefined ? hint : undefined, end: end === undefined ? hint : undefined })
    if (start === undefined || end === undefined || change.isPending) return
    const { caption, terms, words, pin } = typed
    change.mutate(
      { caption, terms, words, start_s: start, end_s: end, ...bodyOfPin(pin) },
      {
        onSuccess: () => {
          draft.discard()
          showToast('Reference saved.')
          onClose()
        },
      },
    )
  }
  const text = (name: 'caption' | 'terms' | 'words' | 'start' | 'end') => ({
    value: typed[name],
    onChange: (event: { currentTarget: { value: string } }) =>
      setTyped({ ...typed, [name]: event.currentTarget.value }),
  })
  return (
    <form
      className="grid gap-3"
      noValidate
      onSubmit={(event) => {
        event.preventDefault()
        save()
      }}
    >
      <Textarea label="Caption" rows={2} maxLength={500} data-autofocus {...text('caption')} />
      <TextInput label="Terms" description="Always shown with the reference" maxLength={1000} {...text('terms')} />
      <TextInput
        label="Words"
        description="What it shows, as in: warm, crunchy. Where cues and change requests say so, it can be heard."
        maxLength={200}
        {...text('words')}
      />
      {plays && (
        <div className="grid grid-cols-2 gap-3">
          <TextInput label="From" inputMode="decimal" {...text('start')} error={wrong.start} />
          <TextInput label="To" inputMode="decimal" {...text('end')} error={wrong.end} />
        </div>
      )}
      <PinSelect projectId={projectId} pin={typed.pin} onPin={(pin) => setTyped({ ...typed, pin })} />
      <DraftNote draft={draft} />
      <Refusal error={change.error ?? remove.error} />
      <div className="flex wrap gap-2">
        <Button type="submit" variant="primary" aria-busy={change.isPending}>
          Save
        </Button>
        <Button icon="upload" onClick={() => files.current?.click()}>
          New version
        </Button>
        <input
          ref={files}
          type="file"
          hidden
          aria-label="File of the new version"
          onChange={(event) => {
            if (event.currentTarget.files?.length) onNewVersion(reference, event.currentTarget.files)
            onClose()
          }}
        />
        <Button
          className="end"
          icon="cross"
          onClick={() =>
            remove.mutate(undefined, {
              onSuccess: () => {
                draft.discard()
                showToast('Reference removed from the board.')
                onClose()
              },
            })
          }
        >
          Remove
        </Button>
      </div>
      {(reference.parts ?? 0) > 0 && (
        <p className="small mid">
          {`${plural(reference.parts ?? 0, 'cue was', 'cues were')} spotted from this clip: a new version is shown there too, at the same times.`}
        </p>
      )}
      <section aria-label="Versions">
        <h3>Versions</h3>
        <ul className={`grid gap-1 wrap-anywhere ${classes.lines}`}>
          {versions?.map((item) => (
            <li key={item.id} className="small">
              <span className="strong">{item.number}</span> {item.file_name}
              <span className="dim">
                {' '}
                {kindName(item.kind)}
                {item.file_bytes !== null && `, ${bytes(item.file_bytes)}`}, {item.added_by.name} {ago(item.added_at)}
              </span>
            </li>
          ))}
        </ul>
      </section>
      <section aria-label="Opened by">
        <h3>Opened by</h3>
        <ul className={`grid gap-1 wrap-anywhere ${classes.lines}`}>
          {openings?.pages
            .flatMap(({ items }) => items)
            .map((opening) => (
              <li key={`${opening.person.id} ${opening.opened_at}`} className="small">
                {opening.person.name}, version {opening.version} <span className="dim">{ago(opening.opened_at)}</span>
              </li>
            ))}
          {openings?.pages[0]?.items.length === 0 && <li className="small dim">Nobody has opened it yet.</li>}
        </ul>
      </section>
    </form>
  )
}
