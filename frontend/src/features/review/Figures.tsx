import type { ReactNode } from 'react'

import type { ReviewTake } from '@/verdicts/api'
import { channels, figure, level, milliseconds, rate } from '@/ui/format'
import { Icon } from '@/ui/Icon'

import classes from './Side.module.css'

const numberOf = (value: unknown): number | null => (typeof value === 'number' ? value : null)

/** What was measured of a version, with a sign where it is over a limit. */
export function Figures({ take }: { take: ReviewTake }) {
  const { facts, measurements } = take
  const rateHz = numberOf(facts.sample_rate_hz)
  const depth = numberOf(facts.bit_depth)
  const count = numberOf(facts.channels)
  const master = [rateHz && rate(rateHz), depth && `${depth} bit`, count && channels(count)].filter(Boolean).join(', ')
  const integrated = numberOf(measurements.integrated_lufs)
  const head = numberOf(measurements.head_silence_ms)
  const tail = numberOf(measurements.tail_silence_ms)
  const bandwidth = numberOf(measurements.bandwidth_hz)
  const flagged = new Set(take.findings.map(({ check }) => check))
  const marked = (check: string, text: string): ReactNode =>
    flagged.has(check) ? (
      <span className="tone-warn toned">
        <Icon name="triangle" size={14} /> {text}
      </span>
    ) : (
      text
    )
  const lines: [string, ReactNode][] = [
    ['Master', master],
    ['Sample peak', marked('sample-peak', level(take.sample_peak_dbfs, 'dBFS'))],
    ['True peak', marked('true-peak', level(take.true_peak_dbtp, 'dBTP'))],
    [
      integrated === null ? 'Loudness, short sound' : 'Loudness',
      marked('loudness', take.loudness_lufs === null ? 'not measured' : level(take.loudness_lufs, 'LUFS')),
    ],
  ]
  if (head !== null) lines.push(['Leading silence', marked('head-silence', milliseconds(head))])
  if (tail !== null) lines.push(['Trailing silence', marked('tail-silence', milliseconds(tail))])
  if (bandwidth !== null) lines.push(['Highest frequency', `${figure(bandwidth / 1000, 1)} kHz`])
  for (const { target, state, attenuation_db } of take.renders) {
    if (state === 'waiting') lines.push([`File for ${target}`, 'rendering'])
    else if (attenuation_db !== null && attenuation_db > 0.05) {
      lines.push([`File for ${target}`, `lowered by ${figure(attenuation_db, 1)} dB`])
    }
  }
  return (
    <dl className={`grid gap-2px ${classes.figures} small`}>
      {lines.map(([term, value]) => (
        <div key={term}>
          <dt className="dim">{term}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  )
}
