import { useEffect, useEffectEvent, useState } from 'react'

import type { Player, PlayerState, Source } from '@/audio'
import { ENOUGH_S } from '@/heard/heardMeter'

import type { ReviewTake } from './api'

/** Takes as the current person knows them who has just heard some on this page. */
export const withHeard = (takes: readonly ReviewTake[], heardHere: ReadonlySet<string>): ReviewTake[] =>
  takes.map((take) => (!take.is_heard && heardHere.has(take.id) ? { ...take, is_heard: true } : take))

export interface FirstListen {
  /** What of the takes to approve is not heard yet. */
  unheard: readonly ReviewTake[]
  /** The one that plays for the first time, because its approval was asked for. */
  listening: ReviewTake | null
  /** All were heard because approval was asked for: asking again approves. */
  isOver: boolean
  /** Approve takes that were all heard; otherwise play what was not, and decide nothing. */
  approveHeard: (takes: readonly ReviewTake[], approve: () => void) => void
  stop: () => void
}

interface Listened {
  player: Player
  playing: PlayerState
  /** What an approval is for. */
  takes: readonly ReviewTake[]
  /** Show a take and play it from its start. */
  play: (take: ReviewTake) => void
}

/** Play a sound from its start: all of it, and forwards. */
export function playWhole(player: Player, source: Source): void {
  player.setRange(null)
  player.setReversed(false)
  void player.select(source)
  void player.play(0)
}

/** Have versions played from their start, one after another, before they can be approved. */
export function useFirstListen({ player, playing, takes, play }: Listened): FirstListen {
  /** What is to be played because an approval was asked for. */
  const [wantedIds, setWantedIds] = useState<readonly string[]>([])
  const unheard = takes.filter(({ is_heard: isHeard }) => !isHeard)
  const wantedTakes = takes.filter(({ id }) => wantedIds.includes(id))
  const isSounding = playing.status === 'playing' || playing.status === 'loading'
  const sounding = wantedTakes.find(({ id }) => isSounding && id === playing.takeId)

  const goOn = useEffectEvent(() => {
    const next = wantedTakes.find(({ is_heard: isHeard }) => !isHeard)
    if (next) play(next)
  })
  // A sound is heard to its end; one that does not end, or not soon, until it counts as heard.
  const isEndless = playing.looping || playing.durationS > ENOUGH_S
  const last = wantedTakes.find(({ id }) => id === playing.takeId)
  const isDone = last?.is_heard === true && (playing.status === 'paused' || isEndless)
  useEffect(() => {
    if (isDone) goOn()
  }, [isDone, last?.id])

  return {
    unheard,
    listening: sounding && !sounding.is_heard ? sounding : null,
    isOver: wantedTakes.length > 0 && unheard.length === 0,
    approveHeard: (asked, approve) => {
      const left = asked.filter(({ is_heard }) => !is_heard)
      if (left.length === 0) {
        setWantedIds([])
        approve()
        return
      }
      const isWhole = playing.fromStart && playing.range === null && !playing.isRandomized
      const isUnderWay = isSounding && isWhole && left.some(({ id }) => id === playing.takeId)
      setWantedIds(left.map(({ id }) => id))
      if (!isUnderWay && left[0]) play(left[0])
    },
    stop: () => {
      setWantedIds([])
      player.pause()
    },
  }
}
