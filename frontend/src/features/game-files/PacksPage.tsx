import { Checkbox, Select, Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { useMyProject } from '@/api/me'
import { DraftNote, useDraft } from '@/app/drafts'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ClearanceLinks } from '@/ui/ClearanceLinks'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, day, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { ShowMore } from '@/ui/ShowMore'
import { StatusBadge } from '@/ui/StatusBadge'
import { sentence } from '@/ui/sentence'

import {
  type Changes,
  type Handoff,
  packQuery,
  type SealedPack,
  targetsQuery,
  useSealedPack,
  useSealedPacks,
  useSealPack,
} from './api'
import classes from './Files.module.css'
import { PullCard } from './PullCard'
import { changesInWords, HANDOFFS } from './words'

/** The packs that were handed out, and the next one. */
export function PacksPage() {
  useTitle('Packs')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/packs' })
  const pages = useSealedPacks(projectId)
  const { data, error } = pages
  const { data: known } = useQuery(targetsQuery(projectId))
  const isProducer = useMyProject(projectId)?.is_producer ?? false
  const packs = data?.pages.flatMap(({ items }) => items)
  const names = known?.targets.map(({ name }) => name) ?? []
  return (
    <div className="page stack">
      <PageHead title="Packs">
        A sealed pack never changes: everyone who downloads it, including the game’s CI, gets the same bytes. Unchanged
        sounds keep their file from the previous pack.{' '}
        <Link className="link" to="/projects/$projectId" params={{ projectId }}>
          Project
        </Link>
        {' · '}
        <Link className="link" to="/projects/$projectId/game-files" params={{ projectId }}>
          Targets, memory and batches
        </Link>
        {' · '}
        <Link className="link" to="/projects/$projectId/libraries" params={{ projectId }}>
          Sound libraries
        </Link>
      </PageHead>
      <div className="columns">
        <Card aria-labelledby="packs">
          <CardHead id="packs" title="Sealed packs" note="newest first" />
          <Refusal inset error={error} />
          {packs?.length === 0 && (
            <div className="p-3-inset">
              <EmptyState head="No packs yet" level={3}>
                Choose a target and seal the accepted sounds. The pack gets a number, checksums and a documentation key.
              </EmptyState>
            </div>
          )}
          <ul>
            {packs?.map((pack) => (
              <PackLine key={pack.id} pack={pack} isProducer={isProducer} />
            ))}
          </ul>
          {pages.hasNextPage && (
            <div className="p-3-inset">
              <ShowMore list={pages}>Earlier packs</ShowMore>
            </div>
          )}
        </Card>
        <div className="stack">
          {names.length > 0 && <SealCard projectId={projectId} targets={names} />}
          {names.length > 0 && <PullCard projectId={projectId} targets={names} />}
        </div>
      </div>
    </div>
  )
}

function PackLine({ pack, isProducer }: { pack: SealedPack; isProducer: boolean }) {
  const [isOpen, setOpen] = useState(false)
  const { data } = useSealedPack(pack.id, isOpen && pack.state === 'sealed')
  const title = `${pack.target} ${pack.number}`
  return (
    <li className="grid grid-cols-1 gap-6px border-b p-3-inset" aria-label={`Pack ${title}`}>
      <p className="row wrap">
        <span className="strong">{title}</span>
        {(pack.state === 'sealed' ? pack.placeholder_files > 0 : pack.placeholders) && (
          <StatusBadge kind="placeholder">With placeholders</StatusBadge>
        )}
        {pack.state === 'sealing' && <StatusBadge kind="checking">Being built</StatusBadge>}
        {pack.state === 'refused' && <StatusBadge kind="refused" />}
        {pack.state === 'sealed' && (
          <span className="mid">
            {[
              plural(pack.files, 'file'),
              pack.placeholder_files > 0 && plural(pack.placeholder_files, 'placeholder'),
              bytes(pack.bytes),
            ]
              .filter(Boolean)
              .join(', ')}
          </span>
        )}
        <span className="end">
          {pack.state === 'sealed' && (
            <ButtonLink href={`/v1/packs/${pack.id}/pack.zip`} download aria-label={`Download pack ${title}`}>
              Download
            </ButtonLink>
          )}
        </span>
      </p>
      <p className="small mid">
        Sealed by {pack.sealed_by}{' '}
        <time dateTime={pack.created_at} title={day(pack.created_at)}>
          {ago(pack.created_at)}
        </time>
        {pack.with_masters && ', with masters'}
        {pack.handoff !== 'none' && `, for ${HANDOFFS[pack.handoff].label}`}.{pack.note && ` “${pack.note}”`}
      </p>
      {pack.state === 'sealed' && isProducer && <ClearanceLinks path={`/v1/packs/${pack.id}`} of={title} />}
      {pack.state === 'refused' && <p className="small">{sentence(pack.refusal)}</p>}
      {pack.state === 'sealed' && (
        <details className="small" onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
          <summary className="pointer min-h-24px">
            What changed<span className="visually-hidden"> in pack {title}</span>
          </summary>
          {data && <ChangesList changes={data.changes} />}
        </details>
      )}
    </li>
  )
}

const KINDS = { new: 'new', changed: 'changed', gone: 'gone' } as const

function ChangesList({ changes }: { changes: Changes }) {
  return (
    <>
      <p className="mid">{sentence(changesInWords(changes))}</p>
      {changes.since !== null && changes.paths.length > 0 && (
        <ul className={classes.paths}>
          {changes.paths.map(({ path, kind }) => (
            <li key={path}>
              <span className="dim">{KINDS[kind]}</span> <span className="mono">{path}</span>
            </li>
          ))}
        </ul>
      )}
    </>
  )
}

function SealCard({ projectId, targets }: { projectId: string; targets: readonly string[] }) {
  const [typed, setTyped, draft] = useDraft(`next-pack:${projectId}`, {
    target: targets[0] ?? '',
    note: '',
    masters: false,
    placeholders: false,
    handoff: null as Handoff | null,
    allow_missing: false,
  })
  const { data: pack } = useQuery(packQuery(projectId, typed.target))
  const seal = useSealPack(projectId)
  const handoff = typed.handoff ?? pack?.handoff ?? 'none' // that of the target's last pack, until another is chosen
  const missing = pack?.missing.length ?? 0
  return (
    <Card aria-labelledby="seal">
      <CardHead id="seal" title="Next pack" />
      <Form
        className="grid gap-3 p-inset"
        initialValues={typed}
        values={typed}
        onValuesChange={setTyped}
        mutation={seal}
        onSubmit={(body) => seal.mutate({ ...body, handoff }, { onSuccess: draft.discard })}
      >
        <DraftNote draft={draft} />
        <Field as={Select} name="target" label="Target" data={[...targets]} allowDeselect={false} />
        {pack && (
          <p className="small mid" role="status">
            {pack.cues_accepted === 0
              ? 'Nothing is accepted yet.'
              : sentence(`${plural(pack.files, 'file')}, ${bytes(pack.bytes)}; ${changesInWords(pack.changes)}`)}
          </p>
        )}
        <Field
          as={Textarea}
          optional
          name="note"
          label="Note"
          description="What it is for (shown to the studio in this list)."
          maxLength={2000}
          rows={2}
        />
        <Select
          label="Import files for"
          description={HANDOFFS[handoff].does}
          data={Object.entries(HANDOFFS).map(([value, { label }]) => ({ value, label }))}
          value={handoff}
          onChange={(engine) => engine && setTyped({ ...typed, handoff: engine as Handoff })}
          allowDeselect={false}
        />
        <Field as={Checkbox} name="masters" label="With masters" />
        <Field
          as={Checkbox}
          name="placeholders"
          label="With placeholders for sounds that are not accepted"
          description="Placeholders are marked; the game’s CI refuses them."
        />
        {missing > 0 && (
          <Field
            as={Checkbox}
            name="allow_missing"
            label={`Without ${plural(missing, 'accepted file')} that could not be rendered`}
          />
        )}
        <Submit>Seal pack</Submit>
      </Form>
    </Card>
  )
}
