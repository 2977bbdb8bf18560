import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, post, put, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import { sessionQuery } from './api'

type Schemas = components['schemas']

const MINUTE_MS = 60_000
const DOMAIN = /^[^@\s]+@([^@\s]+\.[^@\s.]{2,})$/

/** The domain of an address that is typed whole; empty before. */
export const domainOf = (email: string): string => DOMAIN.exec(email.trim())?.[1]?.toLowerCase() ?? ''

/** The studio by whose provider the people of a domain sign in. */
export const providerOfDomainQuery = (domain: string) =>
  queryOptions({
    queryKey: queryKeys.providerOfDomain(domain),
    queryFn: () => get('/v1/sign-in/provider', { domain }),
    enabled: domain !== '',
    staleTime: MINUTE_MS,
    retry: false,
  })

/** Begin a sign-in; the answer is the provider's page. */
export function useBeginProviderSignIn() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (body: Schemas['ProviderSignInStart']) => {
      await client.ensureQueryData(sessionQuery)
      return post('/v1/sign-in/oidc/start', {}, body)
    },
  })
}

export function useFinishProviderSignIn() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (body: Schemas['ProviderAnswer']) => {
      await client.ensureQueryData(sessionQuery)
      const done = await post('/v1/sign-in/oidc/callback', {}, body)
      if (!done.second_factor_needed) client.clear()
      return done
    },
  })
}

export function useProviderSignInCode() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (code: string) => {
      const done = await post('/v1/sign-in/oidc/code', {}, { code })
      client.clear()
      return done
    },
  })
}

export const signInProviderQuery = queryById('/v1/studios/{studio_id}/sign-in-provider', queryKeys.signInProvider)

export function useSetSignInProvider(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['ProviderSave']) =>
      put('/v1/studios/{studio_id}/sign-in-provider', { studio_id: studioId }, body),
    onSuccess: (saved) => client.setQueryData(queryKeys.signInProvider(studioId), saved),
  })
}

export function useRemoveSignInProvider(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => del('/v1/studios/{studio_id}/sign-in-provider', { studio_id: studioId }),
    onSettled: () => client.invalidateQueries({ queryKey: queryKeys.signInProvider(studioId) }),
  })
}
