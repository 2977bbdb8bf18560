import { infiniteQueryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type Notice = components['schemas']['InAppNoticeRead']
type Mark = components['schemas']['NoticesMark']

/** The current person's notices, the newest first. */
export const noticesQuery = infiniteQueryOptions({
  queryKey: queryKeys.notices('list'),
  queryFn: ({ pageParam: cursor }) => get('/v1/me/notices', { cursor }),
  initialPageParam: undefined as string | undefined,
  getNextPageParam: ({ next }) => next ?? undefined,
  select: ({ pages }) => pages.flatMap(({ items }) => items),
})

/** Mark notices as read: some, or all up to one. */
export function useMarkRead() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (mark: Partial<Mark>) => post('/v1/me/notices/read', {}, { ids: [], ...mark }),
    onSettled: () => invalidate(client, queryKeys.notices.all),
  })
}
