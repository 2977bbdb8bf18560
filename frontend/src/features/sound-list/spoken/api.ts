import { queryOptions } from '@tanstack/react-query'

import { del, get, put, useMutation } from '@/api'
import { base64Of } from '@/api/base64'
import { queryKeys } from '@/api/queryKeys'

/** What a person said for a cue; null for nothing. */
export const saidQuery = (cueId: string) =>
  queryOptions({
    queryKey: queryKeys.spokenPlaceholder(cueId),
    queryFn: async () => (await get('/v1/cues/{cue_id}/spoken-placeholder', { cue_id: cueId })) ?? null,
  })

export const useSay = (projectId: string, cueId: string) =>
  useMutation({
    mutationFn: async (file: File) =>
      put('/v1/cues/{cue_id}/spoken-placeholder', { cue_id: cueId }, { content_base64: await base64Of(file) }),
    affects: [queryKeys.spokenPlaceholder(cueId), queryKeys.placeholders(projectId)],
  })

export const useRemoveSaid = (projectId: string, cueId: string) =>
  useMutation({
    mutationFn: () => del('/v1/cues/{cue_id}/spoken-placeholder', { cue_id: cueId }),
    affects: [queryKeys.spokenPlaceholder(cueId), queryKeys.placeholders(projectId)],
  })
