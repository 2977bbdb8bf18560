import { queryOptions, useMutation, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'
import { ARRIVALS_MS, refresh } from '@/judging/api'

export type TodayAnswer = components['schemas']['Today']
export type AskedQuestion = components['schemas']['AskedQuestion']

export const todayQuery = (projectId: string) =>
  queryOptions({
    queryKey: ['today', projectId],
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/today', { params: { path: { project_id: projectId } } })),
    refetchInterval: ARRIVALS_MS,
  })

export function useAnswer(projectId: string, questionId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (text: string) =>
      answered(
        api.POST('/v1/questions/{question_id}/answer', {
          params: { path: { question_id: questionId } },
          body: { text, joins: true },
        }),
      ),
    // Not waited for: what was done is said before the lists are read anew.
    onSettled: () => void refresh(client, projectId),
  })
}
