import type { QueryClient } from '@tanstack/react-query'

import { type Decided, withoutVerdict } from './afterVerdict'
import type { QueuePage } from './api'

interface UnderWay {
  /** Verdicts and undos that the server has not answered. */
  count: number
  /** What was decided since the last of them, and not undone. */
  decided: Set<Decided>
}

const all = new WeakMap<QueryClient, UnderWay>()

/** What is on its way to the server, or kept for it: lists are read again after the last of it. */
export function underWay(client: QueryClient): UnderWay {
  const known = all.get(client) ?? { count: 0, decided: new Set() }
  all.set(client, known)
  return known
}

/** A page of the queue as the server has it, without what was decided here and may not have arrived there. */
export const withoutUnderWay = (client: QueryClient, page: QueuePage): QueuePage => ({
  ...page,
  items: [...underWay(client).decided].reduce<QueuePage['items']>(withoutVerdict, page.items),
})
