import { queryOptions } from '@tanstack/react-query'

import { get, post, put, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type FactQuestion = components['schemas']['FactQuestion']
type Fact = FactQuestion['fact']

/** What a designer could not know from the words of each cue. */
export const clarityQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'clarity'),
    queryFn: async () => {
      const { unclear } = await get('/v1/projects/{project_id}/clarity', { project_id: projectId })
      return new Map(unclear.map(({ cue_id, questions }) => [cue_id, questions]))
    },
  })

/** Write an answer into the description of a cue. */
export const useAnswerFact = (projectId: string, cueId: string) =>
  useMutation({
    mutationFn: ({ fact, text }: { fact: Fact; text: string }) =>
      post('/v1/cues/{cue_id}/clarity/{fact}/answer', { cue_id: cueId, fact }, { text }),
    affects: [queryKeys.soundList(projectId), queryKeys.cue(cueId)],
  })

/** Ask for a fact of a cue no more, or again. */
export const useDismissFact = (projectId: string, cueId: string) =>
  useMutation({
    mutationFn: ({ fact, dismissed }: { fact: Fact; dismissed: boolean }) =>
      put('/v1/cues/{cue_id}/clarity/{fact}/dismissed', { cue_id: cueId, fact }, { dismissed }),
    affects: [queryKeys.soundList(projectId, 'clarity')],
  })
