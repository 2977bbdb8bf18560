import { useEffect, useEffectEvent } from 'react'

import type { Player } from '@/audio'

/** Call back each time that a sound has played to its end. */
export function useEnded(player: Player, onEnded: () => void): void {
  const ended = useEffectEvent(onEnded)
  useEffect(() => {
    let sounded = false
    return player.subscribe(() => {
      const { status, durationS, sourceId } = player.getState()
      if (status === 'playing') sounded = true
      else if (sounded) {
        sounded = false
        if (sourceId !== null && durationS > 0 && player.positionS() >= durationS) ended()
      }
    })
  }, [player])
}
