import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, post, queryById, useMutation } from '@/api'
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

export const emailChangeLinkQuery = queryById('/v1/email-changes/{secret}', queryKeys.emailChangeLink, {
  retry: false,
})

export const useConfirmEmailChange = (secret: string) =>
  useMutation({
    mutationFn: () => post('/v1/email-changes/{secret}/confirm', { secret }),
    affects: [queryKeys.me(), queryKeys.emailChange(), queryKeys.signIns()],
  })

export const useStopEmailChange = (secret: string) =>
  useMutation({ mutationFn: () => del('/v1/email-changes/{secret}', { secret }) })
