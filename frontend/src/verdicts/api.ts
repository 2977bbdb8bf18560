import { infiniteQueryOptions, type QueryClient, queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, del, everyPage, get, post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import { asked, isFiltered, type QueueFilter } from './queueFilter'
import { withoutUnderWay } from './underWay'

type Schemas = components['schemas']
export type QueueItem = Schemas['QueueItem']
export type QueuePage = Schemas['Page_QueueItem_']
export type QueueCount = Schemas['QueueCount']
export type ReviewTake = Schemas['ReviewTake']
export type ReviewCue = Schemas['ReviewCue']
export type ReviewFinding = Schemas['FindingRead']
export type BlockedTake = Schemas['BlockedTake']
export type CueReview = Schemas['CueReviewRead']
export type ChangeRequest = Schemas['ChangeRequestRead']
export type CarriedNote = Schemas['CarriedNote']
export type Sending = Schemas['FeedbackRead']

/** What a verdict changes elsewhere: lists and dashboards of the project, on any page. */
const TOUCHED = [
  queryKeys.today.all,
  queryKeys.overview.all,
  queryKeys.progress.all,
  queryKeys.judged.all,
  queryKeys.takeHistory.all,
  queryKeys.money.all,
]

const everyItem = async <T>(read: (cursor?: string) => Promise<{ items: T[]; next?: string | null }>): Promise<T[]> =>
  (await everyPage(read)).flatMap(({ items }) => items)

/** The cues that wait for the current person's verdict, or for another's if they approve none; urgent ones first. */
export const queueQuery = (projectId: string, filter: QueueFilter = {}) =>
  infiniteQueryOptions({
    queryKey: isFiltered(filter)
      ? queryKeys.reviewQueue(projectId, 'filtered', filter)
      : queryKeys.reviewQueue(projectId),
    queryFn: async ({ client, pageParam: cursor }) =>
      withoutUnderWay(
        client,
        await get('/v1/review-queue', { project_id: projectId, own: true, ...asked(filter), cursor }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

/** The first cues of the queue of which a version waits that the current person has not heard. */
export const firstUnheard = async (projectId: string, filter: QueueFilter): Promise<QueueItem[]> => {
  const query = { project_id: projectId, own: true, ...asked({ ...filter, heard: 'no' }) }
  return (await unwrap(api.GET('/v1/review-queue', { params: { query } }))).items
}

/** How many cues wait for a verdict, those that are noted included. */
export const countQuery = (projectId: string, filter: QueueFilter = {}) =>
  queryOptions({
    queryKey: isFiltered(filter)
      ? queryKeys.reviewQueue(projectId, 'count', filter)
      : queryKeys.reviewQueue(projectId, 'count'),
    queryFn: () => get('/v1/review-queue/count', { project_id: projectId, own: true, ...asked(filter) }),
  })

export const reviewQuery = queryById('/v1/cues/{cue_id}/review', queryKeys.cueReview)

export const historyQuery = queryById('/v1/takes/{take_id}/history', queryKeys.takeHistory)

/** Changes that are noted and that do not send themselves. */
export const draftsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.changeRequests(projectId, 'draft'),
    queryFn: () =>
      everyItem((cursor) =>
        get('/v1/projects/{project_id}/change-requests', { project_id: projectId, state: 'draft', cursor }),
      ),
    select: (drafts) => drafts.filter(({ sends_at }) => sends_at === null),
  })

/** Refetch what a verdict, a change or a sending affected. */
export async function refresh(client: QueryClient, projectId: string): Promise<void> {
  await invalidate(
    client,
    queryKeys.reviewQueue(projectId),
    queryKeys.changeRequests(projectId, 'draft'),
    queryKeys.cueReview.all,
    ...TOUCHED,
  )
}

/** Send every draft together. */
export function useSendFeedback(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (note: string) => post('/v1/projects/{project_id}/feedback', { project_id: projectId }, { note }),
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })
}

/** Take a draft back before it is sent. */
export function useDropDraft(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (draft: ChangeRequest) =>
      del('/v1/change-requests/{change_request_id}', { change_request_id: draft.id }),
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })
}
