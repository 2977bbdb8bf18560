import { NativeSelect, NumberInput, Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type ChangeEvent, useState } from 'react'

import { meQuery, useMyProject } from '@/api/me'
import { post, put, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import { formDraft, keepDraft, keptDraft } from '@/app/drafts'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Field, Form, Submit } from '@/ui/Form'
import { bytes, day } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'

import { type CueDetail, type Handoff, handoffsQuery, type Version } from '../api'
import { cuePeopleQuery } from '../people'
import classes from './Cue.module.css'

const draftKeyOf = (cueId: string): string => `handoff:${cueId}`

interface HandoffsProps {
  cue: CueDetail
  projectId: string
  versions: readonly Version[]
}

/** Who left the cue to whom, how far it was and what is missing; a maker and a producer can hand it off. */
export function Handoffs({ cue, projectId, versions }: HandoffsProps) {
  const { data: me } = useQuery(meQuery)
  const project = useMyProject(projectId)
  const { data: handoffs, error } = useQuery(handoffsQuery(cue.id))
  const [writing, setWriting] = useState(() => keptDraft(draftKeyOf(cue.id)) !== null)
  const isProducer = project?.is_producer ?? false
  const maker = isProducer
    ? versions[0]?.take.designer
    : versions.map(({ take }) => take.designer).find(({ id }) => id === me?.person.id)
  if (!handoffs || (handoffs.length === 0 && !maker)) return <Refusal inset error={error} />
  return (
    <Card aria-labelledby="handoffs">
      <CardHead id="handoffs" title="Hand-off" count={handoffs.length || undefined} />
      <div className="stack p-3-inset-4">
        {handoffs.map((handoff) => (
          <HandoffLine key={handoff.id} handoff={handoff} projectId={projectId} mayName={isProducer} />
        ))}
        {writing && maker ? (
          <HandoffForm
            cueId={cue.id}
            makerId={isProducer ? maker.id : null}
            makerName={maker.name}
            onClose={() => setWriting(false)}
          />
        ) : (
          maker && (
            <span>
              <Button onClick={() => setWriting(true)}>Hand off this cue</Button>
            </span>
          )
        )}
      </div>
    </Card>
  )
}

interface HandoffLineProps {
  handoff: Handoff
  projectId: string
  mayName: boolean
}

function HandoffLine({ handoff, projectId, mayName }: HandoffLineProps) {
  const { id, maker, next_maker, done_percent, missing, written_by, created_at, closed, takes } = handoff
  return (
    <article className="stack" aria-label={`Hand-off by ${maker.name}, ${day(created_at)}`}>
      <p>
        <span className="strong">{done_percent} % done</span>{' '}
        <span className="small dim">
          by {maker.name}, {day(created_at)}
          {written_by.id !== maker.id && `, written by ${written_by.name}`}
        </span>
      </p>
      <p className={`pre-line wrap-anywhere ${classes.description}`}>Missing: {missing}</p>
      <p className="small mid">
        {next_maker
          ? `${next_maker.name} continues it.`
          : 'Nobody continues it yet. A producer names the next designer.'}
      </p>
      {closed !== null && <ErrorBanner detail={`Its files cannot be downloaded now: ${closed}.`} />}
      <ul className="stack">
        {takes.map((take) => (
          <li key={take.id}>
            <p className="row small">
              <span className="wrap-anywhere">
                <span className="mono">{take.file_name}</span>
                {versionOf(take)}
              </span>
              {closed === null && (
                <ButtonLink
                  square
                  variant="quiet"
                  icon="download"
                  href={`/v1/handoffs/${id}/takes/${take.id}/master`}
                  download
                  aria-label={`Download ${take.file_name}${versionOf(take)}`}
                />
              )}
            </p>
            {take.source_files.map((file) => (
              <p key={file.id} className="row small">
                <span className="wrap-anywhere">
                  <span className="mono">{file.file_name}</span>, {file.kind}, {bytes(file.file_bytes)}
                </span>
                {closed === null && (
                  <ButtonLink
                    square
                    variant="quiet"
                    icon="download"
                    href={`/v1/handoffs/${id}/source-files/${file.id}`}
                    download
                    aria-label={`Download ${file.file_name}`}
                  />
                )}
              </p>
            ))}
            {take.plug_ins.length > 0 && <p className="small mid">Plug-ins: {take.plug_ins.join(', ')}</p>}
            {take.recipe && <p className="small mid pre-line">{take.recipe}</p>}
          </li>
        ))}
      </ul>
      {mayName && <NextMaker handoff={handoff} projectId={projectId} />}
    </article>
  )
}

/** Sets files of one name apart. */
const versionOf = ({ number }: Handoff['takes'][number]): string => (number === null ? '' : `, version ${number}`)

function NextMaker({ handoff, projectId }: { handoff: Handoff; projectId: string }) {
  const { data: people } = useQuery(cuePeopleQuery(projectId))
  const setNextMaker = useMutation({
    mutationFn: (designerId: string) =>
      put('/v1/handoffs/{handoff_id}/next-maker', { handoff_id: handoff.id }, { designer_id: designerId }),
    affects: [queryKeys.handoffs(handoff.cue_id)],
  })
  const designers = (people ?? []).filter(({ id, is_designer }) => is_designer && id !== handoff.maker.id)
  if (designers.length === 0) {
    return <p className="small dim">Invite another designer to the project, and name them here.</p>
  }
  return (
    <>
      <NativeSelect
        label="Continued by"
        value={handoff.next_maker?.id ?? ''}
        disabled={setNextMaker.isPending}
        data={[
          { value: '', label: 'Choose a designer', disabled: true },
          ...designers.map((person) => ({ value: person.id, label: person.name })),
        ]}
        onChange={({ currentTarget }: ChangeEvent<HTMLSelectElement>) => setNextMaker.mutate(currentTarget.value)}
      />
      <Refusal error={setNextMaker.error} />
    </>
  )
}

interface HandoffFormProps {
  cueId: string
  /** Where a producer writes it. */
  makerId: string | null
  makerName: string
  onClose: () => void
}

function HandoffForm({ cueId, makerId, makerName, onClose }: HandoffFormProps) {
  const save = useMutation({
    mutationFn: (body: { done_percent: number; missing: string; from_id: string | null }) =>
      post('/v1/cues/{cue_id}/handoffs', { cue_id: cueId }, body),
    affects: [queryKeys.handoffs(cueId)],
  })
  const draftKey = draftKeyOf(cueId)
  const close = () => {
    keepDraft(draftKey, null)
    onClose()
  }
  return (
    <Form
      aria-label="Hand off this cue"
      {...formDraft(draftKey, { done_percent: 50, missing: '' })}
      mutation={save}
      onSubmit={(values) => save.mutate({ ...values, from_id: makerId }, { onSuccess: close })}
    >
      <p className="small mid">
        {makerId === null
          ? 'Whoever continues it sees your versions of this cue and their source banks.'
          : `Whoever continues it sees the versions of ${makerName}, and the source banks that the contract hands over.`}
      </p>
      <Field as={NumberInput} name="done_percent" label="Done, in percent" min={0} max={100} />
      <Field as={Textarea} name="missing" label="What is missing" rows={3} />
      <Submit
        beside={
          <Button variant="quiet" onClick={close}>
            Cancel
          </Button>
        }
      >
        Hand off
      </Submit>
    </Form>
  )
}
