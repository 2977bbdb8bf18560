import { useQueryClient } from '@tanstack/react-query'

import { del, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Posting = Schemas['PostingRead']
export type PostingSummary = Schemas['PostingSummary']
export type PostingAdd = Schemas['PostingAdd']
export type PostingPreview = Schemas['PostingPreview']
export type Comparison = Schemas['BidComparison']
export type BidNote = Schemas['BidNoteRead']
export type ComparedBid = Schemas['ComparedBid']
export type BidLine = Schemas['BidLine']
export type BidContent = Schemas['BidContent']
export type AskedLine = Schemas['AskedLine']
export type AskedCue = Schemas['AskedCue']

const CHECKED_SOON_MS = 2000

export const postingsQuery = queryById('/v1/projects/{project_id}/postings', queryKeys.postings)

export const postingQuery = queryById('/v1/postings/{posting_id}', queryKeys.posting, {
  refetchInterval: ({ state: { data } }) =>
    data?.own_bid?.samples.some(({ state }) => state === 'pending') ? CHECKED_SOON_MS : false,
})

/** How the studio of a posting worked with designers so far. */
export const studioRecordQuery = queryById('/v1/postings/{posting_id}/studio-record', queryKeys.studioRecord)

/** The cues that the lines of a posting count. */
export const askedCuesQuery = queryById('/v1/postings/{posting_id}/cues', queryKeys.askedCues)

export const comparisonQuery = queryById('/v1/postings/{posting_id}/bids', queryKeys.bids)

export const linkQuery = queryById('/v1/posting-links/{secret}', queryKeys.postingLink)

/** Has a link of one's own mailed, by the link for everyone. */
export const useAskForLink = (secret: string) =>
  useMutation({
    mutationFn: (email: string) => post('/v1/posting-links/{secret}/ask', { secret }, { email }),
  })

/** Signs in by a personal link, with an account made now if its address has none. */
export const useOpenAccount = (secret: string) =>
  useMutation({
    mutationFn: (body: { name: string | null; password: string }) =>
      post('/v1/posting-links/{secret}/account', { secret }, body),
  })

export const useJoin = (secret: string) =>
  useMutation({
    mutationFn: () => post('/v1/posting-links/{secret}/join', { secret }),
  })

export const useCreatePosting = (projectId: string) =>
  useMutation({
    mutationFn: (body: PostingAdd) => post('/v1/projects/{project_id}/postings', { project_id: projectId }, body),
    affects: [queryKeys.postings(projectId)],
  })

/** A change of one posting, whose answer is the posting as it stands. */
function usePostingChange<T>(postingId: string, change: (value: T) => Promise<Posting>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (posting) => {
      client.setQueryData(postingQuery(postingId).queryKey, posting)
      return invalidate(client, queryKeys.postings(posting.project_id), queryKeys.effort(posting.project_id))
    },
  })
}

export const useSavePosting = (postingId: string) =>
  usePostingChange(postingId, (body: PostingAdd & { revision: number }) =>
    put('/v1/postings/{posting_id}', { posting_id: postingId }, body),
  )

export const useMovePosting = (postingId: string) =>
  usePostingChange(postingId, (to: 'open' | 'close') =>
    to === 'open'
      ? post('/v1/postings/{posting_id}/open', { posting_id: postingId })
      : post('/v1/postings/{posting_id}/close', { posting_id: postingId }),
  )

export const useInvite = (postingId: string) =>
  usePostingChange(postingId, (email: string) =>
    post('/v1/postings/{posting_id}/candidates', { posting_id: postingId }, { email }),
  )

export const useWithdrawCandidate = (postingId: string) =>
  useMutation({
    mutationFn: (candidateId: string) =>
      del('/v1/postings/{posting_id}/candidates/{candidate_id}', { posting_id: postingId, candidate_id: candidateId }),
    affects: [queryKeys.posting(postingId)],
  })

export const useMakeLink = (postingId: string) =>
  useMutation({
    mutationFn: () => post('/v1/postings/{posting_id}/link', { posting_id: postingId }),
    affects: [queryKeys.posting(postingId)],
  })

export const useRevokeLink = (postingId: string) =>
  useMutation({
    mutationFn: () => del('/v1/postings/{posting_id}/link', { posting_id: postingId }),
    affects: [queryKeys.posting(postingId)],
  })

export const useAnswer = (postingId: string) =>
  usePostingChange(postingId, ({ id, text, forAll }: { id: string; text: string; forAll: boolean }) =>
    post(
      '/v1/posting-questions/{posting_question_id}/answer',
      { posting_question_id: id },
      { text, is_for_all: forAll },
    ),
  )

export const useAsk = (postingId: string) =>
  usePostingChange(postingId, (text: string) =>
    post('/v1/postings/{posting_id}/questions', { posting_id: postingId }, { text }),
  )

export const useAddSample = (postingId: string) =>
  usePostingChange(postingId, (body: Schemas['SampleAdd']) =>
    post('/v1/postings/{posting_id}/bid/samples', { posting_id: postingId }, body),
  )

export const useRemoveSample = (postingId: string) =>
  usePostingChange(postingId, (id: string) => del('/v1/bid-samples/{bid_sample_id}', { bid_sample_id: id }))

export const useSaveBid = (postingId: string) =>
  usePostingChange(postingId, (body: BidContent & { revision: number }) =>
    put('/v1/postings/{posting_id}/bid', { posting_id: postingId }, body),
  )

export const useSendBid = (postingId: string) =>
  usePostingChange(postingId, (revision: number) =>
    post('/v1/postings/{posting_id}/bid/send', { posting_id: postingId }, { revision }),
  )

export const useWithdrawBid = (postingId: string) =>
  usePostingChange<undefined>(postingId, () =>
    post('/v1/postings/{posting_id}/bid/withdraw', { posting_id: postingId }),
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
    put('/v1/bids/{bid_id}/shortlist', { bid_id: id }, { is_shortlisted: on }),
  )

export const useScore = (postingId: string) =>
  useBidChange(postingId, ({ id, ...body }: { id: string; scores: Record<string, number>; note: string }) =>
    put('/v1/bids/{bid_id}/scores', { bid_id: id }, body),
  )

export const useAddNote = (postingId: string) =>
  useBidChange(postingId, ({ id, ...body }: { id: string } & Schemas['BidNoteWrite']) =>
    post('/v1/bids/{bid_id}/notes', { bid_id: id }, body),
  )

export const useRemoveNote = (postingId: string) =>
  useBidChange(postingId, ({ id, noteId }: { id: string; noteId: string }) =>
    del('/v1/bids/{bid_id}/notes/{bid_note_id}', { bid_id: id, bid_note_id: noteId }),
  )

export const useAward = (postingId: string) =>
  useMutation({
    mutationFn: (bidId: string) => post('/v1/bids/{bid_id}/award', { bid_id: bidId }),
    affects: [
      queryKeys.bids(postingId),
      queryKeys.posting(postingId),
      queryKeys.postings.all,
      queryKeys.nextSteps.all,
      queryKeys.project.all,
    ],
  })
