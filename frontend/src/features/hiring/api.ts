import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Posting = Schemas['PostingRead']
export type PostingSummary = Schemas['PostingSummary']
export type PostingAdd = Schemas['PostingAdd']
export type PostingPreview = Schemas['PostingPreview']
export type Comparison = Schemas['BidComparison']
export type ComparedBid = Schemas['ComparedBid']
export type BidLine = Schemas['BidLine']
export type BidContent = Schemas['BidContent']
export type AskedLine = Schemas['AskedLine']
export type AskedCue = Schemas['AskedCue']

const CHECKED_SOON_MS = 2000
const at = (postingId: string) => ({ params: { path: { posting_id: postingId } } })

export const postingsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.postings(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/postings', { params: { path: { project_id: projectId } } })),
  })

export const postingQuery = (postingId: string) =>
  queryOptions({
    queryKey: queryKeys.posting(postingId),
    queryFn: () => answered(api.GET('/v1/postings/{posting_id}', at(postingId))),
    refetchInterval: ({ state: { data } }) =>
      data?.own_bid?.samples.some(({ state }) => state === 'pending') ? CHECKED_SOON_MS : false,
  })

/** How the studio of a posting worked with designers so far. */
export const studioRecordQuery = (postingId: string) =>
  queryOptions({
    queryKey: queryKeys.studioRecord(postingId),
    queryFn: () => answered(api.GET('/v1/postings/{posting_id}/studio-record', at(postingId))),
  })

/** The cues that the lines of a posting count. */
export const askedCuesQuery = (postingId: string) =>
  queryOptions({
    queryKey: queryKeys.askedCues(postingId),
    queryFn: () => answered(api.GET('/v1/postings/{posting_id}/cues', at(postingId))),
  })

export const comparisonQuery = (postingId: string) =>
  queryOptions({
    queryKey: queryKeys.bids(postingId),
    queryFn: () => answered(api.GET('/v1/postings/{posting_id}/bids', at(postingId))),
  })

export const linkQuery = (secret: string) =>
  queryOptions({
    queryKey: queryKeys.postingLink(secret),
    queryFn: () => answered(api.GET('/v1/posting-links/{secret}', { params: { path: { secret } } })),
  })

/** Has a link of one's own mailed, by the link for everyone. */
export const useAskForLink = (secret: string) =>
  useMutation({
    mutationFn: (email: string) =>
      answered(api.POST('/v1/posting-links/{secret}/ask', { params: { path: { secret } }, body: { email } })),
  })

/** Signs in by a personal link, with an account made now if its address has none. */
export const useOpenAccount = (secret: string) =>
  useMutation({
    mutationFn: (body: { name: string | null; password: string }) =>
      answered(api.POST('/v1/posting-links/{secret}/account', { params: { path: { secret } }, body })),
  })

export const useJoin = (secret: string) =>
  useMutation({
    mutationFn: () => answered(api.POST('/v1/posting-links/{secret}/join', { params: { path: { secret } } })),
  })

export function useCreatePosting(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: PostingAdd) =>
      answered(api.POST('/v1/projects/{project_id}/postings', { params: { path: { project_id: projectId } }, body })),
    onSuccess: () => invalidate(client, queryKeys.postings(projectId)),
  })
}

/** A change of one posting, whose answer is the posting as it stands. */
function usePostingChange<T>(postingId: string, change: (value: T) => Promise<Posting>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (posting) => {
      client.setQueryData(postingQuery(postingId).queryKey, posting)
      return invalidate(client, queryKeys.postings(posting.project_id))
    },
  })
}

export const useSavePosting = (postingId: string) =>
  usePostingChange(postingId, (body: PostingAdd & { revision: number }) =>
    answered(api.PUT('/v1/postings/{posting_id}', { ...at(postingId), body })),
  )

export const useMovePosting = (postingId: string) =>
  usePostingChange(postingId, (to: 'open' | 'close') =>
    answered(
      to === 'open'
        ? api.POST('/v1/postings/{posting_id}/open', at(postingId))
        : api.POST('/v1/postings/{posting_id}/close', at(postingId)),
    ),
  )

export const useInvite = (postingId: string) =>
  usePostingChange(postingId, (email: string) =>
    answered(api.POST('/v1/postings/{posting_id}/candidates', { ...at(postingId), body: { email } })),
  )

export function useWithdrawCandidate(postingId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (candidateId: string) =>
      answered(
        api.DELETE('/v1/postings/{posting_id}/candidates/{candidate_id}', {
          params: { path: { posting_id: postingId, candidate_id: candidateId } },
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.posting(postingId)),
  })
}

export function useMakeLink(postingId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.POST('/v1/postings/{posting_id}/link', at(postingId))),
    onSuccess: () => invalidate(client, queryKeys.posting(postingId)),
  })
}

export function useRevokeLink(postingId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.DELETE('/v1/postings/{posting_id}/link', at(postingId))),
    onSuccess: () => invalidate(client, queryKeys.posting(postingId)),
  })
}

export const useAnswer = (postingId: string) =>
  usePostingChange(postingId, ({ id, text, forAll }: { id: string; text: string; forAll: boolean }) =>
    answered(
      api.POST('/v1/posting-questions/{posting_question_id}/answer', {
        params: { path: { posting_question_id: id } },
        body: { text, is_for_all: forAll },
      }),
    ),
  )

export const useAsk = (postingId: string) =>
  usePostingChange(postingId, (text: string) =>
    answered(api.POST('/v1/postings/{posting_id}/questions', { ...at(postingId), body: { text } })),
  )

export const useAddSample = (postingId: string) =>
  usePostingChange(postingId, (body: Schemas['SampleAdd']) =>
    answered(api.POST('/v1/postings/{posting_id}/bid/samples', { ...at(postingId), body })),
  )

export const useRemoveSample = (postingId: string) =>
  usePostingChange(postingId, (id: string) =>
    answered(api.DELETE('/v1/bid-samples/{bid_sample_id}', { params: { path: { bid_sample_id: id } } })),
  )

export const useSaveBid = (postingId: string) =>
  usePostingChange(postingId, (body: BidContent & { revision: number }) =>
    answered(api.PUT('/v1/postings/{posting_id}/bid', { ...at(postingId), body })),
  )

export const useSendBid = (postingId: string) =>
  usePostingChange(postingId, (revision: number) =>
    answered(api.POST('/v1/postings/{posting_id}/bid/send', { ...at(postingId), body: { revision } })),
  )

export const useWithdrawBid = (postingId: string) =>
  usePostingChange<undefined>(postingId, () =>
    answered(api.POST('/v1/postings/{posting_id}/bid/withdraw', at(postingId))),
  )

/** A change of one bid, whose answer is the comparison as it stands. */
function useBidChange<T>(postingId: string, change: (value: T) => Promise<Comparison>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (comparison) => client.setQueryData(comparisonQuery(postingId).queryKey, comparison),
  })
}

export const useShortlist = (postingId: string) =>
  useBidChange(postingId, ({ id, on }: { id: string; on: boolean }) =>
    answered(
      api.PUT('/v1/bids/{bid_id}/shortlist', { params: { path: { bid_id: id } }, body: { is_shortlisted: on } }),
    ),
  )

export const useScore = (postingId: string) =>
  useBidChange(postingId, ({ id, ...body }: { id: string; scores: Record<string, number>; note: string }) =>
    answered(api.PUT('/v1/bids/{bid_id}/scores', { params: { path: { bid_id: id } }, body })),
  )

export function useAward(postingId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (bidId: string) =>
      answered(api.POST('/v1/bids/{bid_id}/award', { params: { path: { bid_id: bidId } } })),
    onSuccess: () =>
      invalidate(
        client,
        queryKeys.bids(postingId),
        queryKeys.posting(postingId),
        queryKeys.postings.all,
        queryKeys.nextSteps.all,
        queryKeys.project.all,
      ),
  })
}
