import { type KeyboardEvent, type PointerEvent, useRef } from 'react'

import { placeInWords } from '@/ui/format'

import { clock, type Mark, nameOf } from './marks'
import classes from './Spotting.module.css'

interface TimelineProps {
  marks: readonly Mark[]
  clipName: string
  durationS: number
  atS: number
  frameS: number
  selected: number | null
  onSelect: (id: number) => void
  onSeek: (s: number) => void
  onMove: (id: number, startS: number) => void
}

/** The clip as a line: where it is, and its marks, which are dragged. */
export function Timeline({
  marks,
  clipName,
  durationS,
  atS,
  frameS,
  selected,
  onSelect,
  onSeek,
  onMove,
}: TimelineProps) {
  const line = useRef<HTMLDivElement>(null)
  const grabbed = useRef<{ id: number; offsetS: number } | null>(null)
  const secondsAt = (clientX: number): number => {
    const box = line.current?.getBoundingClientRect()
    if (!box || box.width === 0) return 0
    return Math.min(1, Math.max(0, (clientX - box.left) / box.width)) * durationS
  }
  const share = (s: number): string => `${durationS > 0 ? Math.min(100, (s / durationS) * 100) : 0}%`
  const grab = (event: PointerEvent, mark: Mark) => {
    event.stopPropagation()
    onSelect(mark.id)
    event.currentTarget.setPointerCapture(event.pointerId)
    grabbed.current = { id: mark.id, offsetS: secondsAt(event.clientX) - mark.startS }
  }
  const drag = (event: PointerEvent) => {
    const held = grabbed.current
    if (held) onMove(held.id, Math.max(0, secondsAt(event.clientX) - held.offsetS))
  }
  const drop = () => {
    grabbed.current = null
  }
  const step = (event: KeyboardEvent) => {
    const to = { ArrowLeft: atS - frameS, ArrowRight: atS + frameS, Home: 0, End: durationS }[event.key]
    if (to === undefined) return
    event.preventDefault() // the page's arrows move the selected mark
    onSeek(to)
  }
  return (
    <div className="grid gap-1">
      {/* The slider in it does the same by keyboard. */}
      <div
        ref={line}
        className={`bg-well relative border-line-2 rounded ${classes.line}`}
        onPointerDown={(event) => onSeek(secondsAt(event.clientX))}
      >
        {marks.map((mark, at) => (
          <button
            key={mark.id}
            type="button"
            className={mark.lengthS === null ? classes.hit : classes.held}
            style={{ left: share(mark.startS), width: mark.lengthS === null ? undefined : share(mark.lengthS) }}
            aria-pressed={mark.id === selected}
            aria-label={`${nameOf(mark, at, clipName)}, ${placeInWords(mark.startS)}`}
            onFocus={() => onSelect(mark.id)}
            onClick={() => onSelect(mark.id)}
            onPointerDown={(event) => grab(event, mark)}
            onPointerMove={drag}
            onPointerUp={drop}
            onPointerCancel={drop}
          />
        ))}
        <div
          role="slider"
          tabIndex={0}
          aria-label="Position in the clip"
          aria-valuemin={0}
          aria-valuemax={durationS}
          aria-valuenow={atS}
          aria-valuetext={placeInWords(atS)}
          className={`absolute bottom-0 ${classes.playhead}`}
          style={{ left: share(atS) }}
          onKeyDown={step}
        />
      </div>
      <p className={`mono small flex between ${classes.times}`}>
        <span>{clock(atS)}</span>
        <span className="dim">{clock(durationS)}</span>
      </p>
    </div>
  )
}
