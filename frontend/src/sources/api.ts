import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, put, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Sources = Schemas['Sources']
export type TakeSources = Schemas['TakeSources']
export type DeliverySources = Schemas['DeliverySources']
export type SameSounds = Schemas['SameSoundsRead']

export const takeSourcesQuery = (takeId: string) =>
  queryOptions({
    queryKey: queryKeys.sources('take', takeId),
    queryFn: () => get('/v1/takes/{take_id}/sources', { take_id: takeId }),
  })

export const sameSoundsQuery = (takeId: string) =>
  queryOptions({
    queryKey: queryKeys.sameSounds(takeId),
    queryFn: () => get('/v1/takes/{take_id}/same-sounds', { take_id: takeId }),
  })

export const deliverySourcesQuery = (deliveryId: string) =>
  queryOptions({
    queryKey: queryKeys.sources('delivery', deliveryId),
    queryFn: () => get('/v1/deliveries/{delivery_id}/sources', { delivery_id: deliveryId }),
  })

export function useStateTakeSources(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Sources) => put('/v1/takes/{take_id}/sources', { take_id: takeId }, body),
    onSuccess: () => invalidate(client, queryKeys.sources.all, queryKeys.sameSounds.all),
  })
}

export function useStateDeliverySources(deliveryId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Sources) => put('/v1/deliveries/{delivery_id}/sources', { delivery_id: deliveryId }, body),
    onSuccess: () => invalidate(client, queryKeys.sources.all),
  })
}
