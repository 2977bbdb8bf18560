import type { QueryClient } from '@tanstack/react-query'

import type { components } from '@/api/schema.gen'

type QueuePage = components['schemas']['Page_QueueItem_']
type Items = QueuePage['items']

interface UnderWay {
  /** Verdicts and undos that the server has not answered. */
  count: number
  /** What the decisions since the last of them do to the queue; those that were undone are out. */
  decisions: Set<(items: Items) => Items>
}

const all = new WeakMap<QueryClient, UnderWay>()

/** What is on its way to the server, or kept for it: lists are read again after the last of it. */
export function underWay(client: QueryClient): UnderWay {
  const known = all.get(client) ?? { count: 0, decisions: new Set() }
  all.set(client, known)
  return known
}

/** A page of the queue as the server has it, without what was decided here and may not have arrived there. */
export const withoutUnderWay = (client: QueryClient, page: QueuePage): QueuePage => ({
  ...page,
  items: [...underWay(client).decisions].reduce((items, decided) => decided(items), page.items),
})
