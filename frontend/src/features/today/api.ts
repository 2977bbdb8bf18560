import { useQueryClient } from '@tanstack/react-query'

import { post, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { refresh } from '@/verdicts/api'

export type TodayAnswer = components['schemas']['Today']
export type AskedQuestion = components['schemas']['AskedQuestion']

export const todayQuery = queryById('/v1/projects/{project_id}/today', queryKeys.today)

export function useAnswer(projectId: string, questionId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (text: string) =>
      post('/v1/questions/{question_id}/answer', { question_id: questionId }, { text, joins: true }),
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })
}
