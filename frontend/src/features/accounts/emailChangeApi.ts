import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

const byLink = (secret: string) => ({ params: { path: { secret } } })

export const emailChangeQuery = queryOptions({
  queryKey: queryKeys.emailChange(),
  queryFn: () => answered(api.GET('/v1/me/email-change')),
})

export function useAskEmailChange() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (email: string) => answered(api.POST('/v1/me/email-change', { body: { email } })),
    onSuccess: (pending) => client.setQueryData(queryKeys.emailChange(), pending),
  })
}

export function useCancelEmailChange() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.DELETE('/v1/me/email-change')),
    onSettled: () => invalidate(client, queryKeys.emailChange()),
  })
}

export const emailChangeLinkQuery = (secret: string) =>
  queryOptions({
    queryKey: queryKeys.emailChangeLink(secret),
    queryFn: () => answered(api.GET('/v1/email-changes/{secret}', byLink(secret))),
    retry: false,
  })

export function useConfirmEmailChange(secret: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.POST('/v1/email-changes/{secret}/confirm', byLink(secret))),
    onSuccess: () => invalidate(client, queryKeys.me(), queryKeys.emailChange(), queryKeys.signIns()),
  })
}

export const useStopEmailChange = (secret: string) =>
  useMutation({ mutationFn: () => answered(api.DELETE('/v1/email-changes/{secret}', byLink(secret))) })
