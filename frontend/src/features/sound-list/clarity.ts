import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type FactQuestion = components['schemas']['FactQuestion']
type Fact = FactQuestion['fact']

/** What a designer could not know from the words of each cue. */
export const clarityQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'clarity'),
    queryFn: async () => {
      const { unclear } = await answered(
        api.GET('/v1/projects/{project_id}/clarity', { params: { path: { project_id: projectId } } }),
      )
      return new Map(unclear.map(({ cue_id, questions }) => [cue_id, questions]))
    },
  })

const pathOf = (cueId: string, fact: Fact) => ({ params: { path: { cue_id: cueId, fact } } })

/** Write an answer into the description of a cue. */
export function useAnswerFact(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ fact, text }: { fact: Fact; text: string }) =>
      answered(api.POST('/v1/cues/{cue_id}/clarity/{fact}/answer', { ...pathOf(cueId, fact), body: { text } })),
    onSuccess: () => invalidate(client, queryKeys.soundList(projectId), queryKeys.cue(cueId)),
  })
}

/** Ask for a fact of a cue no more, or again. */
export function useDismissFact(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ fact, dismissed }: { fact: Fact; dismissed: boolean }) =>
      answered(api.PUT('/v1/cues/{cue_id}/clarity/{fact}/dismissed', { ...pathOf(cueId, fact), body: { dismissed } })),
    onSuccess: () => invalidate(client, queryKeys.soundList(projectId, 'clarity')),
  })
}
