import { useQueryClient } from '@tanstack/react-query'

import { post, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Invitation = Schemas['InvitationPreview']
export type PreviewCue = Schemas['PreviewCue']
export type Spec = Schemas['ResolvedSpec']

export const invitationQuery = queryById('/v1/invitations/{secret}', queryKeys.invitation)

export function useAccept(secret: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['InvitationAccept']) => post('/v1/invitations/{secret}/accept', { secret }, body),
    // Another person may be signed in from here on.
    onSuccess: () => client.clear(),
  })
}
