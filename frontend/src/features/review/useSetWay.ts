import { useState } from 'react'

import { ONE_AFTER_ANOTHER, type SetWay } from '@/audio'

const KEPT = 'soundlist-set-way'

function keptWay(): SetWay {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(KEPT) ?? 'null')
    return isWay(kept) ? kept : ONE_AFTER_ANOTHER
  } catch {
    return ONE_AFTER_ANOTHER
  }
}

function isWay(kept: unknown): kept is SetWay {
  if (typeof kept !== 'object' || kept === null) return false
  const { intervalS, pitchSemitones, levelDb } = kept as Partial<Record<keyof SetWay, unknown>>
  const isInterval = intervalS === null || (typeof intervalS === 'number' && intervalS >= 0.05)
  return isInterval && typeof pitchSemitones === 'number' && typeof levelDb === 'number'
}

export interface ChosenWay {
  way: SetWay
  setWay: (way: SetWay) => void
  isOpen: boolean
  setOpen: (isOpen: boolean) => void
}

/** How a person hears sets, over cues. */
export function useSetWay(): ChosenWay {
  const [way, setState] = useState(keptWay)
  const [isOpen, setOpen] = useState(false)
  const setWay = (chosen: SetWay) => {
    setState(chosen)
    try {
      localStorage.setItem(KEPT, JSON.stringify(chosen))
    } catch {
      // A browser that keeps nothing starts with one after another.
    }
  }
  return { way, setWay, isOpen, setOpen }
}

export interface PanelProps extends ChosenWay {
  isPlaying: boolean
  onPlay: () => void
  onStop: () => void
}
