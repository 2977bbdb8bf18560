import { queryOptions, useMutation, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Sources = Schemas['Sources']
export type TakeSources = Schemas['TakeSources']
export type DeliverySources = Schemas['DeliverySources']

const ROOT = 'sources'

export const takeSourcesQuery = (takeId: string) =>
  queryOptions({
    queryKey: [ROOT, 'take', takeId] as const,
    queryFn: () => answered(api.GET('/v1/takes/{take_id}/sources', { params: { path: { take_id: takeId } } })),
  })

export const deliverySourcesQuery = (deliveryId: string) =>
  queryOptions({
    queryKey: [ROOT, 'delivery', deliveryId] as const,
    queryFn: () =>
      answered(api.GET('/v1/deliveries/{delivery_id}/sources', { params: { path: { delivery_id: deliveryId } } })),
  })

export function useStateTakeSources(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Sources) =>
      answered(api.PUT('/v1/takes/{take_id}/sources', { params: { path: { take_id: takeId } }, body })),
    onSuccess: () => client.invalidateQueries({ queryKey: [ROOT] }),
  })
}

export function useStateDeliverySources(deliveryId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Sources) =>
      answered(
        api.PUT('/v1/deliveries/{delivery_id}/sources', { params: { path: { delivery_id: deliveryId } }, body }),
      ),
    onSuccess: () => client.invalidateQueries({ queryKey: [ROOT] }),
  })
}
