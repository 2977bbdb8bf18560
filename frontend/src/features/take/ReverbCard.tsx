import { Link } from '@tanstack/react-router'

import { LevelWell } from '@/audio'
import { Card, CardHead } from '@/ui/Card'
import { figure, plural, score } from '@/ui/format'
import { Table } from '@/ui/Table'

import type { Check, Take } from './api'
import { DryStem } from './DryStem'
import { type DecayBand, type ReverbBefore, type ReverbEvidence, reverbOf } from './reverb'
import classes from './Take.module.css'

const WIDTH = 600
const HEIGHT = 180
const FLOOR_DB = -60
const LINES_DB = [-20, -40]
/** Smaller changes of a decay time are not spoken of. */
const LEAST_CHANGE_S = 0.05

interface ReverbCardProps {
  take: Take
  check: Check | null | undefined
  /** Who looks has made it, and may add its dry stem. */
  isMaker: boolean
}

/** What the judgement of reverb goes by: how each octave dies away, and how alike left and right stay. */
export function ReverbCard({ take, check, isMaker }: ReverbCardProps) {
  const evidence = check ? reverbOf(check.judgements) : null
  if (!check || !evidence) return null
  return (
    <Card aria-labelledby="reverb">
      <CardHead id="reverb" title="Reverb?" end={answer(evidence)} />
      <div className="p-3-inset-14px">
        <figure className="grid gap-2px">
          <DecayPlot evidence={evidence} />
          <figcaption className="small mid">
            Energy decay per octave after the last loud moment. In a room all octaves decay evenly, in straight lines;
            in a dry sound each part decays in its own way.
            {evidence.isStereo && ' In a reverb tail, left and right are less correlated than in the sound before it.'}
          </figcaption>
        </figure>
        <DecayTable evidence={evidence} />
        <DryStem take={take} check={check} found={evidence.stem} mayGive={isMaker} />
        {evidence.before && <BesideBefore before={evidence.before} />}
      </div>
    </Card>
  )
}

function answer({ verdict, score: sure, rt60S }: ReverbEvidence): string {
  const parts = [verdict, rt60S !== null && `about ${figure(rt60S, 1)} s`, sure !== null && `score ${score(sure)}`]
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
        className={`absolute w-full ${classes.decay}`}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`Energy decay curves of ${plural(bands.length, 'octave')} over ${figure(lengthS, 2)} s; the table below has their figures`}
      >
        {LINES_DB.map((db) => (
          <line key={db} data-grid x1={0} x2={WIDTH} y1={y(db)} y2={y(db)} />
        ))}
        {bands.map((band, at) => (
          <polyline key={band.hz} points={line(band)} style={{ opacity: 1 - (0.65 * at) / bands.length }} />
        ))}
      </svg>
      <span className={`absolute rounded-2px bg-well dim ${classes.decayEnd}`} aria-hidden="true">
        {figure(lengthS, 2)} s
      </span>
    </LevelWell>
  )
}

function DecayTable({ evidence: { bands, isStereo } }: { evidence: ReverbEvidence }) {
  return (
    <Table
      label="Decay per octave"
      rows={bands}
      keyOf={({ hz }) => hz}
      columns={[
        { head: 'Octave', rowHead: true, cell: ({ hz }) => octave(hz) },
        { head: 'RT60', cell: ({ rt60S }) => (rt60S === null ? 'too short to measure' : `${figure(rt60S, 2)} s`) },
        { head: 'Rate', cell: ({ rateDbS }) => (rateDbS === null ? '' : `${figure(rateDbS)} dB/s`) },
        ...(isStereo
          ? [
              {
                head: 'L/R correlation, start to tail',
                cell: ({ head, tail }: (typeof bands)[number]) => alike(head, tail),
              },
            ]
          : []),
      ]}
    />
  )
}

/** What changed since the version before: how much of a tail, and how much slower or faster the octaves die away. */
function BesideBefore({ before }: { before: ReverbBefore }) {
  const { number, rt60S, wetDb, verdict } = before
  const slower = before.bands.flatMap(({ hz, rt60S: now, earlierRt60S: then }) =>
    now === null || then === null || Math.abs(now - then) < LEAST_CHANGE_S ? [] : [{ hz, byS: now - then }],
  )
  return (
    <div className="small">
      <p>
        <Link className="link" to="/takes/$takeId" params={{ takeId: before.takeId }}>
          Compared with version {number}
        </Link>
        : {verdict === 'undecided' ? 'not the same sound, so their reverb can’t be compared.' : `${verdict}.`}
        {rt60S !== null &&
          wetDb !== null &&
          ` The added tail is ${figure(Math.abs(wetDb), 1)} dB ${wetDb < 0 ? 'under' : 'over'} the sound and falls by 60 dB in ${figure(rt60S, 2)} s.`}
      </p>
      {verdict !== 'undecided' && slower.length > 0 && (
        <ul aria-label={`Tails compared with version ${number}`} className={`flex wrap mt-1 ${classes.tails}`}>
          {slower.map(({ hz, byS }) => (
            <li key={hz}>
              {octave(hz)}: {figure(Math.abs(byS), 2)} s {byS > 0 ? 'slower' : 'faster'}
            </li>
          ))}
        </ul>
      )}
    </div>
  )
}

const share = (value: number | null): string => (value === null ? '?' : figure(value, 2))

const alike = (head: number | null, tail: number | null): string =>
  head === null && tail === null ? 'no tail to compare' : `${share(head)} to ${share(tail)}`
