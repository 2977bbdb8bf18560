import { type KeyboardEvent, type PointerEvent, useCallback, useEffect, useRef } from 'react'

import { placeInWords } from '@/ui/format'

import type { Clock } from './clock'
import type { TimeRange } from './draw'
import classes from './Waveform.module.css'

const DRAG_PX = 4
const STEP_S = 0.01
const BIG_STEP_S = 0.1

interface SliderProps {
  label: string
  durationS: number
  playheadS?: number
  clock?: Clock
  onSeek?: (s: number) => void
  selection?: TimeRange | null
  onSelect?: (range: TimeRange | null) => void
}

/** The position in a sound, for pointers and keys; a drag selects a range. */
export function Slider({ label, durationS, playheadS = 0, clock, onSeek, selection, onSelect }: SliderProps) {
  const ref = useRef<HTMLDivElement>(null)
  const drag = useRef<{ fromPx: number; fromS: number; dragging: boolean } | null>(null)
  const at = useCallback(() => (clock ? clock.positionS() : playheadS), [clock, playheadS])

  useEffect(() => {
    const say = () => {
      const s = at()
      ref.current?.setAttribute('aria-valuenow', s.toFixed(3))
      ref.current?.setAttribute('aria-valuetext', placeInWords(s))
    }
    say()
    // While it plays, a figure that changes at every frame would be read out without end.
    return clock?.subscribe(() => {
      if (!clock.isPlaying()) say()
    })
  }, [at, clock])

  const timeAt = (event: PointerEvent): number => {
    const box = event.currentTarget.getBoundingClientRect()
    const share = box.width > 0 ? (event.clientX - box.left) / box.width : 0
    return Math.min(1, Math.max(0, share)) * durationS
  }
  const onPointerDown = (event: PointerEvent<HTMLDivElement>) => {
    if (event.button !== 0) return
    drag.current = { fromPx: event.clientX, fromS: timeAt(event), dragging: false }
    event.currentTarget.setPointerCapture?.(event.pointerId)
  }
  const onPointerMove = (event: PointerEvent<HTMLDivElement>) => {
    const held = drag.current
    if (held === null) return
    held.dragging ||= Math.abs(event.clientX - held.fromPx) > DRAG_PX
    if (!held.dragging) return
    const now = timeAt(event)
    if (onSelect) onSelect({ startS: Math.min(held.fromS, now), endS: Math.max(held.fromS, now) })
    else onSeek?.(now)
  }
  const onPointerUp = (event: PointerEvent<HTMLDivElement>) => {
    const held = drag.current
    drag.current = null
    if (held === null || held.dragging) return
    if (selection) onSelect?.(null)
    onSeek?.(timeAt(event))
  }
  const onKeyDown = (event: KeyboardEvent<HTMLDivElement>) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return
    const step = event.shiftKey ? BIG_STEP_S : STEP_S
    const moves: Record<string, number> = {
      ArrowLeft: at() - step,
      ArrowDown: at() - step,
      ArrowRight: at() + step,
      ArrowUp: at() + step,
      PageDown: at() - 1,
      PageUp: at() + 1,
      Home: 0,
      End: durationS,
    }
    const to = moves[event.key]
    if (to === undefined) return
    event.preventDefault()
    onSeek?.(Math.min(durationS, Math.max(0, to)))
  }

  return (
    <div
      ref={ref}
      role="slider"
      tabIndex={0}
      className={`absolute ${classes.slider}`}
      aria-label={`Position in ${label}`}
      aria-valuemin={0}
      aria-valuemax={Number(durationS.toFixed(3))}
      aria-valuenow={Number(playheadS.toFixed(3))}
      aria-valuetext={placeInWords(playheadS)}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onPointerUp={onPointerUp}
      onPointerCancel={() => (drag.current = null)}
      onKeyDown={onKeyDown}
    />
  )
}
