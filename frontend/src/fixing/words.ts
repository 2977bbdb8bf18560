import { figure, length, type LevelUnit, range } from '@/ui/format'

import type { Fix, Spot } from './api'

export interface Moved {
  what: string
  before: string
  after: string
}

const LEVELS: readonly [figure: string, what: string, unit: LevelUnit | '%'][] = [
  ['sample_peak_dbfs', 'Sample peak', 'dBFS'],
  ['true_peak_dbtp', 'True peak', 'dBTP'],
  ['integrated_lufs', 'Loudness', 'LUFS'],
  ['short_loudness_lufs', 'Loudness, loudest 400 ms', 'LUFS'],
  ['dc_offset_percent', 'DC offset', '%'],
]

const numberOf = (value: unknown): number | null => (typeof value === 'number' ? value : null)

/** What stands otherwise in the fixed copy: levels with their units, then the length. */
export function movedFigures({ before, after, duration_s: afterS, cut_head_s: head, cut_tail_s: tail }: Fix): Moved[] {
  const moved = LEVELS.flatMap(([name, label, unit]): Moved[] => {
    const was = numberOf(before[name])
    const is = numberOf(after[name])
    if (was === null || is === null || Math.abs(is - was) < 0.005) return []
    // A hundredth more than elsewhere: the limit itself has one decimal.
    const decimals = figure(was, 1) === figure(is, 1) ? 2 : 1
    return [{ what: label, before: `${figure(was, decimals)} ${unit}`, after: `${figure(is, decimals)} ${unit}` }]
  })
  if (afterS !== null && head + tail > 0) {
    moved.push({ what: 'Length', before: length(afterS + head + tail), after: length(afterS) })
  }
  return moved
}

/** What a spot shows: "The start, 0.000–0.437 s". */
export function spotName({ kind, start_s, end_s }: Spot): string {
  const name = { head: 'The start', tail: 'The end', gain: 'The loudest part', offset: 'The start' }[kind]
  return `${name}, ${range(start_s, end_s)}`
}

/** What follows from taking it: "It becomes version 2; version 1 stays as it is. No round counts." */
export function describeNextStep(fix: Fix, number: number | null): string {
  const becomes = fix.becomes === null ? 'It becomes a new version' : `It becomes version ${fix.becomes}`
  const stays = number === null ? 'your master is kept' : `version ${number} is kept`
  return `${becomes}; ${stays}. No round is counted.`
}
