import { infiniteQueryOptions, useQuery, useQueryClient } from '@tanstack/react-query'

import { del, get, patch, post, queryById, useMutation } from '@/api'
import { meQuery } from '@/api/me'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Webhook = Schemas['WebhookRead']
export type WebhookSecret = Schemas['WebhookSecretRead']
export type WebhookAdd = Schemas['WebhookAdd']
export type WebhookEvent = Schemas['WebhookEvent']
export type WebhookForm = Schemas['WebhookForm']
export type Call = Schemas['WebhookCallRead']

/** The studios that the current person runs. */
export function useOwnStudios() {
  const { data } = useQuery(meQuery)
  return data?.studios.filter(({ roles }) => roles.includes('producer'))
}

export const webhooksQuery = queryById('/v1/studios/{studio_id}/webhooks', queryKeys.webhooks)

/** The messages to an address, the newest first. */
export const callsQuery = (webhookId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.webhooks('calls', webhookId),
    queryFn: ({ pageParam: cursor }) => get('/v1/webhooks/{webhook_id}/calls', { webhook_id: webhookId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

function useWebhookMutation<Given, Got>(send: (given: Given) => Promise<Got>) {
  const client = useQueryClient()
  return useMutation({ mutationFn: send, onSettled: () => invalidate(client, queryKeys.webhooks.all) })
}

export const useAddWebhook = (studioId: string) =>
  useWebhookMutation((body: WebhookAdd) => post('/v1/studios/{studio_id}/webhooks', { studio_id: studioId }, body))

export const useEnable = () =>
  useWebhookMutation(({ id, enabled }: { id: string; enabled: boolean }) =>
    patch('/v1/webhooks/{webhook_id}', { webhook_id: { id }.id }, { enabled }),
  )
export const useRotate = () =>
  useWebhookMutation((webhook: Webhook) => post('/v1/webhooks/{webhook_id}/secret', { webhook_id: webhook.id }))
export const useTest = () =>
  useWebhookMutation((webhook: Webhook) => post('/v1/webhooks/{webhook_id}/test', { webhook_id: webhook.id }))
export const useDelete = () =>
  useWebhookMutation((webhook: Webhook) => del('/v1/webhooks/{webhook_id}', { webhook_id: webhook.id }))
export const useReplay = () =>
  useWebhookMutation((call: Call) => post('/v1/webhook-calls/{webhook_call_id}/replay', { webhook_call_id: call.id }))
