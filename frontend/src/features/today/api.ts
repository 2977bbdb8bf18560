import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { refresh } from '@/judging/api'

export type TodayAnswer = components['schemas']['Today']
export type AskedQuestion = components['schemas']['AskedQuestion']

export const todayQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.today(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/today', { params: { path: { project_id: projectId } } })),
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
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })
}
