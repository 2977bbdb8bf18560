import { useEffect, useState, useSyncExternalStore } from 'react'

import { Player } from './player'
import type { PlayerState } from './playerState'

/** A player for one page; it falls silent when the page is left. See `Player` for what `held` does. */
export function usePlayer({ held = false } = {}): [Player, PlayerState] {
  const [player] = useState(() => new Player({ held }))
  useEffect(() => () => player.dispose(), [player])
  const state = useSyncExternalStore(player.subscribeState, player.getState)
  return [player, state]
}
