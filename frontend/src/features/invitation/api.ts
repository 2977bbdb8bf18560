import { queryOptions, useMutation, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Invitation = Schemas['InvitationPreview']
export type PreviewCue = Schemas['PreviewCue']
export type Spec = Schemas['ResolvedSpec']

export const invitationQuery = (secret: string) =>
  queryOptions({
    queryKey: ['invitation', secret],
    queryFn: () => answered(api.GET('/v1/invitations/{secret}', { params: { path: { secret } } })),
  })

/** The current person, if signed in; the request also gives the page the token that its writes carry. */
export const visitorQuery = queryOptions({
  queryKey: ['visitor'],
  queryFn: async () => {
    const session = await answered(api.GET('/v1/session'))
    return session.signed_in ? await answered(api.GET('/v1/me')) : null
  },
})

export function useAccept(secret: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['InvitationAccept']) =>
      answered(api.POST('/v1/invitations/{secret}/accept', { params: { path: { secret } }, body })),
    // Another person may be signed in from here on.
    onSuccess: () => client.clear(),
  })
}
