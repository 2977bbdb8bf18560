import type { ReactNode } from 'react'

import { figure } from '@/ui/format'

import type { Surface } from './draw'
import { Drawing } from './Drawing'
import classes from './LevelPlot.module.css'

export const FLOOR_DB = -96
export const LINES_DB = [-24, -48, -72] as const
export const LINES_HZ = [100, 1_000, 10_000] as const

/** A frequency named below the drawing. */
interface FrequencyMark {
  hz: number
  /** Its place from left to right, 0 to 1; the ends stand inside. */
  at: number
  label: string
  /** Not on a narrow screen. */
  wideOnly?: boolean
}

interface LevelWellProps {
  linesDb: readonly number[]
  floorDb: number
  tall: boolean
  children: ReactNode
}

/** Where levels are drawn, from 0 dB at the top; its lines are named at the right. */
export function LevelWell({ linesDb, floorDb, tall, children }: LevelWellProps) {
  return (
    <div className={`bg-well overflow-hidden relative border rounded ${classes.well}`} data-tall={tall || undefined}>
      {children}
      {linesDb.map((db) => (
        <span key={db} className={classes.db} style={{ top: `${(db / floorDb) * 100}%` }} aria-hidden="true">
          {figure(db)}
        </span>
      ))}
    </div>
  )
}

interface LevelPlotProps {
  draw: (surface: Surface) => void
  frequencies: readonly FrequencyMark[]
  tall?: boolean
  /** The content of the drawing. */
  children?: ReactNode
  caption: ReactNode
}

/** Levels over frequency: a drawing with its lines of level named at the right, and its frequencies below. */
export function LevelPlot({ draw, frequencies, tall = false, children, caption }: LevelPlotProps) {
  return (
    <figure className="grid gap-2px">
      <LevelWell linesDb={LINES_DB} floorDb={FLOOR_DB} tall={tall}>
        <Drawing draw={draw} />
        {children}
      </LevelWell>
      <div className={`relative dim ${classes.hz}`} aria-hidden="true">
        {frequencies.map(({ hz, at, label, wideOnly }) => (
          <span
            key={hz}
            className={wideOnly ? 'wide-only' : undefined}
            data-edge={at <= 0 ? 'start' : at >= 1 ? 'end' : undefined}
            style={at <= 0 || at >= 1 ? undefined : { left: `${at * 100}%` }}
          >
            {label}
          </span>
        ))}
      </div>
      <figcaption className="small mid">{caption}</figcaption>
    </figure>
  )
}
