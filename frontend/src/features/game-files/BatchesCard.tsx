import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ago, day, figure } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { ShowMore } from '@/ui/ShowMore'
import { Table } from '@/ui/Table'
import { sentence } from '@/ui/sentence'

import { type Batch, type BatchSizes, useBatch, useBatches, useBeginBatch, useCancelBatch } from './api'
import classes from './Files.module.css'
import { progressOf, signed, sizeOf, totalsOf } from './words'

/** A re-render of all game files: its progress, its effect on the sizes, and a button to cancel it. */
export function BatchesCard({ projectId, maySpeak }: { projectId: string; maySpeak: boolean }) {
  const list = useBatches(projectId)
  const { data, error } = list
  const begin = useBeginBatch(projectId)
  const batches = data?.pages.flatMap(({ items }) => items)
  return (
    <Card aria-labelledby="batches">
      <CardHead
        id="batches"
        title="Re-renders"
        note="earlier files are kept"
        end={
          maySpeak && (
            <Button disabled={begin.isPending} onClick={() => begin.mutate([])}>
              Re-render all game files
            </Button>
          )
        }
      />
      <Refusal inset error={error ?? begin.error} />
      {batches?.length === 0 && (
        <div className="p-3-inset">
          <EmptyState head="No re-renders yet" level={3}>
            When you change the spec or add a target, all accepted and conforming versions are rendered again. Uploads
            are checked first.
          </EmptyState>
        </div>
      )}
      <ul>
        {batches?.map((batch, at) => (
          <BatchLine key={batch.id} batch={batch} projectId={projectId} maySpeak={maySpeak} opened={at === 0} />
        ))}
      </ul>
      {list.hasNextPage && (
        <div className="p-3-inset">
          <ShowMore list={list}>Earlier batches</ShowMore>
        </div>
      )}
    </Card>
  )
}

interface BatchLineProps {
  batch: Batch
  projectId: string
  maySpeak: boolean
  opened: boolean
}

function BatchLine({ batch, projectId, maySpeak, opened }: BatchLineProps) {
  const [isOpen, setOpen] = useState(opened)
  const cancel = useCancelBatch(projectId)
  const runs = batch.state === 'planning' || batch.state === 'running'
  const title = `Batch ${batch.number}`
  const why = batch.by_spec ? 'spec changed' : 'started manually'
  return (
    <li className="grid grid-cols-1 gap-6px border-b p-3-inset" aria-label={title}>
      <p className="row wrap">
        <span className="strong">{title}</span>
        <span className="small mid">
          {[
            why,
            batch.targets.length > 0 && `for ${batch.targets.join(', ')}`,
            batch.state === 'cancelled' && batch.note,
          ]
            .filter(Boolean)
            .join(', ')}
        </span>
        <time className="small dim end nowrap" dateTime={batch.created_at} title={day(batch.created_at)}>
          {ago(batch.created_at)}
        </time>
      </p>
      <Meter
        label={`${title}: ${progressOf(batch)}`}
        whole={batch.files}
        parts={[
          { value: batch.made + batch.kept },
          { value: batch.refused, tone: 'bad' },
          { value: batch.left, tone: 'warn' },
        ]}
      />
      <p className="row wrap small">
        <span className="mid" role={runs ? 'status' : undefined}>
          {sentence(progressOf(batch))}
        </span>
        {runs && maySpeak && (
          <span className="end">
            <Button disabled={cancel.isPending} onClick={() => cancel.mutate(batch.id)}>
              Stop<span className="visually-hidden"> {title}</span>
            </Button>
          </span>
        )}
      </p>
      <Refusal inset error={cancel.error} />
      <details open={isOpen} onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
        <summary className="small pointer min-h-24px">
          Sizes before and after<span className="visually-hidden"> of {title}</span>
        </summary>
        {isOpen && <Sizes batch={batch} />}
      </details>
    </li>
  )
}

/** Each target's game files as they were, and as they are: both sets are kept. */
function SizeBars({ batch, sizes }: { batch: Batch; sizes: readonly BatchSizes[] }) {
  const totals = totalsOf(sizes)
  const longest = Math.max(1, ...totals.flatMap(({ before, after }) => [before, after]))
  const lines = totals.map(({ target, before, after }) => `${target} ${sizeOf(before)} before, ${sizeOf(after)} after`)
  const share = (count: number) => `${(count / longest) * 100}%`
  return (
    <>
      <div role="img" aria-label={`Sizes of batch ${batch.number}: ${lines.join('; ')}`}>
        {totals.map(({ target, before, after }) => (
          <div key={target} className={`grid items-center gap-3 narrow-grid-cols-1-auto ${classes.bar} small`}>
            <span className="cut-text">{target}</span>
            <span className={`bg-well relative border rounded-2px ${classes.track}`}>
              <i data-half="upper" style={{ width: share(before) }} />
              <i data-half="lower" data-used="" style={{ width: share(after) }} />
            </span>
            <span className="num mid">{`${sizeOf(before)} to ${sizeOf(after)}`}</span>
          </div>
        ))}
      </div>
      <p className={`small mid flex wrap gap-2px-4 ${classes.legend}`}>
        <span>
          <i /> before
        </span>
        <span>
          <i data-used="" /> after
        </span>
      </p>
    </>
  )
}

function Sizes({ batch }: { batch: Batch }) {
  const { data } = useBatch(batch)
  if (data === undefined) return null
  if (data.sizes.length === 0) return <p className="small mid">No version can ship yet.</p>
  return (
    <>
      <SizeBars batch={batch} sizes={data.sizes} />
      <Table
        label={`Sizes of batch ${batch.number}`}
        rows={data.sizes}
        keyOf={({ target, category }) => `${target} ${category}`}
        columns={[
          { head: 'Target', rowHead: true, cell: ({ target }) => target },
          { head: 'Category', cell: ({ category }) => category || 'none' },
          { head: 'Files', numeric: true, cell: ({ files }) => figure(files) },
          { head: 'Before', numeric: true, cell: ({ before_bytes: before }) => sizeOf(before) },
          { head: 'After', numeric: true, cell: ({ after_bytes: after }) => sizeOf(after) },
          {
            head: 'Difference',
            numeric: true,
            cell: ({ before_bytes: before, after_bytes: after }) => signed(after - before),
          },
        ]}
      />
      {data.trouble.length > 0 && (
        <ul className={`small mid ${classes.paths}`} aria-label={`Files batch ${batch.number} could not render`}>
          {data.trouble.map(({ cue, name, target, reason }) => (
            <li key={`${cue} ${name} ${target}`}>
              <span className="mono">{cue}</span> {name}, {target}: {sentence(reason)}
            </li>
          ))}
        </ul>
      )}
    </>
  )
}
