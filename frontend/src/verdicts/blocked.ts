import type { BlockedTake, CueReview, ReviewTake } from './api'

/** Whether notes that are open block approval. */
export const notesBlock = (blockers: CueReview['checklist']['blockers']): boolean =>
  blockers === 'notes' || blockers === 'both'

/** What is open of versions that cannot be approved yet, by version. */
export const whyBlocked = (blocked: readonly BlockedTake[]): ReadonlyMap<string, string> =>
  new Map(blocked.map(({ take_id, why }) => [take_id, why]))

/** "Left out: B, 1 comment is not resolved." of those of some versions that cannot be approved yet; else nothing. */
export function blockedWords(
  takes: readonly ReviewTake[],
  why: ReadonlyMap<string, string>,
  nameOf: (take: ReviewTake) => string,
): string {
  const open = takes.filter(({ id }) => why.has(id))
  if (open.length === 0) return ''
  if (takes.length === 1) return `Not to be approved yet: ${why.get(takes[0]?.id ?? '') ?? ''}.`
  return `Left out: ${open.map((take) => `${nameOf(take)}, ${why.get(take.id) ?? ''}`).join('; ')}.`
}
