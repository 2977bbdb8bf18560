import { Textarea } from '@mantine/core'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useCallback, useEffect, useRef, useState } from 'react'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { ended } from '@/judging/findings'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Form, Submit, useField } from '@/ui/Form'
import { bytes, bytesOf } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { Refusal } from '@/ui/Refusal'
import {
  ANY_FILE,
  filesOfField,
  partsTransport,
  tusTransport,
  type Upload,
  UploadQueue,
  useLeaveWarning,
  useUploads,
} from '@/uploads'

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

/** Session, layers, plug-ins and recipe of a version: its designer's, and the studio's where the contract says so. */
export function SourceBankCard({ take, isMaker }: { take: Take; isMaker: boolean }) {
  const { data: bank } = useQuery(sourceBankQuery(take.id))
  if (!bank?.is_shown) return null
  const isEmpty = bank.files.length === 0 && bank.plug_ins.length === 0 && !bank.recipe
  if (isEmpty && !isMaker) return null
  const isStudios = bank.is_handed_over && take.state === 'approved'
  return (
    <Card aria-labelledby="source-bank">
      <CardHead id="source-bank" title="Source bank" />
      <div className="stack p-3-inset-14px">
        <p className="small mid">{isMaker ? ownerOf(bank) : 'Handed over by contract. It is in no pack.'}</p>
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

const ownerOf = ({ is_handed_over }: SourceBank): string =>
  is_handed_over
    ? 'Only you see it until this version is approved; then it is the studio’s too. It is in no pack.'
    : 'Only you see it. It is in no pack.'

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
  const [queue] = useState(() => {
    const where = {
      endpoint: '/v1/uploads',
      metadata: ({ file }: Upload) => ({ delivery_id: take.delivery_id, take_id: take.id, file_name: file.name }),
    }
    return new UploadQueue({
      accepts: ANY_FILE,
      atATime: 1,
      transport: partsTransport({ ...where, otherwise: tusTransport(where) }),
      onFinished: async (_, uploadId) => {
        await giveSourceFile(take.id, uploadId)
        await invalidate(client, queryKeys.take(take.id, 'source-bank'))
      },
    })
  })
  useEffect(() => () => queue.dispose(), [queue])
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  const add = useCallback((files: FileList | null) => void queue.add(filesOfField(files ?? [])), [queue])
  return (
    <>
      <input
        ref={field}
        type="file"
        multiple
        hidden
        aria-label="Source files"
        onChange={({ currentTarget }) => {
          add(currentTarget.files)
          currentTarget.value = ''
        }}
      />
      {uploads
        .filter(({ state }) => state !== 'finished')
        .map((upload) => (
          <Going
            key={upload.id}
            upload={upload}
            onEnd={() => (isGoing(upload) ? queue.stop(upload.id) : queue.dismiss(upload.id))}
          />
        ))}
      <span>
        <Button icon="upload" onClick={() => field.current?.click()}>
          Add session or layers
        </Button>
      </span>
    </>
  )
}

const isGoing = ({ state }: Upload): boolean => ['waiting', 'sending', 'line_lost', 'paused'].includes(state)

function Going({ upload, onEnd }: { upload: Upload; onEnd: () => void }) {
  const { file, sentBytes, state, reason } = upload
  if (!isGoing(upload)) {
    if (state === 'stopped') return null
    return <ErrorBanner detail={ended(`${file.name}: ${reason ?? 'it is on its way already'}`)} />
  }
  const here = bytesOf(sentBytes, file.size)
  return (
    <div className={classes.stemDrop}>
      <span className={classes.stemBar}>
        <Meter thin label={file.name} whole={Math.max(1, file.size)} parts={[{ value: sentBytes }]} />
      </span>
      <span className="small mid">
        {state === 'line_lost' ? `Connection lost at ${here}. The upload resumes by itself.` : here}
      </span>
      <Button square variant="quiet" icon="cross" aria-label={`Stop ${file.name}`} onClick={onEnd} />
    </div>
  )
}

function Recipe({ take, bank, mayChange }: { take: Take; bank: SourceBank; mayChange: boolean }) {
  const save = useSetRecipe(take.id)
  const [changing, setChanging] = useState(false)
  if (changing) {
    return (
      <Form
        aria-label="Recipe"
        initialValues={{ plug_ins: bank.plug_ins.join('\n'), recipe: bank.recipe }}
        mutation={save}
        onSubmit={({ plug_ins, recipe }) =>
          save.mutate(
            { plug_ins: plug_ins.split('\n').filter((line) => line.trim()), recipe },
            { onSuccess: () => setChanging(false) },
          )
        }
      >
        <Lines name="plug_ins" label="Plug-ins, one a line" />
        <Lines name="recipe" label="Recipe" />
        <Submit
          beside={
            <Button variant="quiet" onClick={() => setChanging(false)}>
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
      {bank.recipe && <p className={classes.recipe}>{bank.recipe}</p>}
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

function Lines({ name, label }: { name: string; label: string }) {
  const { fieldKey, props } = useField(name)
  return <Textarea key={fieldKey} {...props} label={label} rows={4} />
}
