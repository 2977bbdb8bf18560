import { type InfiniteData, type QueryClient, type QueryKey, useQueryClient } from '@tanstack/react-query'
import { useState } from 'react'

import { api, newIdempotencyKey, unwrap, useMutation } from '@/api'
import { answerOrOptimistic, offlineOutbox, waitingId } from '@/api/offlineOutbox'
import { type Me, meQuery } from '@/api/me'
import { queryKeys } from '@/api/queryKeys'
import { dismissToast, showToast, TOAST_MS as UNDO_MS } from '@/app/toast'

import { withDraft, withoutPicks, withoutVerdict, withPicks, withVerdictBack } from './afterVerdict'
import {
  countQuery,
  type CueReview,
  type QueueCount,
  type QueueItem,
  type QueuePage,
  queueQuery,
  refresh,
  type ReviewCue,
  type ReviewTake,
} from './api'
import { mentionsOf } from './mentionNames'
import type { QueueFilter } from './queueFilter'
import { underWay } from './underWay'

/** What was refused, in a sentence, and why. */
interface RefusedVerdict {
  about: string
  error: unknown
}

export interface ChangeNote {
  note: string
  /** Chosen of the studio's list; the note has those of a change too. */
  reasons: readonly string[]
  startS?: number
  endS?: number
}

/** Send a verdict; `onKept` is called where it waits for the connection, to be sent later. */
const giveVerdict = (
  take: ReviewTake,
  kind: 'approve' | 'request_change',
  { note, reasons, startS, endS }: ChangeNote,
  label: string,
  onKept: () => void,
  { mentions = [], key = newIdempotencyKey() }: { mentions?: string[]; key?: string } = {},
) =>
  unwrap(
    api.POST('/v1/takes/{take_id}/verdict', {
      params: { path: { take_id: take.id } },
      headers: { 'Idempotency-Key': key },
      body: {
        kind,
        note,
        reasons: [...reasons],
        start_s: startS,
        end_s: endS,
        seen_state: take.state,
        mentions,
        heard: take.is_heard,
        send: kind === 'request_change',
      },
      fetch: offlineOutbox.fetch(label, onKept),
    }),
  )

/** What follows a verdict in its toast: ": Fits the scene". */
const because = (reasons: readonly string[]): string => (reasons.length > 0 ? `: ${reasons.join(', ')}` : '')

/** A verdict that can be undone: of a take, and the key that it was sent with. */
interface Undoable {
  takeId: string
  key: string
}

const takeBack = ({ takeId, key }: Undoable, label: string, onKept: () => void) =>
  unwrap(
    api.DELETE('/v1/takes/{take_id}/verdict', {
      params: { path: { take_id: takeId } },
      fetch: offlineOutbox.fetch(label, onKept, key),
    }),
  )

/** A verdict was undone before it was sent, or an undo was dropped with the verdict that the server refused. */
const isDropped = (error: unknown): boolean => error instanceof DOMException && error.name === 'AbortError'

/** A change as it is shown until the server has it. */
function waitingDraft(
  client: QueryClient,
  cue: ReviewCue,
  take: ReviewTake,
  { note, reasons, startS, endS }: ChangeNote,
): NonNullable<ReviewTake['draft_change']> {
  const { id = '', name = 'You' } = client.getQueryData<Me>(meQuery.queryKey)?.person ?? {}
  return {
    id: waitingId(),
    take_id: take.id,
    cue_id: cue.id,
    cue_label: cue.label,
    cue_name: cue.name,
    variation: take.variation,
    number: take.number,
    text: note,
    reasons: [...reasons],
    mentions: [],
    start_s: startS ?? null,
    end_s: endS ?? null,
    reverses: false,
    written_by: { id, name },
    created_at: new Date().toISOString(),
    feedback_id: null,
    sends_at: new Date(Date.now() + UNDO_MS).toISOString(),
    sent_at: null,
  }
}

const cuesOf = (pages: readonly QueuePage[] = []): number => pages.reduce((sum, { items }) => sum + items.length, 0)

interface ChangeAsked {
  cue: ReviewCue
  takes: readonly ReviewTake[]
  /** What they are called: "A", "_02". */
  name: string
  said: ChangeNote
}

interface Decision {
  cue: ReviewCue
  takes: readonly ReviewTake[]
  /** Which of them were approved. */
  picked: readonly ReviewTake[]
  /** What was done, for the toast: "shield_hit A approved." */
  done: string
  /** What was asked, for a refusal: "shield_hit A is not approved." */
  refused: string
}

/** Give verdicts: at once on the screen, then on the server; what is refused comes back with its reason. */
export function useVerdicts(projectId: string, onBack?: (cueId: string) => void, filter?: QueueFilter) {
  const client = useQueryClient()
  const [refusal, setRefusal] = useState<RefusedVerdict | null>(null)
  const queueKey: QueryKey = queueQuery(projectId, filter).queryKey
  const countKey: QueryKey = countQuery(projectId, filter).queryKey

  /** Wait for what began; lists are read again once nothing else is under way. */
  const end = async (sent: Promise<unknown>, onRefused: (error: unknown) => void) => {
    await sent.catch((error: unknown) => {
      if (!isDropped(error)) onRefused(error)
    })
    const here = underWay(client)
    here.count -= 1
    if (here.count > 0) return
    here.decisions.clear()
    await refresh(client, projectId)
  }

  const decide = async (
    decided: Decision,
    send: (onKept: () => void) => Promise<unknown>,
    undoOn: readonly Undoable[],
  ) => {
    setRefusal(null)
    underWay(client).count += 1
    const verdict = { cueId: decided.cue.id, takeIds: decided.takes.map(({ id }) => id), picked: true }
    const withoutIt = (items: QueueItem[]) => withoutVerdict(items, verdict)
    underWay(client).decisions.add(withoutIt)
    const before = client.getQueryData<InfiniteData<QueuePage>>(queueKey)
    const pages = before?.pages.map((page) => ({ ...page, items: withoutIt(page.items) }))
    if (before && pages) client.setQueryData(queueKey, { ...before, pages })
    const changeCount = (by: number) =>
      client.setQueryData<QueueCount>(countKey, (count) =>
        count?.is_all ? { ...count, cues: count.cues + by } : count,
      )
    changeCount(cuesOf(pages) - cuesOf(before?.pages))
    const reviewKey = queryKeys.cueReview(decided.cue.id)
    const reviewBefore = client.getQueryData<CueReview>(reviewKey)
    const pickedIds = decided.picked.map(({ id }) => id)
    client.setQueryData<CueReview>(reviewKey, (review) => review && withPicks(review, pickedIds))
    // Only now: a page that is asked for while they end is added to what is here by then.
    await Promise.all(
      [queryKeys.reviewQueue(projectId), reviewKey].map((queryKey) => client.cancelQueries({ queryKey })),
    )
    let isKept = false
    const sent = send(() => (isKept = true))

    const putBack = () => {
      underWay(client).decisions.delete(withoutIt)
      const now = client.getQueryData<InfiniteData<QueuePage>>(queueKey)
      const again = now && withVerdictBack(now.pages, before?.pages ?? [], verdict)
      if (now && again) client.setQueryData(queueKey, { ...now, pages: again })
      if (reviewBefore) {
        client.setQueryData<CueReview>(reviewKey, (review) => review && withoutPicks(review, reviewBefore, pickedIds))
      }
      changeCount(cuesOf(again) - cuesOf(now?.pages))
    }
    const showAgain = () => {
      putBack()
      onBack?.(decided.cue.id)
    }
    const undo = async () => {
      underWay(client).count += 1
      const atServer = undoOn.filter(({ key }) => !offlineOutbox.drop(key))
      let isUndoKept = false
      const undone = async (onKept: () => void) => {
        const noteKept = () => {
          isUndoKept = true
          onKept()
        }
        const sent = Promise.all(atServer.map((undoable) => takeBack(undoable, `undo of “${decided.done}”`, noteKept)))
        void end(sent, (error) => {
          if (!isUndoKept) setRefusal({ about: `${decided.done} It stays so.`, error })
        })
        await sent
      }
      await answerOrOptimistic(undone, () => undefined).then(showAgain, () => undefined)
    }
    showToast(decided.done, undo)
    await end(sent, (error) => {
      putBack()
      dismissToast()
      // A refusal that comes later stands above every page, and leads nobody away from what they do then.
      if (!isKept) {
        setRefusal({ about: decided.refused, error })
        onBack?.(decided.cue.id)
      }
    })
  }

  const approve = (cue: ReviewCue, takes: readonly ReviewTake[], name: string, reasons: readonly string[] = []) => {
    const label = `${cue.name} ${name} approved`
    const keyed = takes.map((take) => ({ take, key: newIdempotencyKey() }))
    // All are kept before the first is sent: they are sent in this order.
    const send = (onKept: () => void) =>
      Promise.all(
        keyed.map(({ take, key }) => giveVerdict(take, 'approve', { note: '', reasons }, label, onKept, { key })),
      )
    return decide(
      {
        cue,
        takes,
        picked: takes,
        done: `${label}${because(reasons)}.`,
        refused: `${cue.name} ${name} is not approved.`,
      },
      send,
      keyed.map(({ take, key }) => ({ takeId: take.id, key })).reverse(),
    )
  }

  /** Accept a set with the takes that were picked, one a variation. */
  const acceptSet = (
    cue: ReviewCue,
    waiting: readonly ReviewTake[],
    picked: readonly ReviewTake[],
    reasons: readonly string[] = [],
  ) => {
    const key = newIdempotencyKey()
    return decide(
      {
        cue,
        takes: waiting,
        picked,
        done: `The set of ${cue.variations} for ${cue.name} accepted${because(reasons)}.`,
        refused: `The set for ${cue.name} is not accepted.`,
      },
      (onKept) =>
        unwrap(
          api.POST('/v1/cues/{cue_id}/accept-set', {
            params: { path: { cue_id: cue.id } },
            headers: { 'Idempotency-Key': key },
            body: {
              note: '',
              reasons: [...reasons],
              take_ids: picked.map(({ id }) => id),
              heard_take_ids: picked.filter(({ is_heard: isHeard }) => isHeard).map(({ id }) => id),
            },
            fetch: offlineOutbox.fetch(`the set for ${cue.name} accepted`, onKept),
          }),
        ),
      picked.slice(0, 1).map(({ id }) => ({ takeId: id, key })),
    )
  }

  /** Where a change of takes stands in the queue and in their cue's review: requested, or not any more. */
  const showDraft = (cueId: string, takeId: string, draft: ReviewTake['draft_change']) => {
    client.setQueryData<InfiniteData<QueuePage>>(queueKey, (before) => before && withDraft(before, takeId, draft))
    client.setQueryData<CueReview>(
      queryKeys.cueReview(cueId),
      (review) =>
        review && {
          ...review,
          takes: review.takes.map((take) => (take.id === takeId ? { ...take, draft_change: draft } : take)),
        },
    )
  }
  const change = useMutation({
    mutationFn: async ({ cue, takes, said }: ChangeAsked) => {
      const label = `change request “${said.note}”`
      const sent: Undoable[] = []
      for (const take of takes) {
        const key = newIdempotencyKey()
        const mentions = await mentionsOf(client, take.id, said.note)
        const draft = await answerOrOptimistic(
          async (onKept) => (await giveVerdict(take, 'request_change', said, label, onKept, { mentions, key })).draft,
          () => waitingDraft(client, cue, take, said),
        )
        sent.push({ takeId: take.id, key })
        // Lists are refetched later than the next cue is opened: what was noted must not come again meanwhile.
        showDraft(cue.id, take.id, draft)
      }
      return sent
    },
    onSuccess: (sent, { cue, name }) => {
      const undo = async () => {
        const atServer = sent.filter(({ key }) => !offlineOutbox.drop(key))
        await answerOrOptimistic(
          (onKept) =>
            Promise.all(atServer.map((undoable) => takeBack(undoable, `undo of the change of ${cue.name}`, onKept))),
          () => undefined,
        ).then(
          () => {
            for (const { takeId } of sent) showDraft(cue.id, takeId, null)
            onBack?.(cue.id)
          },
          (error: unknown) => setRefusal({ about: `The change of ${cue.name} ${name} is sent.`, error }),
        )
        await refresh(client, projectId)
      }
      showToast(`Change requested: ${cue.name} ${name}.`, undo)
    },
    // Not awaited: the confirmation is shown before the lists are refetched.
    onSettled: () => void refresh(client, projectId),
  })

  return { approve, acceptSet, change, refusal }
}

export type Verdicts = ReturnType<typeof useVerdicts>
