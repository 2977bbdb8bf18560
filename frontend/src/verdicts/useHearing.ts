import { useQueryClient } from '@tanstack/react-query'
import { useEffect, useMemo, useRef } from 'react'

import type { Player, Source } from '@/audio'

import type { QueueItem, ReviewTake } from './api'
import { AS_SENT, type Gains, MASTER, soundOf, sourceOf } from './hearing'

/** Where a sound plays in its scene. */
export interface Placing {
  place: NonNullable<Source['place']>
  /** When it first plays. */
  startS: number
}

/**
 * Keep the selected take in the player, from the start of every cue and silent until it is asked for; with a placing
 * where it plays in its scene.
 */
export function useHearing(
  player: Player,
  cueId: string | undefined,
  take: ReviewTake | undefined,
  target: string = MASTER,
  gains: Gains = AS_SENT,
  placing: Placing | null = null,
): Source | null {
  const placedAtS = useRef(0)
  useEffect(() => {
    player.pause()
    player.setRange(null)
    player.setReversed(false)
    player.seek(0)
  }, [player, cueId])

  const source = useMemo(() => {
    const alone = take ? sourceOf(take, target, gains) : null
    return alone && placing ? { ...alone, place: placing.place } : alone
  }, [take, target, gains, placing])
  const startS = placing?.startS ?? 0
  useEffect(() => {
    if (source === null) player.pause()
    else void player.select(source, startS - placedAtS.current)
    placedAtS.current = startS
  }, [player, source, startS])
  return source
}

/** Of so many sounds farther down the queue the first bytes are fetched, */
const BEGUN = 24
/** where they are so long: shorter ones have no light preview. */
const LONG_S = 5

/**
 * Have what is heard now, and what the next cue needs, fetched and decoded in this order once sounds may be fetched;
 * of later cues what can be heard soonest, and of the others the first bytes.
 */
export function useReady(
  player: Player,
  takes: readonly ReviewTake[],
  next: QueueItem | undefined,
  later: readonly QueueItem[] = [],
  others: readonly QueueItem[] = [],
): void {
  const list = urlsOf([...takes, ...(next?.takes ?? [])])
  const laterList = urlsOf(later.flatMap((item) => item.takes))
  const otherList = urlsOf(others.flatMap((item) => item.takes.filter(isLong)).slice(0, BEGUN))
  useEffect(() => {
    const [now = [], soon, begun] = [list, laterList, otherList].map((urls) => urls.split('\n').filter(Boolean))
    player.previews.keepReady(now, soon, begun)
  }, [player, list, laterList, otherList])
}

const isLong = (take: ReviewTake): boolean => soundOf(take, MASTER).durationS >= LONG_S

const urlsOf = (takes: readonly ReviewTake[]): string => takes.flatMap((take) => take.preview_url ?? []).join('\n')

/** Let sounds be fetched once the page shows what it is for and asks for nothing more: a preview is as large as all else. */
export function useRelease(player: Player, isShown: boolean): void {
  const client = useQueryClient()
  useEffect(() => {
    if (!isShown) return undefined
    const releaseOnceQuiet = () => {
      if (client.isFetching() === 0) player.previews.release()
    }
    releaseOnceQuiet()
    return client.getQueryCache().subscribe(releaseOnceQuiet)
  }, [player, client, isShown])
}
