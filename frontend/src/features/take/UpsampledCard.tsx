import { LevelWell } from '@/audio'
import { Card, CardHead } from '@/ui/Card'
import { figure, rate } from '@/ui/format'

import type { Check } from './api'
import { isTable, judgedOf, numberOf } from './judged'
import classes from './Take.module.css'

const WIDTH = 600
const HEIGHT = 180
const FLOOR_DB = -150
const LINES_DB = [-50, -100]

/** Where the spectrum ends, and how steeply: what the judgement of a lower rate goes by. */
export function UpsampledCard({ check }: { check: Check | null | undefined }) {
  const judged = check ? judgedOf(check.judgements, 'upsampled') : null
  const spectrum = judged?.evidence.spectrum
  if (!judged || !isTable(spectrum) || !Array.isArray(spectrum.dbfs)) return null
  const levels = spectrum.dbfs.filter((db) => typeof db === 'number')
  const edgeHz = numberOf(judged.figures.edge_hz)
  const dropDb = numberOf(judged.figures.drop_db)
  const fromHz = numberOf(judged.figures.from_hz)
  const topHz = (numberOf(spectrum.step_hz) ?? 0) * levels.length
  const score = judged.score === null ? '' : `, score ${figure(judged.score, 2)}`
  const x = (hz: number) => (WIDTH * hz) / topHz
  const y = (db: number) => (HEIGHT * Math.max(FLOOR_DB, Math.min(0, db))) / FLOOR_DB
  const line = levels
    .map((db, at) => `${((WIDTH * (at + 0.5)) / levels.length).toFixed(1)},${y(db).toFixed(1)}`)
    .join(' ')
  const end =
    edgeHz === null || dropDb === null
      ? ''
      : `Its steepest end lies at ${figure(edgeHz / 1000, 1)} kHz, where it drops by ${figure(dropDb, 1)} dB.`
  return (
    <Card aria-labelledby="upsampled">
      <CardHead id="upsampled" title="Was it brought up from a lower rate?" end={`${judged.verdict}${score}`} />
      <div className={classes.inside}>
        <figure className={classes.bands}>
          <LevelWell linesDb={LINES_DB} floorDb={FLOOR_DB} tall>
            <svg
              className={classes.decay}
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
            <span className={classes.decayEnd} aria-hidden="true">
              {figure(topHz / 1000, 1)} kHz
            </span>
          </LevelWell>
          <figcaption className="small mid">
            {end}{' '}
            {fromHz !== null &&
              `A resampler from ${rate(fromHz)} ends there. A library sound pitched down, or an old recorder, can end so too: ask.`}
          </figcaption>
        </figure>
      </div>
    </Card>
  )
}
