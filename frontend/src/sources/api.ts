import { put, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Sources = Schemas['Sources']
export type TakeSources = Schemas['TakeSources']
export type DeliverySources = Schemas['DeliverySources']
export type SameSounds = Schemas['SameSoundsRead']

export const takeSourcesQuery = queryById('/v1/takes/{take_id}/sources', (takeId) => queryKeys.sources('take', takeId))

export const sameSoundsQuery = queryById('/v1/takes/{take_id}/same-sounds', queryKeys.sameSounds)

export const deliverySourcesQuery = queryById('/v1/deliveries/{delivery_id}/sources', (deliveryId) =>
  queryKeys.sources('delivery', deliveryId),
)

export const useStateTakeSources = (takeId: string) =>
  useMutation({
    mutationFn: (body: Sources) => put('/v1/takes/{take_id}/sources', { take_id: takeId }, body),
    affects: [queryKeys.sources.all, queryKeys.sameSounds.all],
  })

export const useStateDeliverySources = (deliveryId: string) =>
  useMutation({
    mutationFn: (body: Sources) => put('/v1/deliveries/{delivery_id}/sources', { delivery_id: deliveryId }, body),
    affects: [queryKeys.sources.all],
  })
