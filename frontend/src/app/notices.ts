import { queryOptions } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'

/** The largest number that is counted; above it one more is answered. */
const COUNTED = 99
/** Bidders see no project, so no change reaches their pages. */
const ASKED_EVERY_MS = 120_000

/** How many notices the current person has not read. */
export const unreadQuery = queryOptions({
  queryKey: queryKeys.notices('unread'),
  queryFn: async () => (await get('/v1/me/notices/unread')).unread,
  refetchInterval: ASKED_EVERY_MS,
})

/** The number beside the bell; nothing where all is read. */
export const unreadWords = (unread: number | undefined): string | undefined =>
  !unread ? undefined : unread > COUNTED ? `${COUNTED}+` : String(unread)
