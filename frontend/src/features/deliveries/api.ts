import { useInfiniteQuery } from '@tanstack/react-query'

import { get, queryById } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Delivery = Schemas['DeliveryRead']
export type DeliveryDetail = Schemas['DeliveryDetail']
export type Take = Schemas['TakeRead']
export type Archive = Schemas['ArchiveRead']

const POLL_MS = 2000

/** One delivery with everything that came in it; asked again while something of it is being checked. */
export const deliveryQuery = queryById('/v1/deliveries/{delivery_id}', queryKeys.delivery, {
  refetchInterval: ({ state: { data } }) =>
    data?.takes.some(({ state }) => state === 'received') ? POLL_MS + 10 * data.takes.length : false,
})

/** A project's deliveries, the newest first; a designer's own. */
export const useDeliveries = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.deliveryList(projectId),
    queryFn: ({ pageParam: cursor }) => get('/v1/projects/{project_id}/deliveries', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })
