import { isWaitingId } from '@/api/offlineOutbox'
import type { CommentMark } from '@/audio'
import type { CueReview, ReviewTake } from '@/verdicts/api'
import type { Mention } from '@/verdicts/mentionNames'

import type { Comment } from './api'

/** One thing said of a take: advice, or a change that the approver wants. */
export interface FeedbackItem {
  id: string
  takeId: string
  /** Its number in the wave and in the list; things said of the whole sound have none. */
  number: number | null
  who: string
  picture?: string | null
  decides: boolean
  kind: 'comment' | 'change'
  /** A change that is noted and not sent. */
  draft: boolean
  text: string
  mentions: readonly Mention[]
  startS: number | null
  endS: number | null
  at: string
  comment?: Comment
  /** What was answered to it, in order. */
  replies: readonly Comment[]
}

/** Everything said of these takes, in the order in which it was said; what has a place in the sound is numbered. */
export function toFeedback(review: CueReview, takes: readonly ReviewTake[]): FeedbackItem[] {
  const ids = new Set(takes.map(({ id }) => id))
  const repliesTo = (id: string) =>
    review.comments.filter(({ reply_to_id, change_request_id }) => reply_to_id === id || change_request_id === id)
  const all: Omit<FeedbackItem, 'number'>[] = [
    ...review.comments
      .filter(({ take_id, reply_to_id, change_request_id }) => ids.has(take_id) && !reply_to_id && !change_request_id)
      .map((comment) => ({
        id: comment.id,
        takeId: comment.take_id,
        who: comment.author.name,
        picture: comment.author.picture,
        decides: comment.decides,
        kind: 'comment' as const,
        draft: false,
        text: comment.text,
        mentions: comment.mentions,
        startS: comment.start_s,
        endS: comment.end_s,
        at: comment.created_at,
        comment: isWaitingId(comment.id) ? undefined : comment,
        replies: repliesTo(comment.id),
      })),
    ...review.change_requests
      .filter(({ take_id }) => ids.has(take_id))
      .map((change) => ({
        id: change.id,
        takeId: change.take_id,
        who: change.written_by.name,
        picture: change.written_by.picture,
        decides: true,
        kind: 'change' as const,
        draft: change.sent_at === null,
        text: change.text,
        mentions: change.mentions,
        startS: change.start_s,
        endS: change.end_s,
        at: change.created_at,
        replies: repliesTo(change.id),
      })),
  ]
  let number = 0
  return all
    .sort((a, b) => a.at.localeCompare(b.at))
    .map((item) => ({ ...item, number: item.startS === null ? null : (number += 1) }))
}

/** The markers in the waveform of one take. */
export function marksOf(items: readonly FeedbackItem[], takeId: string): CommentMark[] {
  return items.flatMap(({ id, number, startS, endS, takeId: of }) =>
    number === null || startS === null || of !== takeId
      ? []
      : [{ id, number, startS, endS: endS !== null && endS > startS ? endS : undefined }],
  )
}

/** What the author of a saying is to its reader, or that it is not sent yet. */
export function roleOfSaid({ id, kind, draft, decides }: FeedbackItem): string {
  if (isWaitingId(id)) return 'waits for the connection'
  if (kind === 'change') return draft ? 'draft change request' : 'requests a change'
  return decides ? 'approver' : 'advises'
}
