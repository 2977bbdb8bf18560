import { type Dispatch, type PointerEvent, type SetStateAction, useId, useRef } from 'react'

import { Button } from '@/ui/Button'

import classes from './DrawnName.module.css'
import { begun, extended, HEIGHT, pathOf, pointAt, type Strokes, WIDTH } from './strokes'

/** A drawn name, to look at. */
export function DrawnName({ strokes, name }: { strokes: Strokes; name: string }) {
  return (
    <svg className={classes.shown} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={`${name}, drawn by hand`}>
      <path d={pathOf(strokes)} />
    </svg>
  )
}

/** A field to draw one's name in by mouse, pen or finger; it may stay empty, so no keyboard is kept from signing. */
export function DrawName({ strokes, onChange }: { strokes: Strokes; onChange: Dispatch<SetStateAction<Strokes>> }) {
  const labelId = useId()
  const field = useRef<SVGSVGElement>(null)
  const at = (event: { clientX: number; clientY: number }) =>
    pointAt(event, field.current?.getBoundingClientRect() ?? new DOMRect(0, 0, WIDTH, HEIGHT))
  const begin = (event: PointerEvent<SVGSVGElement>) => {
    if (event.button !== 0) return
    event.preventDefault()
    event.currentTarget.setPointerCapture(event.pointerId)
    const point = at(event)
    onChange((now) => begun(now, point))
  }
  const move = (event: PointerEvent<SVGSVGElement>) => {
    if (!event.currentTarget.hasPointerCapture(event.pointerId)) return
    const passed = event.nativeEvent.getCoalescedEvents?.() ?? []
    const points = (passed.length > 0 ? passed : [event]).map(at)
    onChange((now) => points.reduce(extended, now))
  }
  const isEmpty = strokes.length === 0
  return (
    <div className={`grid gap-1 ${classes.field}`}>
      <p id={labelId} className="small">
        Draw your name <span className="dim">(optional, by mouse, pen or finger)</span>
      </p>
      <svg
        ref={field}
        className={`border-edge rounded bg-raised ${classes.canvas}`}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-labelledby={labelId}
        onPointerDown={begin}
        onPointerMove={move}
      >
        <line x1={40} x2={WIDTH - 40} y1={HEIGHT - 60} y2={HEIGHT - 60} />
        <path d={pathOf(strokes)} />
      </svg>
      <div className="row">
        <Button variant="quiet" disabled={isEmpty} onClick={() => onChange((now) => now.slice(0, -1))}>
          Undo stroke
        </Button>
        <Button variant="quiet" disabled={isEmpty} onClick={() => onChange(() => [])}>
          Clear drawing
        </Button>
      </div>
    </div>
  )
}
