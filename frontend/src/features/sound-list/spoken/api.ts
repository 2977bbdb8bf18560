import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { base64Of } from '@/api/base64'
import { invalidate, queryKeys } from '@/api/queryKeys'

const ofCue = (cueId: string) => ({ params: { path: { cue_id: cueId } } })

/** What a person said for a cue; null for nothing. */
export const saidQuery = (cueId: string) =>
  queryOptions({
    queryKey: queryKeys.spokenPlaceholder(cueId),
    queryFn: async () => (await answered(api.GET('/v1/cues/{cue_id}/spoken-placeholder', ofCue(cueId)))) ?? null,
  })

export function useSay(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (file: File) =>
      answered(
        api.PUT('/v1/cues/{cue_id}/spoken-placeholder', {
          ...ofCue(cueId),
          body: { content_base64: await base64Of(file) },
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.spokenPlaceholder(cueId), queryKeys.placeholders(projectId)),
  })
}

export function useRemoveSaid(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.DELETE('/v1/cues/{cue_id}/spoken-placeholder', ofCue(cueId))),
    onSuccess: () => invalidate(client, queryKeys.spokenPlaceholder(cueId), queryKeys.placeholders(projectId)),
  })
}
