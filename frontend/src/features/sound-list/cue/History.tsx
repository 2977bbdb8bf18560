import type { InfiniteData, UseInfiniteQueryResult } from '@tanstack/react-query'
import type { ReactNode } from 'react'

import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { clock, day } from '@/ui/format'
import { ShowMore } from '@/ui/ShowMore'

import { type CueChanged, type CueDetail, type Version } from '../api'
import { Changes } from '../Changes'
import classes from './Cue.module.css'

interface Happened {
  key: string
  at: string
  who: string
  what: ReactNode
}

interface HistoryProps {
  cue: CueDetail
  versions: readonly Version[]
  changes: UseInfiniteQueryResult<InfiniteData<{ found: CueChanged[] }>>
}

/** What happened to a cue, the newest first: changes of the list, questions, answers and deliveries. */
export function History({ cue, versions, changes }: HistoryProps) {
  const all = [
    ...(changes.data?.pages.flatMap(({ found }) => found) ?? []).map((change) => ofChange(change, cue)),
    ...cue.questions.flatMap(ofQuestion),
    ...versions.map(ofVersion),
  ].sort((a, b) => b.at.localeCompare(a.at))
  return (
    <Card aria-labelledby="history">
      <CardHead id="history" title="History" end="newest first" />
      <Refusal error={changes.error} />
      <ol className={classes.history}>
        {all.map(({ key, at, who, what }) => (
          <li key={key}>
            <div>{what}</div>
            <p className="small dim">{[who, day(at), clock(at)].filter(Boolean).join(', ')}</p>
          </li>
        ))}
      </ol>
      {changes.hasNextPage && (
        <p className="p-2-inset-3">
          <ShowMore list={changes}>Show older</ShowMore>
        </p>
      )}
    </Card>
  )
}

function ofChange({ revision, kind, changes }: CueChanged, cue: CueDetail): Happened {
  const what =
    kind === 'added' ? (
      <p>Added to the list</p>
    ) : kind === 'cut' ? (
      <p>Cut{cue.cut_reason ? `: “${cue.cut_reason}”` : ''}</p>
    ) : (
      <Changes changes={changes} />
    )
  return {
    key: `revision ${revision.number}`,
    at: revision.created_at,
    who: `${revision.author.name}, revision ${revision.number}`,
    what,
  }
}

function ofQuestion({ id, text, asked_at, asked_by, answered_at, answered_by }: CueDetail['questions'][number]) {
  const asked: Happened = {
    key: `asked ${id}`,
    at: asked_at,
    who: asked_by?.name ?? 'Another designer',
    what: <p>Asked: {text}</p>,
  }
  if (answered_at === null) return [asked]
  return [
    asked,
    { key: `answered ${id}`, at: answered_at, who: answered_by?.name ?? '', what: <p>Answered: {text}</p> },
  ]
}

function ofVersion({ take }: Version): Happened {
  return {
    key: `take ${take.id}`,
    at: take.received_at,
    who: take.designer.name,
    what: <p>Delivered {take.file_name}</p>,
  }
}
