import { useEffect, useState, useSyncExternalStore } from 'react'

import { Player } from './player'
import type { PlayerState } from './playerState'

/** A player for one page; it falls silent when the page is left. See `Player` for what `held` does. */
export function usePlayer({ held = false, light = false } = {}): [Player, PlayerState] {
  const [player] = useState(() => new Player({ held, light: light && playsLight() }))
  useEffect(() => () => player.dispose(), [player])
  const state = useSyncExternalStore(player.subscribeState, player.getState)
  return [player, state]
}

/** Whether the browser plays Ogg Vorbis; where it does not, the exact sound is played from the start. */
const playsLight = (): boolean => document.createElement('audio').canPlayType('audio/ogg; codecs="vorbis"') !== ''
