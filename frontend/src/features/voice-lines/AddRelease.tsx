import { Autocomplete, NativeSelect } from '@mantine/core'
import { useRef, useState } from 'react'

import { DraftForm } from '@/app/drafts/DraftForm'
import { Button } from '@/ui/Button'
import { Field, Submit } from '@/ui/Form'
import { Meter } from '@/ui/Meter'

import { filesOfField, useLeaveWarning, useUploads } from '@/uploads'

import type { ReleaseAdd } from './api'
import type { ReleaseUploads } from './releaseUploads'
import classes from './VoiceLines.module.css'

const EMPTY = {
  performer: '',
  validFrom: '',
  validUntil: '',
  syntheticUse: 'not_asked' as ReleaseAdd['synthetic_use'],
  note: '',
}

const SYNTHETIC_USES = [
  { value: 'not_asked', label: 'Not asked' },
  { value: 'no', label: 'No' },
  { value: 'yes', label: 'Yes' },
]

interface AddReleaseProps {
  projectId: string
  performers: readonly string[]
  uploads: ReleaseUploads
}

/** A signed release: whose, from when to when, what it says of synthetic use, and the file. */
export function AddRelease({ projectId, performers, uploads }: AddReleaseProps) {
  const picker = useRef<HTMLInputElement>(null)
  const [release, setRelease] = useState<{ typed: typeof EMPTY; onSent: () => void } | null>(null)
  const send = (files: FileList | null) => {
    if (!files?.length || !release) return
    const { performer, validFrom, validUntil, syntheticUse, note } = release.typed
    void uploads.add(filesOfField(files).slice(0, 1), {
      performer,
      valid_from: validFrom,
      valid_until: validUntil || null,
      synthetic_use: syntheticUse,
      note,
    })
    release.onSent()
  }
  return (
    <DraftForm
      draftKey={`release:${projectId}`}
      className={`grid items-end gap-2-3 ${classes.casting}`}
      aria-label="Add a release"
      initialValues={EMPTY}
      mutation={{ isPending: false, error: null }}
      checks={({ validFrom, validUntil }) => ({
        validUntil: validUntil !== '' && validUntil < validFrom && 'The last day is before the first.',
      })}
      onSubmit={(typed, onSent) => {
        setRelease({ typed, onSent })
        picker.current?.click()
      }}
    >
      <Field as={Autocomplete} name="performer" label="Performer" maxLength={120} data={[...performers]} />
      <Field name="validFrom" label="Valid from" type="date" />
      <Field optional name="validUntil" label="Expires (optional)" type="date" />
      <Field as={NativeSelect} name="syntheticUse" label="Synthetic use" data={SYNTHETIC_USES} />
      <Field optional name="note" label="Note" maxLength={2000} />
      <Submit variant="plain" icon="upload">
        Choose the signed file
      </Submit>
      <input
        ref={picker}
        type="file"
        hidden
        aria-label="File of the release"
        onChange={(event) => {
          send(event.currentTarget.files)
          event.currentTarget.value = ''
        }}
      />
      <Uploading uploads={uploads} />
    </DraftForm>
  )
}

function Uploading({ uploads: { queue } }: { uploads: ReleaseUploads }) {
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  if (uploads.length === 0) return null
  return (
    <ul className="col-span-full" aria-label="Uploads">
      {uploads.map(({ id, file, state, sentBytes, reason }) => (
        <li key={id} className="flex wrap items-center gap-1-3 wrap-anywhere">
          <span className="mono">{file.name}</span>
          {['sending', 'waiting', 'paused', 'line_lost'].includes(state) ? (
            <Meter thin label={file.name} whole={Math.max(1, file.size)} parts={[{ value: sentBytes }]} />
          ) : (
            <span className="small tone-bad toned">{reason ?? 'Not filed.'}</span>
          )}
          <Button
            square
            variant="quiet"
            icon="cross"
            aria-label={`Remove ${file.name} from the list`}
            onClick={() => queue.dismiss(id)}
          />
        </li>
      ))}
    </ul>
  )
}
