/** What a producer does with the clauses of a draft: plain functions of plain values. */
import type { Clause, Draft, LibraryClause } from './api'

export const moveButtonId = (key: string, by: -1 | 1): string => `move-${key}-${by < 0 ? 'up' : 'down'}`

/** What a clause leaves open: the terms that its text names, and those that the choice taken there names. */
export function termsOf(clause: Clause, known: LibraryClause | undefined, terms: Draft['terms']): string[] {
  const chosen = known?.terms.flatMap(({ name, choices }) => choices.filter(({ value }) => value === terms[name])) ?? []
  const said = [clause.text, ...chosen.map(({ words }) => words)].join(' ')
  return Object.keys(terms).filter((name) => said.includes(`{${name}}`))
}

/** The draft with a clause one place up or down; at the ends it stays. */
export function movedClause(draft: Draft, key: string, by: -1 | 1): Draft {
  const from = draft.clauses.findIndex((clause) => clause.key === key)
  const clause = draft.clauses[from]
  const to = from + by
  if (!clause || to < 0 || to >= draft.clauses.length) return draft
  const others = draft.clauses.toSpliced(from, 1)
  return { ...draft, clauses: others.toSpliced(to, 0, clause) }
}

/** The draft without a clause; what it left open is kept for its coming back. */
export const withoutClause = (draft: Draft, key: string): Draft => ({
  ...draft,
  clauses: draft.clauses.filter((clause) => clause.key !== key),
})

export const withClauseBack = (draft: Draft, clause: Clause, place: number): Draft => ({
  ...draft,
  clauses: draft.clauses.toSpliced(place, 0, clause),
})

/** The draft with a clause of the library where the library has it; its terms begin as the library has them. */
export function withLibraryClause(draft: Draft, library: readonly LibraryClause[], key: string): Draft {
  const order = library.map((each) => each.key)
  const known = library[order.indexOf(key)]
  if (!known) return draft
  const after = draft.clauses.findIndex((clause) => order.indexOf(clause.key) > order.indexOf(key))
  const place = after < 0 ? draft.clauses.length : after
  const clause: Clause = { key, title: known.title, text: known.text, stands: true }
  const begun = Object.fromEntries(known.terms.map((term) => [term.name, term.default]))
  return { ...draft, clauses: draft.clauses.toSpliced(place, 0, clause), terms: { ...begun, ...draft.terms } }
}

/** The draft with a clause that stands or does not; one that the draft lacks comes from the library. */
export function withStanding(draft: Draft, library: readonly LibraryClause[], key: string, stands: boolean): Draft {
  const whole = draft.clauses.some((clause) => clause.key === key) ? draft : withLibraryClause(draft, library, key)
  return { ...whole, clauses: whole.clauses.map((clause) => (clause.key === key ? { ...clause, stands } : clause)) }
}

/** The draft with a clause of one's own at the end, still to be written. */
export function withOwnClause(draft: Draft, title: string): Draft {
  const stem = `own_${title.toLowerCase().replace(/[^a-z0-9]+/g, '_')}`.replace(/_+$/, '').slice(0, 56)
  const taken = new Set(draft.clauses.map(({ key }) => key))
  let key = stem
  for (let count = 2; taken.has(key); count += 1) key = `${stem}_${count}`
  return { ...draft, clauses: [...draft.clauses, { key, title, text: '', stands: true }] }
}
