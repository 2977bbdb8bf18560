import { infiniteQueryOptions, queryOptions, useQuery, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
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

export const webhooksQuery = (studioId: string) =>
  queryOptions({
    queryKey: queryKeys.webhooks(studioId),
    queryFn: () => answered(api.GET('/v1/studios/{studio_id}/webhooks', { params: { path: { studio_id: studioId } } })),
  })

/** The messages to an address, the newest first. */
export const callsQuery = (webhookId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.webhooks('calls', webhookId),
    queryFn: ({ pageParam: cursor }) =>
      answered(
        api.GET('/v1/webhooks/{webhook_id}/calls', {
          params: { path: { webhook_id: webhookId }, query: { cursor } },
        }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

function useWebhookMutation<Given, Got>(send: (given: Given) => Promise<Got>) {
  const client = useQueryClient()
  return useMutation({ mutationFn: send, onSettled: () => invalidate(client, queryKeys.webhooks.all) })
}

export const useAddWebhook = (studioId: string) =>
  useWebhookMutation((body: WebhookAdd) =>
    answered(api.POST('/v1/studios/{studio_id}/webhooks', { params: { path: { studio_id: studioId } }, body })),
  )

const at = (webhook: Pick<Webhook, 'id'>) => ({ params: { path: { webhook_id: webhook.id } } })

export const useEnable = () =>
  useWebhookMutation(({ id, enabled }: { id: string; enabled: boolean }) =>
    answered(api.PATCH('/v1/webhooks/{webhook_id}', { ...at({ id }), body: { enabled } })),
  )
export const useRotate = () =>
  useWebhookMutation((webhook: Webhook) => answered(api.POST('/v1/webhooks/{webhook_id}/secret', at(webhook))))
export const useTest = () =>
  useWebhookMutation((webhook: Webhook) => answered(api.POST('/v1/webhooks/{webhook_id}/test', at(webhook))))
export const useDelete = () =>
  useWebhookMutation((webhook: Webhook) => answered(api.DELETE('/v1/webhooks/{webhook_id}', at(webhook))))
export const useReplay = () =>
  useWebhookMutation((call: Call) =>
    answered(
      api.POST('/v1/webhook-calls/{webhook_call_id}/replay', { params: { path: { webhook_call_id: call.id } } }),
    ),
  )
