import { useEffect, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { type Condition, CONDITIONS, type Player } from '@/audio'

const KEPT = 'soundlist-heard-as'

function keptCondition(): Condition | null {
  try {
    return CONDITIONS.find(({ id }) => id === localStorage.getItem(KEPT)) ?? null
  } catch {
    return null
  }
}

function keep(condition: Condition | null): void {
  try {
    if (condition === null) localStorage.removeItem(KEPT)
    else localStorage.setItem(KEPT, condition.id)
  } catch {
    // A browser that keeps nothing starts at full range.
  }
}

export interface Conditions {
  /** How it is heard; null for full range. */
  condition: Condition | null
  choose: (condition: Condition | null) => void
  /** Why it is not heard as chosen. */
  trouble: string | null
}

/** How a person hears everything in this room, over cues: as chosen, by its key, and as chosen the last time. */
export function useCondition(player: Player): Conditions {
  const [condition, setCondition] = useState(keptCondition)
  const [trouble, setTrouble] = useState<string | null>(null)
  const choose = (chosen: Condition | null) => {
    keep(chosen)
    setTrouble(null)
    setCondition(chosen)
  }
  useEffect(() => {
    if (condition === null) {
      player.setOutput()
      return undefined
    }
    let isWanted = true
    import('@/audio/conditionNodes').then(
      ({ outputOf }) => {
        if (isWanted) player.setOutput(outputOf(condition))
      },
      () => {
        if (!isWanted) return
        setCondition(null)
        setTrouble('The filters could not be loaded. Choose again.')
      },
    )
    return () => {
      isWanted = false
    }
  }, [player, condition])
  useHotkeys([
    { keys: 'shift+1', label: 'Hear it at full range', group: 'Review', run: () => choose(null) },
    ...CONDITIONS.map((option, index) => ({
      keys: `shift+${index + 2}`,
      label: `Hear it as it will be played: ${option.name}`,
      group: 'Review',
      run: () => choose(option),
    })),
  ])
  return { condition, choose, trouble }
}
