import { infiniteQueryOptions } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type SecurityEvent = components['schemas']['SecurityEventRead']
export type SecurityEventKind = components['schemas']['SecurityEventKind']

/** The security log of a studio, newest first; of one kind, or of all where none is named. */
export const securityEventsQuery = (studioId: string, kind: SecurityEventKind | '') =>
  infiniteQueryOptions({
    queryKey: queryKeys.securityEvents(studioId, kind),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/studios/{studio_id}/security-events', { studio_id: studioId, cursor, ...(kind && { kind }) }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })
