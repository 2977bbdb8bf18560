import { TextInput } from '@mantine/core'
import { useRef } from 'react'

import { ApiProblem } from '@/api'
import { DraftNote, useDraft } from '@/app/drafts'
import { sentence } from '@/ui/sentence'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'

import { useAddLink } from './api'
import { bodyOfPin, type Pin } from './pins'
import { PinSelect } from './PinSelect'
import classes from './Board.module.css'

interface AddCardProps {
  projectId: string
  pin: Pin
  onPin: (pin: Pin) => void
  onFiles: (files: FileList) => void
  /** The field for files, which a key opens too. */
  fileField: React.RefObject<HTMLInputElement | null>
}

/** Files, or a link, for the board: with what they are for. */
export function AddCard({ projectId, pin, onPin, onFiles, fileField }: AddCardProps) {
  const [typed, setTyped, draft] = useDraft(`reference:${projectId}`, { url: '', caption: '', terms: '' })
  const add = useAddLink(projectId)
  const urlField = useRef<HTMLInputElement>(null)
  const refusal = add.error instanceof ApiProblem ? add.error : null
  const against = (name: string) => {
    const message = refusal?.of(name)?.message
    return message && sentence(message)
  }
  const send = () => {
    if (typed.url.trim() === '') {
      urlField.current?.focus()
      return
    }
    add.mutate(
      { ...typed, url: typed.url.trim(), ...bodyOfPin(pin) },
      {
        onSuccess: () => {
          draft.discard()
          showToast('Link added to the board.')
        },
      },
    )
  }
  const field = (name: 'url' | 'caption' | 'terms') => ({
    value: typed[name],
    onChange: (event: { currentTarget: { value: string } }) =>
      setTyped({ ...typed, [name]: event.currentTarget.value }),
    error: against(name),
  })
  return (
    <Card aria-labelledby="add-references">
      <CardHead id="add-references" title="Add" note="Drop files anywhere on this page, or paste a link" />
      <form
        className={`grid gap-3 ${classes.add}`}
        noValidate
        onSubmit={(event) => {
          event.preventDefault()
          if (!add.isPending) send()
        }}
      >
        <div className="flex wrap items-end gap-3">
          <PinSelect projectId={projectId} pin={pin} onPin={onPin} />
          <Button icon="upload" keys="n" onClick={() => fileField.current?.click()}>
            Add files
          </Button>
          <input
            ref={fileField}
            type="file"
            multiple
            hidden
            aria-label="Files to add"
            onChange={(event) => {
              if (event.currentTarget.files) onFiles(event.currentTarget.files)
              event.currentTarget.value = ''
            }}
          />
        </div>
        <TextInput
          label="Link"
          type="url"
          placeholder="https://"
          maxLength={2000}
          ref={urlField}
          id="reference-link"
          {...field('url')}
        />
        {typed.url !== '' && (
          <>
            <TextInput label="Caption" placeholder="What matters in it" maxLength={500} {...field('caption')} />
            <TextInput
              label="Terms"
              placeholder="Licensed original: may not be shipped"
              maxLength={1000}
              {...field('terms')}
            />
            <Button type="submit" variant="primary" aria-busy={add.isPending}>
              Add link
            </Button>
          </>
        )}
        <DraftNote draft={draft} />
        {refusal && refusal.errors.length === 0 && (
          <p role="alert" className="tone-bad toned">
            {sentence(refusal.detail)}
          </p>
        )}
      </form>
    </Card>
  )
}
