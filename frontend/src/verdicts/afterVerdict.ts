import type { InfiniteData } from '@tanstack/react-query'

import type { CueReview, QueueItem, QueuePage, ReviewTake } from './api'

/** The takes of a cue that a verdict was given on; `picked` where the other alternates of their variation are out. */
interface Decided {
  cueId: string
  takeIds: readonly string[]
  picked: boolean
}

/** The queue once takes were decided on: they leave, with the other alternates of their variation where one was picked. */
export function withoutVerdict(items: readonly QueueItem[], decided: Decided): QueueItem[] {
  return items.flatMap((item) => {
    if (item.cue.id !== decided.cueId) return [item]
    const left = item.takes.filter((take) => decided.takeIds.includes(take.id))
    const variations = new Set(decided.picked ? left.map(({ variation }) => variation) : [])
    const takes = item.takes.filter((take) => !left.includes(take) && !variations.has(take.variation))
    return takes.length === 0 ? [] : [{ ...item, takes }]
  })
}

/** The queue once a decision was undone: what left by it is there again, at its place of before. */
export function withVerdictBack(
  now: readonly QueuePage[],
  before: readonly QueuePage[],
  decided: Decided,
): QueuePage[] {
  const was = before.flatMap(({ items }) => items)
  const at = was.findIndex(({ cue }) => cue.id === decided.cueId)
  const item = was[at]
  if (!item) return [...now]
  const stayed = withoutVerdict([item], decided).flatMap(({ takes }) => takes.map(({ id }) => id))
  const there = now.flatMap(({ items }) => items).find(({ cue }) => cue.id === decided.cueId)
  const newest = new Map(there?.takes.map((take) => [take.id, take]))
  const takes = item.takes.flatMap((take) => newest.get(take.id) ?? (stayed.includes(take.id) ? [] : [take]))
  const back = { ...item, ...there, takes }
  if (there) return inPages(now, (items) => items.map((queued) => (queued === there ? back : queued)))
  const ahead = was
    .slice(0, at)
    .reverse()
    .map(({ cue }) => cue.id)
  const ids = new Set(now.flatMap(({ items }) => items.map(({ cue }) => cue.id)))
  const previous = ahead.find((id) => ids.has(id))
  if (previous === undefined) return now.map((page, n) => (n === 0 ? { ...page, items: [back, ...page.items] } : page))
  return inPages(now, (items) => items.flatMap((queued) => (queued.cue.id === previous ? [queued, back] : [queued])))
}

const inPages = (pages: readonly QueuePage[], change: (items: QueueItem[]) => QueueItem[]): QueuePage[] =>
  pages.map((page) => ({ ...page, items: change(page.items) }))

/** A cue's review once takes were approved: what else waits or was approved of their variations is set aside. */
export function withPicks(review: CueReview, pickedIds: readonly string[]): CueReview {
  const variations = variationsOf(review, pickedIds)
  const stateOf = (take: ReviewTake): ReviewTake['state'] => {
    if (pickedIds.includes(take.id)) return 'approved'
    const gaveWay = variations.has(take.variation) && (take.state === 'conforming' || take.state === 'approved')
    return gaveWay ? 'set_aside' : take.state
  }
  return {
    ...review,
    takes: review.takes.map((take) => ({ ...take, state: stateOf(take) })),
    approved_variations: [...new Set([...review.approved_variations, ...variations])].sort((a, b) => a - b),
  }
}

/** A cue's review once the approval of takes was undone or refused: their variations stand as before. */
export function withoutPicks(now: CueReview, before: CueReview, pickedIds: readonly string[]): CueReview {
  const variations = variationsOf(now, pickedIds)
  const states = new Map(before.takes.map(({ id, state }) => [id, state]))
  return {
    ...now,
    takes: now.takes.map((take) =>
      variations.has(take.variation) ? { ...take, state: states.get(take.id) ?? take.state } : take,
    ),
    approved_variations: now.approved_variations.filter(
      (variation) => !variations.has(variation) || before.approved_variations.includes(variation),
    ),
  }
}

const variationsOf = ({ takes }: CueReview, takeIds: readonly string[]): ReadonlySet<number> =>
  new Set(takes.filter(({ id }) => takeIds.includes(id)).map(({ variation }) => variation))

/** The queue once a change of a take was noted as a draft. */
export const withDraft = (
  queue: InfiniteData<QueuePage>,
  takeId: string,
  draft: ReviewTake['draft_change'],
): InfiniteData<QueuePage> => ({
  ...queue,
  pages: queue.pages.map((page) => ({
    ...page,
    items: page.items.map((item) => ({
      ...item,
      takes: item.takes.map((take) => (take.id === takeId ? { ...take, draft_change: draft } : take)),
    })),
  })),
})

/** Every take of the item is noted for a change: nothing more to decide before it is sent. */
export const isNoted = (item: QueueItem): boolean => item.takes.every(({ draft_change }) => draft_change !== null)

/** A version of it waits that the current person has not heard. */
export const isUnheard = (item: QueueItem): boolean => item.takes.some(({ is_heard }) => !is_heard)

/**
 * What is judged after this one: the next in the order of the queue, from its start again after its end. A page may be
 * drawn a key late: of its `items` only those that are `queued` by now come next.
 */
export function nextAfter(
  items: readonly QueueItem[],
  cueId: string,
  queued: readonly QueueItem[] = items,
): QueueItem | undefined {
  const left = queued.filter((item) => !isNoted(item) && item.cue.id !== cueId)
  const waits = new Set(left.map(({ cue }) => cue.id))
  const drawn = items.filter(({ cue }) => waits.has(cue.id))
  const at = items.findIndex(({ cue }) => cue.id === cueId)
  return drawn.find((item) => items.indexOf(item) > at) ?? drawn[0] ?? left[0]
}
