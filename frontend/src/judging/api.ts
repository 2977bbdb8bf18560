import {
  infiniteQueryOptions,
  type QueryClient,
  queryOptions,
  useMutation,
  useQueryClient,
} from '@tanstack/react-query'

import { answered, api, everyPage } from '@/api'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type QueueItem = Schemas['QueueItem']
export type QueuePage = Schemas['Page_QueueItem_']
export type QueueCount = Schemas['QueueCount']
export type ReviewTake = Schemas['ReviewTake']
export type ReviewCue = Schemas['ReviewCue']
export type ReviewFinding = Schemas['FindingRead']
export type CueReview = Schemas['CueReviewRead']
export type ChangeRequest = Schemas['ChangeRequestRead']
export type CarriedNote = Schemas['CarriedNote']
export type Sending = Schemas['FeedbackRead']

/** Where the answers that reviewing rests on are kept. */
export const keys = {
  queue: (projectId: string) => ['review-queue', projectId] as const,
  queueCount: (projectId: string) => ['review-queue', projectId, 'count'] as const,
  review: (cueId: string) => ['cue-review', cueId] as const,
  drafts: (projectId: string) => ['change-requests', projectId, 'draft'] as const,
  history: (takeId: string) => ['take-history', takeId] as const,
}

/** What a verdict changes elsewhere: lists and dashboards of the project, on any page. */
const TOUCHED = ['today', 'overview', 'progress', 'judged', 'take-history', 'money']

const everyItem = async <T>(read: (cursor?: string) => Promise<{ items: T[]; next?: string | null }>): Promise<T[]> =>
  (await everyPage(read)).flatMap(({ items }) => items)

/** The cues that wait for a verdict, the oldest first, as far as they were asked for. */
export const queueQuery = (projectId: string) =>
  infiniteQueryOptions({
    queryKey: keys.queue(projectId),
    queryFn: ({ pageParam: cursor }) =>
      answered(api.GET('/v1/review-queue', { params: { query: { project_id: projectId, cursor } } })),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

/** How many cues wait for a verdict, those that are noted included. */
export const countQuery = (projectId: string) =>
  queryOptions({
    queryKey: keys.queueCount(projectId),
    queryFn: () => answered(api.GET('/v1/review-queue/count', { params: { query: { project_id: projectId } } })),
  })

export const reviewQuery = (cueId: string) =>
  queryOptions({
    queryKey: keys.review(cueId),
    queryFn: () => answered(api.GET('/v1/cues/{cue_id}/review', { params: { path: { cue_id: cueId } } })),
  })

/** Changes that are noted and not sent. */
export const draftsQuery = (projectId: string) =>
  queryOptions({
    queryKey: keys.drafts(projectId),
    queryFn: () =>
      everyItem((cursor) =>
        answered(
          api.GET('/v1/projects/{project_id}/change-requests', {
            params: { path: { project_id: projectId }, query: { state: 'draft', cursor } },
          }),
        ),
      ),
  })

/** Refetch what a verdict, a change or a sending affected. */
export async function refresh(client: QueryClient, projectId: string): Promise<void> {
  const touched = [keys.queue(projectId), keys.drafts(projectId), ['cue-review'], ...TOUCHED.map((key) => [key])]
  await Promise.all(touched.map((queryKey) => client.invalidateQueries({ queryKey })))
}

/** Send every draft together. */
export function useSendFeedback(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (note: string) =>
      answered(
        api.POST('/v1/projects/{project_id}/feedback', {
          params: { path: { project_id: projectId } },
          body: { note },
        }),
      ),
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })
}

/** Take a draft back before it is sent. */
export function useDropDraft(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (draft: ChangeRequest) =>
      answered(
        api.DELETE('/v1/change-requests/{change_request_id}', {
          params: { path: { change_request_id: draft.id } },
        }),
      ),
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })
}
