/** What a designer does with the clauses of a text that was sent: plain functions of plain values. */
import type { Clause, Contract } from './api'
import { NOTHING, type Proposed, type WordChanges } from './redlines'

/** A change that is being written; its id is the clause's key, or a number for a new clause. */
export type Written = Proposed & { id: string }

export interface RedlineDraft {
  changes: Written[]
  note: string
  /** The version that they were begun from. */
  version: number
  /** The Word document that was read into them at last. */
  read?: WordRead
}

/** What was read of a Word document, and what to look at. */
export interface WordRead {
  file: string
  added: number
  findings: { message: string; fix: string }[]
}

const MAX_NOTE = 5000

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

/** The draft with the changes of a Word document added. What is written here already stays, and is named. */
export function withRead(draft: RedlineDraft, contract: Contract, file: string, read: WordChanges): RedlineDraft {
  const titles = new Map(contract.version.clauses.map(({ key, title }) => [key, title]))
  const isWritten = (key: string | null) => key !== null && draft.changes.some(({ id }) => id === key)
  const isAdded = ({ kind, title, text, after_key }: Proposed) =>
    draft.changes.some(
      (one) => kind === 'insert' && one.title === title && one.text === text && one.after_key === after_key,
    )
  const clashes = read.changes.filter(({ clause_key }) => isWritten(clause_key))
  const added = read.changes.filter((change) => !isWritten(change.clause_key) && !isAdded(change))
  const next = added.reduce<RedlineDraft>(
    (now, change) => withChange(now, { ...change, id: change.clause_key ?? nextNewId(now) }),
    draft,
  )
  const kept = clashes.map(({ clause_key: key }) => ({
    message: `You have changed “${titles.get(key ?? '') ?? key}” here already. Your change is kept, and the file’s is not.`,
    fix: 'Undo your change and upload the file again to take the file’s.',
  }))
  const note = [draft.note, draft.note.includes(read.note) ? '' : read.note].filter(Boolean).join('\n')
  return {
    ...next,
    note: note.slice(0, MAX_NOTE),
    read: { file, added: added.length, findings: [...kept, ...read.findings] },
  }
}

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
