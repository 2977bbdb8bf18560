import { Autocomplete, TextInput } from '@mantine/core'
import { useRef, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Meter } from '@/ui/Meter'
import { Select } from '@/ui/Select'
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

interface AddReleaseProps {
  projectId: string
  performers: readonly string[]
  uploads: ReleaseUploads
}

/** A signed release: whose, from when to when, what it says of synthetic use, and the file. */
export function AddRelease({ projectId, performers, uploads }: AddReleaseProps) {
  const [typed, setTyped, draft] = useDraft(`release:${projectId}`, EMPTY)
  const [wrong, setWrong] = useState<{ performer?: string; validFrom?: string; validUntil?: string }>({})
  const picker = useRef<HTMLInputElement>(null)
  const choose = () => {
    const parsed = {
      performer: typed.performer.trim() === '' ? 'Enter the name of the performer.' : undefined,
      validFrom: typed.validFrom === '' ? 'Enter the first day.' : undefined,
      validUntil:
        typed.validUntil !== '' && typed.validUntil < typed.validFrom ? 'The last day is before the first.' : undefined,
    }
    setWrong(parsed)
    if (Object.values(parsed).every((value) => value === undefined)) picker.current?.click()
  }
  const send = (files: FileList | null) => {
    if (!files?.length) return
    const { performer, validFrom, validUntil, syntheticUse, note } = typed
    void uploads.add(filesOfField(files).slice(0, 1), {
      performer,
      valid_from: validFrom,
      valid_until: validUntil || null,
      synthetic_use: syntheticUse,
      note,
    })
    draft.discard()
  }
  const text = (name: 'validFrom' | 'validUntil' | 'note') => ({
    value: typed[name],
    onChange: (event: { currentTarget: { value: string } }) =>
      setTyped({ ...typed, [name]: event.currentTarget.value }),
  })
  return (
    <form
      className={`grid items-end gap-2-3 ${classes.casting}`}
      noValidate
      aria-label="Add a release"
      onSubmit={(event) => {
        event.preventDefault()
        choose()
      }}
    >
      <Autocomplete
        label="Performer"
        maxLength={120}
        data={[...performers]}
        value={typed.performer}
        error={wrong.performer}
        onChange={(performer) => setTyped({ ...typed, performer })}
      />
      <TextInput label="Valid from" type="date" error={wrong.validFrom} {...text('validFrom')} />
      <TextInput label="Expires (optional)" type="date" error={wrong.validUntil} {...text('validUntil')} />
      <Select
        label="Synthetic use"
        value={typed.syntheticUse}
        onChange={(event) =>
          setTyped({ ...typed, syntheticUse: event.currentTarget.value as ReleaseAdd['synthetic_use'] })
        }
      >
        <option value="not_asked">Not asked</option>
        <option value="no">No</option>
        <option value="yes">Yes</option>
      </Select>
      <TextInput label="Note" maxLength={2000} {...text('note')} />
      <Button type="submit" icon="upload">
        Choose the signed file
      </Button>
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
      <DraftNote draft={draft} />
      <Uploading uploads={uploads} />
    </form>
  )
}

function Uploading({ uploads: { queue } }: { uploads: ReleaseUploads }) {
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  if (uploads.length === 0) return null
  return (
    <ul className={classes.uploads} aria-label="Uploads">
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
