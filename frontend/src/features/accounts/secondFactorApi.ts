import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type TotpSetup = components['schemas']['TotpSetupRead']

export const secondFactorsQuery = queryOptions({
  queryKey: queryKeys.secondFactors(),
  queryFn: () => answered(api.GET('/v1/me/second-factors')),
})

export const useBeginTotp = () => useMutation({ mutationFn: () => answered(api.POST('/v1/me/totp')) })

export function useConfirmTotp() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (code: string) => answered(api.POST('/v1/me/totp/confirm', { body: { code } })),
    onSuccess: () => invalidate(client, queryKeys.secondFactors(), queryKeys.signIns()),
  })
}

export function useEndTotp() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.DELETE('/v1/me/totp')),
    onSettled: () => invalidate(client, queryKeys.secondFactors()),
  })
}

export function useRenewRecoveryCodes() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.POST('/v1/me/recovery-codes')),
    onSettled: () => invalidate(client, queryKeys.secondFactors()),
  })
}
