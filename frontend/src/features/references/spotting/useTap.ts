import { useRef } from 'react'

import { HELD_S, type Spotted, withChange, withMark } from './marks'
import type { Clip } from './useClip'
import type { ChangeMarks } from './useMarks'

interface TapProps {
  clip: Clip
  spotted: Spotted
  change: ChangeMarks
  onMark: (id: number) => void
}

export interface Tap {
  /** A key or a finger goes down, at a time of the page's clock. */
  press: (eventMs: number) => void
  release: () => void
}

/** A press marks the beginning of a sound; held while the clip plays, its length too. */
export function useTap({ clip, spotted, change, onMark }: TapProps): Tap {
  const pressed = useRef<{ id: number; startS: number } | null>(null)
  return {
    press: (eventMs) => {
      const startS = clip.positionAt(eventMs)
      pressed.current = { id: spotted.nextId, startS }
      change((now) => withMark(now, startS), `tap:${spotted.nextId}`)
      onMark(spotted.nextId)
    },
    release: () => {
      const held = pressed.current
      pressed.current = null
      if (held === null) return
      const lengthS = clip.positionAt() - held.startS
      if (lengthS >= HELD_S) change((now) => withChange(now, held.id, { lengthS }), `tap:${held.id}`)
    },
  }
}
