import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type TotpSetup = components['schemas']['TotpSetupRead']

export const secondFactorsQuery = queryOptions({
  queryKey: queryKeys.secondFactors(),
  queryFn: () => get('/v1/me/second-factors'),
})

export const useBeginTotp = () => useMutation({ mutationFn: () => post('/v1/me/totp') })

export type SecondFactorUse = components['schemas']['SecondFactorUse']

export const requirementQuery = queryById('/v1/studios/{studio_id}/second-factor', queryKeys.secondFactorRequirement)

export function useSetRequirement(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (uses: SecondFactorUse[]) =>
      put('/v1/studios/{studio_id}/second-factor', { studio_id: studioId }, { required_for: uses }),
    onSuccess: (saved) => client.setQueryData(queryKeys.secondFactorRequirement(studioId), saved),
  })
}

export const useConfirmTotp = () =>
  useMutation({
    mutationFn: (code: string) => post('/v1/me/totp/confirm', {}, { code }),
    affects: [queryKeys.secondFactors(), queryKeys.signIns(), queryKeys.me()],
  })

export function useEndTotp() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => del('/v1/me/totp'),
    onSettled: () => invalidate(client, queryKeys.secondFactors(), queryKeys.me()),
  })
}

export function useRenewRecoveryCodes() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => post('/v1/me/recovery-codes'),
    onSettled: () => invalidate(client, queryKeys.secondFactors()),
  })
}
