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

export type SecondFactorUse = components['schemas']['SecondFactorUse']

const inStudio = (studioId: string) => ({ params: { path: { studio_id: studioId } } })

export const requirementQuery = (studioId: string) =>
  queryOptions({
    queryKey: queryKeys.secondFactorRequirement(studioId),
    queryFn: () => answered(api.GET('/v1/studios/{studio_id}/second-factor', inStudio(studioId))),
  })

export function useSetRequirement(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (uses: SecondFactorUse[]) =>
      answered(
        api.PUT('/v1/studios/{studio_id}/second-factor', { ...inStudio(studioId), body: { required_for: uses } }),
      ),
    onSuccess: (saved) => client.setQueryData(queryKeys.secondFactorRequirement(studioId), saved),
  })
}

export function useConfirmTotp() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (code: string) => answered(api.POST('/v1/me/totp/confirm', { body: { code } })),
    onSuccess: () => invalidate(client, queryKeys.secondFactors(), queryKeys.signIns(), queryKeys.me()),
  })
}

export function useEndTotp() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.DELETE('/v1/me/totp')),
    onSettled: () => invalidate(client, queryKeys.secondFactors(), queryKeys.me()),
  })
}

export function useRenewRecoveryCodes() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.POST('/v1/me/recovery-codes')),
    onSettled: () => invalidate(client, queryKeys.secondFactors()),
  })
}
