import { useEffect, useMemo } from 'react'

import type { Player, Source } from '@/audio'

import type { QueueItem, ReviewTake } from './api'
import { MASTER, sourceOf } from './hearing'

/** Keep the take in the hand in the player, from the start of every cue and silent until it is asked for. */
export function useHearing(
  player: Player,
  cueId: string | undefined,
  take: ReviewTake | undefined,
  target: string = MASTER,
  reference?: ReviewTake,
): Source | null {
  useEffect(() => {
    player.pause()
    player.setRange(null)
    player.setReversed(false)
    player.seek(0)
  }, [player, cueId])

  const source = useMemo(() => (take ? sourceOf(take, target, reference) : null), [take, target, reference])
  useEffect(() => {
    if (source === null) player.pause()
    else void player.select(source)
  }, [player, source])
  return source
}

const AHEAD = 3

/** Have what is heard now, and what the next three cues need, fetched and decoded. */
export function useReady(player: Player, takes: readonly ReviewTake[], next: readonly QueueItem[]): void {
  const urls = [...takes, ...next.slice(0, AHEAD).flatMap((item) => item.takes)].flatMap(({ preview_url }) =>
    preview_url === null ? [] : [preview_url],
  )
  const list = urls.join('\n')
  useEffect(() => {
    player.previews.keepReady(list === '' ? [] : list.split('\n'))
  }, [player, list])
}
