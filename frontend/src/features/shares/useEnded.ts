import { useEffect, useEffectEvent } from 'react'

import type { Player } from '@/audio'

/** Call back each time that a sound has played to its end. */
export function useEnded(player: Player, onEnded: () => void): void {
  const ended = useEffectEvent(onEnded)
  useEffect(() => {
    let sounded = false
    const isPlaying = () => player.getState().status === 'playing'
    const unsubscribeState = player.subscribeState(() => {
      if (isPlaying()) sounded = true
    })
    // A pause is told before the place at which it leaves the sound.
    const unsubscribe = player.subscribe(() => {
      if (!sounded || isPlaying()) return
      sounded = false
      const { durationS, sourceId } = player.getState()
      if (sourceId !== null && durationS > 0 && player.positionS() >= durationS) ended()
    })
    return () => {
      unsubscribeState()
      unsubscribe()
    }
  }, [player])
}
