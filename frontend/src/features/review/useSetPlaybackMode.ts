import { useState } from 'react'

import { IN_ORDER, type SetPlaybackMode } from '@/audio'

const KEPT = 'soundlist-set-way'

function keptWay(): SetPlaybackMode {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(KEPT) ?? 'null')
    return isWay(kept) ? kept : IN_ORDER
  } catch {
    return IN_ORDER
  }
}

function isWay(kept: unknown): kept is SetPlaybackMode {
  if (typeof kept !== 'object' || kept === null) return false
  const { intervalS, pitchSemitones, levelDb } = kept as Partial<Record<keyof SetPlaybackMode, unknown>>
  const isInterval = intervalS === null || (typeof intervalS === 'number' && intervalS >= 0.05)
  return isInterval && typeof pitchSemitones === 'number' && typeof levelDb === 'number'
}

export interface ChosenPlaybackMode {
  way: SetPlaybackMode
  setWay: (way: SetPlaybackMode) => void
  isOpen: boolean
  setOpen: (isOpen: boolean) => void
}

/** How a person hears sets, over cues. */
export function useSetPlaybackMode(): ChosenPlaybackMode {
  const [way, setState] = useState(keptWay)
  const [isOpen, setOpen] = useState(false)
  const setWay = (chosen: SetPlaybackMode) => {
    setState(chosen)
    try {
      localStorage.setItem(KEPT, JSON.stringify(chosen))
    } catch {
      // A browser that keeps nothing starts with one after another.
    }
  }
  return { way, setWay, isOpen, setOpen }
}

export interface PanelProps extends ChosenPlaybackMode {
  isPlaying: boolean
  onPlay: () => void
  onStop: () => void
}
