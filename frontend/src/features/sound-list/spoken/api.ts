import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, put, useMutation } from '@/api'
import { base64Of } from '@/api/base64'
import { invalidate, queryKeys } from '@/api/queryKeys'

/** What a person said for a cue; null for nothing. */
export const saidQuery = (cueId: string) =>
  queryOptions({
    queryKey: queryKeys.spokenPlaceholder(cueId),
    queryFn: async () => (await get('/v1/cues/{cue_id}/spoken-placeholder', { cue_id: cueId })) ?? null,
  })

export function useSay(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (file: File) =>
      put('/v1/cues/{cue_id}/spoken-placeholder', { cue_id: cueId }, { content_base64: await base64Of(file) }),
    onSuccess: () => invalidate(client, queryKeys.spokenPlaceholder(cueId), queryKeys.placeholders(projectId)),
  })
}

export function useRemoveSaid(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => del('/v1/cues/{cue_id}/spoken-placeholder', { cue_id: cueId }),
    onSuccess: () => invalidate(client, queryKeys.spokenPlaceholder(cueId), queryKeys.placeholders(projectId)),
  })
}
