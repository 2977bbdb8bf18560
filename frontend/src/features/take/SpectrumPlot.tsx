import { LevelWell } from '@/audio'
import { figure } from '@/ui/format'

import { isTable, numberOf } from './judged'
import classes from './Take.module.css'

const WIDTH = 600
const HEIGHT = 180
const FLOOR_DB = -150
const LINES_DB = [-50, -100]

/** The mean spectrum that a judgement goes by. */
export interface MeanSpectrum {
  levelsDb: number[]
  topHz: number
}

export function meanSpectrumOf(value: unknown): MeanSpectrum | null {
  if (!isTable(value) || !Array.isArray(value.dbfs)) return null
  const levelsDb = value.dbfs.filter((db) => typeof db === 'number')
  return { levelsDb, topHz: (numberOf(value.step_hz) ?? 0) * levelsDb.length }
}

interface SpectrumPlotProps {
  spectrum: MeanSpectrum
  /** Where it ends. */
  edgeHz: number | null
  /** What is said of its end to those who do not see it. */
  end: string
}

export function SpectrumPlot({ spectrum: { levelsDb, topHz }, edgeHz, end }: SpectrumPlotProps) {
  const x = (hz: number) => (WIDTH * hz) / topHz
  const y = (db: number) => (HEIGHT * Math.max(FLOOR_DB, Math.min(0, db))) / FLOOR_DB
  const line = levelsDb
    .map((db, at) => `${((WIDTH * (at + 0.5)) / levelsDb.length).toFixed(1)},${y(db).toFixed(1)}`)
    .join(' ')
  return (
    <LevelWell linesDb={LINES_DB} floorDb={FLOOR_DB} tall>
      <svg
        className={`absolute w-full ${classes.decay}`}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`Mean spectrum from 0 Hz to ${figure(topHz / 1000, 1)} kHz. ${end}`}
      >
        {LINES_DB.map((db) => (
          <line key={db} data-grid x1={0} x2={WIDTH} y1={y(db)} y2={y(db)} />
        ))}
        {edgeHz !== null && <line data-grid x1={x(edgeHz)} x2={x(edgeHz)} y1={0} y2={HEIGHT} />}
        <polyline points={line} />
      </svg>
      <span className={`absolute rounded-2px bg-well dim ${classes.decayEnd}`} aria-hidden="true">
        {figure(topHz / 1000, 1)} kHz
      </span>
    </LevelWell>
  )
}
