import { Textarea } from '@mantine/core'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useRef, useState } from 'react'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { formDraft, keepDraft, keptDraft } from '@/app/drafts'
import { ended } from '@/verdicts/findings'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Field, Form, Submit } from '@/ui/Form'
import { bytes } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { ANY_FILE, filesOfField, isGoing, type Upload, type UploadQueue } from '@/uploads'

import {
  giveSourceFile,
  type SourceBank,
  sourceBankQuery,
  type SourceFile,
  type Take,
  useRemoveSourceFile,
  useSetRecipe,
} from './api'
import classes from './Take.module.css'
import { UploadProgress, useTakeUploads } from './takeUploads'

/** Session, layers, plug-ins and recipe of a version: its designer's, and the studio's where the contract says so. */
export function SourceBankCard({ take, isMaker }: { take: Take; isMaker: boolean }) {
  const { data: bank, error } = useQuery(sourceBankQuery(take.id))
  if (!bank?.is_shown) return <Refusal inset error={error} />
  const isEmpty = bank.files.length === 0 && bank.plug_ins.length === 0 && !bank.recipe
  if (isEmpty && !isMaker) return null
  const isStudios = bank.is_handed_over && take.state === 'approved'
  return (
    <Card aria-labelledby="source-bank">
      <CardHead id="source-bank" title="Source bank" />
      <div className="stack p-3-inset-14px">
        <p className="small mid">
          {isMaker ? readersOf(bank) : 'It was handed over to the studio. No pack for the game contains it.'}
        </p>
        {bank.files.length > 0 && (
          <ul className={classes.files}>
            {bank.files.map((file) => (
              <File key={file.id} take={take} file={file} mayRemove={isMaker && !isStudios} />
            ))}
          </ul>
        )}
        {isMaker && <AddFiles take={take} />}
        <Recipe take={take} bank={bank} mayChange={isMaker} />
      </div>
    </Card>
  )
}

const readersOf = ({ is_handed_over }: SourceBank): string =>
  is_handed_over
    ? 'Only you, and a designer to whom you hand off the cue, can see it until this version is approved. Then the studio can see it too, and pass it on. No pack for the game contains it.'
    : 'Only you, and a designer to whom you hand off the cue, can see it. No pack for the game contains it.'

function File({ take, file, mayRemove }: { take: Take; file: SourceFile; mayRemove: boolean }) {
  const { mutate, isPending, error } = useRemoveSourceFile(take.id)
  return (
    <li>
      <span>
        <span className="mono">{file.file_name}</span>{' '}
        <span className="small dim">
          {file.kind}, {bytes(file.file_bytes)}
        </span>
      </span>
      <span className="row">
        <ButtonLink
          square
          variant="quiet"
          href={`/v1/source-files/${file.id}`}
          download
          icon="download"
          aria-label={`Download ${file.file_name}`}
        />
        {mayRemove && (
          <Button
            square
            variant="quiet"
            icon="cross"
            aria-label={`Remove ${file.file_name}`}
            disabled={isPending}
            onClick={() => mutate(file.id)}
          />
        )}
      </span>
      <Refusal error={error} />
    </li>
  )
}

/** Takes session and layers, and carries them whatever the line does. */
function AddFiles({ take }: { take: Take }) {
  const client = useQueryClient()
  const field = useRef<HTMLInputElement>(null)
  const { queue, uploads } = useTakeUploads(take, ANY_FILE, async (uploadId) => {
    await giveSourceFile(take.id, uploadId)
    await invalidate(client, queryKeys.take(take.id, 'source-bank'))
  })
  return (
    <>
      <input
        ref={field}
        type="file"
        multiple
        hidden
        aria-label="Source files"
        onChange={({ currentTarget }) => {
          void queue.add(filesOfField(currentTarget.files ?? []))
          currentTarget.value = ''
        }}
      />
      {uploads.map((upload) => (
        <UploadLine key={upload.id} upload={upload} queue={queue} />
      ))}
      <span>
        <Button icon="upload" onClick={() => field.current?.click()}>
          Add session or layers
        </Button>
      </span>
    </>
  )
}

function UploadLine({ upload, queue }: { upload: Upload; queue: UploadQueue }) {
  const { id, file, state, reason } = upload
  if (state === 'finished' || state === 'stopped') return null
  if (!isGoing(upload)) {
    return <ErrorBanner detail={ended(`${file.name}: ${reason ?? 'it is on its way already'}`)} />
  }
  return (
    <div className={`flex wrap items-center gap-2-3 p-3 rounded ${classes.stemDrop}`}>
      <UploadProgress upload={upload} onStop={() => queue.stop(id)} />
    </div>
  )
}

function Recipe({ take, bank, mayChange }: { take: Take; bank: SourceBank; mayChange: boolean }) {
  const save = useSetRecipe(take.id)
  const draftKey = `recipe:${take.id}`
  const [changing, setChanging] = useState(() => keptDraft(draftKey) !== null)
  const close = () => {
    keepDraft(draftKey, null)
    setChanging(false)
  }
  if (changing) {
    return (
      <Form
        aria-label="Recipe"
        {...formDraft(draftKey, { plug_ins: bank.plug_ins.join('\n'), recipe: bank.recipe })}
        mutation={save}
        onSubmit={({ plug_ins, recipe }) =>
          save.mutate({ plug_ins: plug_ins.split('\n').filter((line) => line.trim()), recipe }, { onSuccess: close })
        }
      >
        <Field as={Textarea} optional rows={4} name="plug_ins" label="Plug-ins, one a line" />
        <Field as={Textarea} optional rows={4} name="recipe" label="Recipe" />
        <Submit
          beside={
            <Button variant="quiet" onClick={close}>
              Cancel
            </Button>
          }
        >
          Save recipe
        </Submit>
      </Form>
    )
  }
  const isEmpty = bank.plug_ins.length === 0 && !bank.recipe
  return (
    <>
      {bank.plug_ins.length > 0 && <p className="small">Plug-ins: {bank.plug_ins.join(', ')}</p>}
      {bank.recipe && <p className="pre-wrap wrap-anywhere">{bank.recipe}</p>}
      {mayChange && (
        <span>
          <Button icon="pencil" onClick={() => setChanging(true)}>
            {isEmpty ? 'Write recipe' : 'Change recipe'}
          </Button>
        </span>
      )}
    </>
  )
}
