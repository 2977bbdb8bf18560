import { LevelWell } from '@/audio'
import { Card, CardHead } from '@/ui/Card'
import { figure } from '@/ui/format'

import type { Check } from './api'
import { type DecayBand, type ReverbEvidence, reverbOf } from './reverb'
import classes from './Take.module.css'

const WIDTH = 600
const HEIGHT = 180
const FLOOR_DB = -60
const LINES_DB = [-20, -40]

/** What the judgement of reverb goes by: how each octave dies away, and how alike left and right stay. */
export function ReverbCard({ check }: { check: Check | null | undefined }) {
  const evidence = check ? reverbOf(check.judgements) : null
  if (!evidence) return null
  return (
    <Card aria-labelledby="reverb">
      <CardHead id="reverb" title="Is there reverb in it?" end={answer(evidence)} />
      <div className={classes.inside}>
        <figure className={classes.bands}>
          <DecayPlot evidence={evidence} />
          <figcaption className="small mid">
            How much of its energy is still to come in each octave, from where it was last loud. A room lets all octaves
            fall straight and alike; a dry sound falls as each of its parts does.
            {evidence.isStereo && ' In a room’s tail left and right are less alike than in the sound before it.'}
          </figcaption>
        </figure>
        <DecayTable evidence={evidence} />
      </div>
    </Card>
  )
}

function answer({ verdict, score, rt60S }: ReverbEvidence): string {
  const parts = [
    verdict,
    rt60S !== null && `about ${figure(rt60S, 1)} s`,
    score !== null && `score ${figure(score, 2)}`,
  ]
  return parts.filter(Boolean).join(', ')
}

const octave = (hz: number): string => (hz >= 1000 ? `${figure(hz / 1000)} kHz` : `${figure(hz)} Hz`)

/** One line an octave, the higher the lighter; time across, decibels down. */
function DecayPlot({ evidence: { bands, stepS } }: { evidence: ReverbEvidence }) {
  const points = Math.max(2, ...bands.map(({ curveDb }) => curveDb.length))
  const lengthS = (points - 1) * stepS
  const y = (db: number) => (HEIGHT * Math.max(db, FLOOR_DB)) / FLOOR_DB
  const line = ({ curveDb }: DecayBand) =>
    curveDb.map((db, at) => `${((WIDTH * at) / (points - 1)).toFixed(1)},${y(db).toFixed(1)}`).join(' ')
  return (
    <LevelWell linesDb={LINES_DB} floorDb={FLOOR_DB} tall>
      <svg
        className={classes.decay}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`Energy decay curves of ${bands.length} octaves over ${figure(lengthS, 2)} s; the table below has their figures`}
      >
        {LINES_DB.map((db) => (
          <line key={db} data-grid x1={0} x2={WIDTH} y1={y(db)} y2={y(db)} />
        ))}
        {bands.map((band, at) => (
          <polyline key={band.hz} points={line(band)} style={{ opacity: 1 - (0.65 * at) / bands.length }} />
        ))}
      </svg>
      <span className={classes.decayEnd} aria-hidden="true">
        {figure(lengthS, 2)} s
      </span>
    </LevelWell>
  )
}

function DecayTable({ evidence: { bands, isStereo } }: { evidence: ReverbEvidence }) {
  return (
    <table className={`small ${classes.decayTable}`} aria-label="How each octave dies away">
      <thead>
        <tr>
          <th scope="col">Octave</th>
          <th scope="col">By 60 dB in</th>
          <th scope="col">Rate</th>
          {isStereo && <th scope="col">Left like right, head to tail</th>}
        </tr>
      </thead>
      <tbody>
        {bands.map(({ hz, rt60S, rateDbS, head, tail }) => (
          <tr key={hz}>
            <th scope="row">{octave(hz)}</th>
            <td>{rt60S === null ? 'too short to tell' : `${figure(rt60S, 2)} s`}</td>
            <td>{rateDbS === null ? '' : `${figure(rateDbS)} dB/s`}</td>
            {isStereo && <td>{alike(head, tail)}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  )
}

const share = (value: number | null): string => (value === null ? '?' : figure(value, 2))

const alike = (head: number | null, tail: number | null): string =>
  head === null && tail === null ? 'no tail to compare' : `${share(head)} to ${share(tail)}`
