import { useEffect, useEffectEvent, useMemo, useState } from 'react'

import type { Player } from '@/audio'

import type { PlaylistTake } from './api'
import { useEnded } from './useEnded'

/** So many sounds after the current one are decoded before their turn, so that one follows another without a gap. */
const AHEAD = 3

export interface Playthrough {
  current: PlaylistTake | undefined
  /** Go to a version, and play it if asked or if another was playing. */
  open: (takeId: string, how?: { plays?: boolean; fromS?: number }) => Promise<void>
  step: (by: 1 | -1) => PlaylistTake | undefined
}

const sourceOf = ({ take_id, preview_url }: PlaylistTake) => ({
  id: take_id,
  takeId: take_id,
  url: preview_url ?? '',
})

/**
 * Plays takes one after another, but for one at whose end `stays` says so. `onBegin` hears of each that begins because
 * the one before it came to its end.
 */
export function usePlaythrough(
  player: Player,
  takes: readonly PlaylistTake[],
  start: { takeId: string | undefined; atS: number },
  onBegin: (take: PlaylistTake) => void,
  stays: () => boolean,
): Playthrough {
  const [currentId, setCurrentId] = useState(start.takeId ?? takes[0]?.take_id)
  const at = Math.max(
    0,
    takes.findIndex(({ take_id }) => take_id === currentId),
  )
  const current = takes[at]
  const urls = useMemo(
    () => takes.slice(at, at + 1 + AHEAD).flatMap(({ preview_url }) => preview_url ?? []),
    [takes, at],
  )
  useEffect(() => player.previews.keepReady(urls), [player, urls])

  const open: Playthrough['open'] = async (takeId, { plays = player.isPlaying(), fromS = 0 } = {}) => {
    const take = takes.find(({ take_id }) => take_id === takeId)
    if (!take?.preview_url) return
    setCurrentId(takeId)
    if (player.isPlaying()) player.pause()
    await player.select(sourceOf(take))
    if (plays) await player.play(fromS)
    else player.seek(fromS)
  }

  const begin = useEffectEvent(() => {
    if (current?.preview_url) void player.select(sourceOf(current)).then(() => player.seek(start.atS))
  })
  useEffect(() => begin(), [player])

  useEnded(player, () => {
    const next = takes[at + 1]
    if (next && !stays()) void open(next.take_id, { plays: true }).then(() => onBegin(next))
  })

  return { current, open, step: (by) => takes[at + by] }
}
