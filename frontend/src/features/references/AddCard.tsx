import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'

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
  const add = useAddLink(projectId)
  return (
    <Card aria-labelledby="add-references">
      <CardHead id="add-references" title="Add" note="Drop files anywhere on this page, or paste a link" />
      <DraftForm
        draftKey={`reference:${projectId}`}
        className={`grid gap-3 ${classes.add}`}
        initialValues={{ url: '', caption: '', terms: '' }}
        mutation={add}
        onSubmit={(typed, onSent) =>
          add.mutate(
            { ...typed, url: typed.url.trim(), ...bodyOfPin(pin) },
            {
              onSuccess: () => {
                onSent()
                showToast('Link added to the board.')
              },
            },
          )
        }
      >
        {({ url }) => (
          <>
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
            <Field name="url" label="Link" type="url" placeholder="https://" maxLength={2000} id="reference-link" />
            {url !== '' && (
              <>
                <Field optional name="caption" label="Caption" placeholder="What matters in it" maxLength={500} />
                <Field
                  optional
                  name="terms"
                  label="Terms"
                  placeholder="Licensed original: may not be shipped"
                  maxLength={1000}
                />
                <Submit>Add link</Submit>
              </>
            )}
          </>
        )}
      </DraftForm>
    </Card>
  )
}
