import { keepPreviousData, queryOptions, useInfiniteQuery, useQueryClient } from '@tanstack/react-query'

import { del, get, patch, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Brief = Schemas['BriefDocument']
export type Topic = Schemas['BriefTopicRead']
export type Question = Schemas['BriefQuestionRead']
export type FollowUp = Schemas['FollowUpRead']
export type Decision = Schemas['DecisionRead']

/** An answer as it is sent. */
export interface AnswerWrite {
  value: unknown
  is_unknown: boolean
  note: string
}

export const briefQuery = queryById('/v1/projects/{project_id}/brief', queryKeys.brief)

/** Cues and hours that the answers lead to; `revision` is that of the answers. */
export const sizeQuery = (projectId: string, kit: string, revision: number) =>
  queryOptions({
    queryKey: queryKeys.sizeEstimate(projectId, kit, revision),
    queryFn: () => get('/v1/projects/{project_id}/size-estimate', { project_id: projectId, kit: kit || undefined }),
    placeholderData: keepPreviousData,
  })

export const readsQuery = queryById('/v1/projects/{project_id}/brief/reads', queryKeys.briefReads)

export const useBriefVersions = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.briefVersions(projectId),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/projects/{project_id}/brief/versions', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

export const comparisonQuery = (projectId: string, from: number, to: number | undefined) =>
  queryOptions({
    queryKey: queryKeys.briefComparison(projectId, from, to ?? 'now'),
    queryFn: () => get('/v1/projects/{project_id}/brief/compare', { project_id: projectId, from, to }),
  })

export function useSaveAnswers(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: { revision: number; answers: Record<string, AnswerWrite> }) =>
      patch('/v1/projects/{project_id}/brief', { project_id: projectId }, body),
    onSuccess: (brief) => {
      client.setQueryData(briefQuery(projectId).queryKey, brief)
      return invalidate(
        client,
        queryKeys.brief(projectId, 'spec'),
        queryKeys.coverage(projectId),
        queryKeys.nextSteps(projectId),
      )
    },
  })
}

export const usePublishBrief = (projectId: string) =>
  useMutation({
    mutationFn: (body: { revision: number; note: string }) =>
      post('/v1/projects/{project_id}/brief/versions', { project_id: projectId }, body),
    affects: [queryKeys.brief(projectId), queryKeys.briefVersions(projectId), queryKeys.briefReads(projectId)],
  })

export const useRecordRead = (projectId: string) =>
  useMutation({
    mutationFn: (version: number) =>
      put('/v1/projects/{project_id}/brief/versions/{version}/read', { project_id: projectId, version }),
  })

export const useAskFollowUp = (projectId: string) =>
  useMutation({
    mutationFn: (body: { question: string; text: string }) =>
      post('/v1/projects/{project_id}/brief/follow-ups', { project_id: projectId }, body),
    affects: [queryKeys.brief(projectId)],
  })

export const useAnswerFollowUp = (projectId: string) =>
  useMutation({
    mutationFn: ({ id, text }: { id: string; text: string }) =>
      post('/v1/brief-follow-ups/{follow_up_id}/answer', { follow_up_id: id }, { text }),
    affects: [queryKeys.brief(projectId)],
  })

/** What was decided before the contract. */
export const decisionsQuery = queryById('/v1/projects/{project_id}/decisions', queryKeys.decisions)

export const useSaveDecision = (projectId: string) =>
  useMutation({
    mutationFn: ({ id, body }: { id?: string; body: Schemas['DecisionWrite'] }) =>
      id === undefined
        ? post('/v1/projects/{project_id}/decisions', { project_id: projectId }, body)
        : put('/v1/decisions/{decision_id}', { decision_id: id }, body),
    affects: [queryKeys.decisions(projectId)],
  })

export function useRemoveDecision(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (id: string) => del('/v1/decisions/{decision_id}', { decision_id: id }),
    onSettled: () => invalidate(client, queryKeys.decisions(projectId)),
  })
}
