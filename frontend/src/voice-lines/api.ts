import { queryOptions } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type VoiceLine = components['schemas']['VoiceLineRead']

/** The voice line that a cue is for; null for any other cue. */
export const cueVoiceLineQuery = (projectId: string, cueId: string) =>
  queryOptions({
    queryKey: queryKeys.voiceLines(projectId, 'cue', cueId),
    queryFn: () => get('/v1/cues/{cue_id}/voice-line', { cue_id: cueId }),
  })
