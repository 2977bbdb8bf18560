/** What a designer does with the clauses of a text that was sent: plain functions of plain values. */
import type { Clause } from './api'
import { NOTHING, type Proposed } from './redlines'

/** A change that is being written; its id is the clause's key, or a number for a new clause. */
export type Written = Proposed & { id: string }

export interface RedlineDraft {
  changes: Written[]
  note: string
  /** The version that they were begun from. */
  version: number
}

export const begunDraft = (version: number): RedlineDraft => ({ changes: [], note: '', version })

const withChange = (draft: RedlineDraft, change: Written): RedlineDraft => ({
  ...draft,
  changes: [...draft.changes.filter(({ id }) => id !== change.id), change],
})

/** The draft with a clause to be edited, beginning with the words that it has. */
export const withEdit = (draft: RedlineDraft, { key, title, text }: Clause): RedlineDraft =>
  withChange(draft, { ...NOTHING, id: key, kind: 'replace', clause_key: key, after_key: null, title, text })

export const withStrike = (draft: RedlineDraft, key: string): RedlineDraft =>
  withChange(draft, { ...NOTHING, id: key, kind: 'strike', clause_key: key, after_key: null })

/** The id of the next new clause. */
export const nextNewId = ({ changes }: RedlineDraft): string =>
  String(Math.max(0, ...changes.flatMap(({ id, kind }) => (kind === 'insert' ? [Number(id)] : []))) + 1)

/** The draft with a new clause after another one, still to be written. */
export const withInsert = (draft: RedlineDraft, after: string): RedlineDraft =>
  withChange(draft, { ...NOTHING, id: nextNewId(draft), kind: 'insert', clause_key: null, after_key: after })

export const withChanged = (draft: RedlineDraft, id: string, changes: Partial<Proposed>): RedlineDraft => ({
  ...draft,
  changes: draft.changes.map((change) => (change.id === id ? { ...change, ...changes } : change)),
})

export const withoutChange = (draft: RedlineDraft, id: string): RedlineDraft => ({
  ...draft,
  changes: draft.changes.filter((change) => change.id !== id),
})

/** The changes as the server takes them. */
export const proposedOf = (changes: readonly Written[]): Proposed[] =>
  changes.map(({ kind, clause_key, after_key, title, text, terms, comment }) => ({
    kind,
    clause_key,
    after_key,
    title,
    text,
    terms,
    comment,
  }))
