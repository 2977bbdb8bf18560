import type { ReviewCue, ReviewTake } from './api'
import { inOrder } from './hearing'

/** Every variation has a version that could be accepted, or is approved already; none is noted for a change. */
export function isWholeSet(cue: ReviewCue, waiting: readonly ReviewTake[], approved: readonly number[]): boolean {
  if (cue.variations < 2 || waiting.length === 0) return false
  const here = new Set([...unnoted(waiting).map(({ variation }) => variation), ...approved])
  return here.size >= cue.variations
}

const unnoted = (takes: readonly ReviewTake[]): ReviewTake[] =>
  takes.filter(({ draft_change }) => draft_change === null)

/**
 * One take a variation: the one that was chosen, else the newest; none where nobody chose between files of one delivery,
 * which the server then asks about by name.
 */
export function pickedOfSet(waiting: readonly ReviewTake[], chosen: ReadonlyMap<number, string>): ReviewTake[] {
  const picked = new Map<number, ReviewTake>()
  for (const take of inOrder(unnoted(waiting))) {
    const kept = picked.get(take.variation)
    if (kept === undefined || kept.id !== chosen.get(take.variation)) picked.set(take.variation, take)
  }
  return [...picked.values()].filter(
    ({ id, variation, undecided_with: others }) => others.length === 0 || chosen.get(variation) === id,
  )
}
