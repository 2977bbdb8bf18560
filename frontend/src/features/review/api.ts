import { type QueryClient, queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, post, queryById, useMutation } from '@/api'
import { answerOrOptimistic, isWaitingId, offlineOutbox, waitingId } from '@/api/offlineOutbox'
import { type Me, meQuery } from '@/api/me'
import { overviewQuery } from '@/api/project'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { type CarriedNote, type CueReview, refresh } from '@/verdicts/api'
import { mentionsOf } from '@/verdicts/mentionNames'

type Schemas = components['schemas']
export type Comment = Schemas['CommentRead']
export type HistoryEntry = Schemas['HistoryEntry']
export type PaletteSound = Schemas['PaletteSound']

export type Judged = Schemas['RecentVerdict']

/** What was decided within a week, the newest first. */
export const judgedQuery = queryById('/v1/projects/{project_id}/judged-lately', queryKeys.judged)

/** The sounds that new ones are compared with. */
export const paletteQuery = (projectId: string) =>
  queryOptions({ ...overviewQuery(projectId), select: ({ palette }) => palette, staleTime: 60_000 })

export interface CommentSaid {
  takeId: string
  text: string
  startS?: number
  endS?: number
  /** The comment or the sent change request that it answers. */
  answers?: { reply_to_id?: string; change_request_id?: string }
}

export function useComment(cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (comment: CommentSaid) => {
      const { takeId, text, startS, endS, answers } = comment
      const mentions = await mentionsOf(client, takeId, text)
      const send = (onKept: () => void) =>
        unwrap(
          api.POST('/v1/takes/{take_id}/comments', {
            params: { path: { take_id: takeId } },
            body: { text, start_s: startS, end_s: endS, mentions, ...answers },
            fetch: offlineOutbox.fetch(`Comment “${text}”`, onKept),
          }),
        )
      return answerOrOptimistic(send, () => waitingComment(client, comment))
    },
    onSuccess: (comment) => {
      client.setQueryData<CueReview>(
        queryKeys.cueReview(cueId),
        (review) => review && { ...review, comments: [...review.comments, comment] },
      )
      if (isWaitingId(comment.id)) return
      return invalidate(client, queryKeys.cueReview(cueId), queryKeys.takeHistory(comment.take_id))
    },
  })
}

/** A comment as it is shown until the server has it. */
function waitingComment(client: QueryClient, { takeId, text, startS, endS, answers }: CommentSaid): Comment {
  const author = client.getQueryData<Me>(meQuery.queryKey)?.person
  return {
    id: waitingId(),
    take_id: takeId,
    reply_to_id: answers?.reply_to_id ?? null,
    change_request_id: answers?.change_request_id ?? null,
    text,
    start_s: startS ?? null,
    end_s: endS ?? null,
    author: { id: author?.id ?? null, name: author?.name ?? 'You', picture: author?.picture ?? null },
    decides: false,
    created_at: new Date().toISOString(),
    resolved_at: null,
    mentions: [],
    acknowledgements: [],
  }
}

/** Say whether a version does what a note on an earlier one asked. */
export function useAnswerNote(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ takeId, note, isDone }: { takeId: string; note: CarriedNote; isDone: boolean }) =>
      post('/v1/takes/{take_id}/carried-notes/{note_id}', { take_id: takeId, note_id: note.id }, { is_done: isDone }),
    onSuccess: (note) => {
      client.setQueryData<CueReview>(
        queryKeys.cueReview(cueId),
        (review) =>
          review && {
            ...review,
            carried_notes: review.carried_notes.map((item) => (item.id === note.id ? note : item)),
          },
      )
    },
    onSettled: () => invalidate(client, queryKeys.cueReview(cueId), queryKeys.reviewQueue(projectId)),
  })
}

/** Mark a comment as seen to, open it again, or acknowledge it. */
export function useMarkComment(cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ id, as }: { id: string; as: 'resolve' | 'reopen' | 'acknowledgement' }) =>
      post(`/v1/comments/{comment_id}/${as}`, { comment_id: id }),
    onSettled: () => invalidate(client, queryKeys.cueReview(cueId)),
  })
}

/** The game no longer needs a cue; it stays with its reason. */
export function useCut(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (reason: string) => post('/v1/cues/{cue_id}/cut', { cue_id: cueId }, { reason }),
    onSuccess: async () => {
      await Promise.all([refresh(client, projectId), invalidate(client, queryKeys.soundList.all)])
    },
  })
}

/** A returned take goes on although it does not conform; what was found stays. */
export function useWaive(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ takeId, reason }: { takeId: string; reason: string }) =>
      post('/v1/takes/{take_id}/waiver', { take_id: takeId }, { reason }),
    onSuccess: async () => {
      await Promise.all([
        refresh(client, projectId),
        invalidate(client, queryKeys.cueReview(cueId)),
        invalidate(client, queryKeys.soundList.all),
      ])
    },
  })
}
