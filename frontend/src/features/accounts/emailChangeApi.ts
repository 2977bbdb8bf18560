import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

export const emailChangeQuery = queryOptions({
  queryKey: queryKeys.emailChange(),
  queryFn: () => get('/v1/me/email-change'),
})

export function useAskEmailChange() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (email: string) => post('/v1/me/email-change', {}, { email }),
    onSuccess: (pending) => client.setQueryData(queryKeys.emailChange(), pending),
  })
}

export function useCancelEmailChange() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => del('/v1/me/email-change'),
    onSettled: () => invalidate(client, queryKeys.emailChange()),
  })
}

export const emailChangeLinkQuery = (secret: string) =>
  queryOptions({
    queryKey: queryKeys.emailChangeLink(secret),
    queryFn: () => get('/v1/email-changes/{secret}', { secret }),
    retry: false,
  })

export function useConfirmEmailChange(secret: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => post('/v1/email-changes/{secret}/confirm', { secret }),
    onSuccess: () => invalidate(client, queryKeys.me(), queryKeys.emailChange(), queryKeys.signIns()),
  })
}

export const useStopEmailChange = (secret: string) =>
  useMutation({ mutationFn: () => del('/v1/email-changes/{secret}', { secret }) })
