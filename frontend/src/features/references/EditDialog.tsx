import { Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useRef } from 'react'

import { Dialog } from '@/app/Dialog'
import { keepDraft } from '@/app/drafts'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { kindName, type Reference, titleOf } from '@/references'
import { Button } from '@/ui/Button'
import { Field, Submit } from '@/ui/Form'
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

const SECONDS_HINT = 'Seconds, as in 41.2, or minutes and seconds, as in 0:41.2.'
const typedSeconds = (s: number | null): string => (s === null ? '' : String(s))

function Edit({ reference, onNewVersion, onClose }: EditDialogProps & { reference: Reference }) {
  const { id, project_id: projectId, version } = reference
  const change = useChangeReference(projectId, id)
  const remove = useRemoveReference(projectId, id)
  const { data: versions } = useQuery(versionsQuery(projectId, id))
  const { data: openings } = useOpenings(projectId, id)
  const files = useRef<HTMLInputElement>(null)
  const plays = version.kind === 'audio' || version.kind === 'video' || version.kind === 'link'
  const draftKey = `reference:${projectId}:${id}`
  return (
    <div className="grid gap-3">
      <DraftForm
        draftKey={draftKey}
        className="grid gap-3"
        initialValues={{
          caption: reference.caption,
          terms: reference.terms,
          words: reference.words,
          start: typedSeconds(reference.start_s),
          end: typedSeconds(reference.end_s),
          pin: pinOf(reference),
        }}
        mutation={{ isPending: change.isPending, error: change.error ?? remove.error }}
        checks={({ start, end }) => ({
          start: secondsOf(start) === undefined && SECONDS_HINT,
          end: secondsOf(end) === undefined && SECONDS_HINT,
        })}
        onSubmit={({ caption, terms, words, start, end, pin }, onSent) =>
          change.mutate(
            {
              caption,
              terms,
              words,
              start_s: secondsOf(start) ?? null,
              end_s: secondsOf(end) ?? null,
              ...bodyOfPin(pin),
            },
            {
              onSuccess: () => {
                onSent()
                showToast('Reference saved.')
                onClose()
              },
            },
          )
        }
      >
        {({ pin }, set) => (
          <>
            <Field as={Textarea} optional name="caption" label="Caption" rows={2} maxLength={500} data-autofocus />
            <Field optional name="terms" label="Terms" description="Always shown with the reference" maxLength={1000} />
            <Field
              optional
              name="words"
              label="Words"
              description="What it shows, as in: warm, crunchy. Where cues and change requests say so, it can be heard."
              maxLength={200}
            />
            {plays && (
              <div className="grid grid-cols-2 gap-3">
                <Field optional name="start" label="From" inputMode="decimal" />
                <Field optional name="end" label="To" inputMode="decimal" />
              </div>
            )}
            <PinSelect projectId={projectId} pin={pin} onPin={(pin) => set({ pin })} />
            <Submit
              className="flex wrap gap-2"
              beside={
                <>
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
                          keepDraft(draftKey, null)
                          showToast('Reference removed from the board.')
                          onClose()
                        },
                      })
                    }
                  >
                    Remove
                  </Button>
                </>
              }
            >
              Save
            </Submit>
          </>
        )}
      </DraftForm>
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
    </div>
  )
}
