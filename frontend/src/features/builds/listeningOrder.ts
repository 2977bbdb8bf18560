import type { CueToHear } from './api'

export const ORDERS = ['list', 'category', 'event'] as const
export type Order = (typeof ORDERS)[number]
export const ORDER_WORDS: Record<Order, string> = { list: 'List', category: 'Category', event: 'Event' }

const KEPT = 'soundlist-listening-order'

/** How this browser grouped a listening pass last. */
export function keptOrder(): Order {
  try {
    const kept = localStorage.getItem(KEPT)
    return ORDERS.find((order) => order === kept) ?? 'list'
  } catch {
    return 'list'
  }
}

export function keepOrder(order: Order): void {
  try {
    localStorage.setItem(KEPT, order)
  } catch {
    // A browser that keeps nothing begins with the list.
  }
}

/** The group of a cue; a cue of several events goes by the first. */
export function groupOf({ category, events }: CueToHear, order: Order): string {
  if (order === 'category') return category || 'No category'
  return order === 'event' ? (events[0] ?? 'No event') : ''
}

/** The cues group by group, each in list order; what has no group comes last. */
export function inOrder(cues: readonly CueToHear[], order: Order): CueToHear[] {
  if (order === 'list') return [...cues]
  const isLast = ({ category, events }: CueToHear) => (order === 'category' ? category === '' : events.length === 0)
  return [...cues].sort(
    (a, b) => Number(isLast(a)) - Number(isLast(b)) || groupOf(a, order).localeCompare(groupOf(b, order)),
  )
}
