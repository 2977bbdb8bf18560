import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Invitation = Schemas['InvitationPreview']
export type PreviewCue = Schemas['PreviewCue']
export type Spec = Schemas['ResolvedSpec']

export const invitationQuery = (secret: string) =>
  queryOptions({
    queryKey: queryKeys.invitation(secret),
    queryFn: () => get('/v1/invitations/{secret}', { secret }),
  })

export function useAccept(secret: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['InvitationAccept']) => post('/v1/invitations/{secret}/accept', { secret }, body),
    // Another person may be signed in from here on.
    onSuccess: () => client.clear(),
  })
}
