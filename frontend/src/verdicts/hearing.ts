import type { Source } from '@/audio'

import type { ReviewTake } from './api'
import { type Level, matchedGainsDb } from './levels'

export const MASTER = 'master'
/** The master's own file; what plays as `MASTER` has 16 bits. */
export const AS_DELIVERED = 'as-delivered'
const PREVIEW_BITS = 16
const WEB_CONTAINERS: readonly unknown[] = ['wav', 'flac']

/** Where one take can be heard and seen, as master or as the game file of a target. */
export interface Sound {
  durationS: number
  previewUrl: string | null
  peaksUrl: string | null
  spectrumUrl: string | null
  /** Why there is no game file. */
  refusal: string | null
  /** How far the game file came down to keep below the limit. */
  attenuationDb: number | null
  level: Level
}

export const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'

/** The master as it is, where it has more bits than its preview and every browser plays it; then the targets in the spec's order. */
export function targetsOf(takes: readonly ReviewTake[]): string[] {
  const delivered = takes.some(({ facts }) => playsAsDelivered(facts)) ? [AS_DELIVERED] : []
  return [MASTER, ...delivered, ...new Set(takes.flatMap((take) => take.renders.map(({ target }) => target)))]
}

/** Whether browsers play a master's own file, and it holds more than its preview of 16 bits. */
export const playsAsDelivered = ({ container, encoding, bit_depth, channels }: Record<string, unknown>): boolean =>
  WEB_CONTAINERS.includes(container) &&
  (encoding === 'pcm' || encoding === 'float') &&
  Number(bit_depth) > PREVIEW_BITS &&
  Number(channels) <= 2

export const masterUrl = (takeId: string): string => `/v1/takes/${takeId}/master`

export function soundOf(take: ReviewTake, target: string): Sound {
  const render = take.renders.find((file) => file.target === target)
  const { duration_s, preview_url, peaks_url, spectrum_url, loudness_lufs, true_peak_dbtp } = render ?? take
  return {
    durationS: duration_s ?? take.duration_s ?? secondsOf(take.facts.duration_s),
    previewUrl: target === AS_DELIVERED && playsAsDelivered(take.facts) ? masterUrl(take.id) : preview_url,
    peaksUrl: peaks_url,
    spectrumUrl: spectrum_url,
    refusal: render?.refusal ?? null,
    attenuationDb: render?.attenuation_db ?? null,
    level: { loudnessLufs: loudness_lufs, truePeakDbtp: true_peak_dbtp },
  }
}

const secondsOf = (value: unknown): number => (typeof value === 'number' ? value : 0)

/** The gains at which takes are heard at one loudness, in dB, by take. */
export type Gains = ReadonlyMap<string, number>
export const AS_SENT: Gains = new Map()

/** What brings takes to the loudness of the first one, and no true peak over the limit. */
export function matchGains(takes: readonly ReviewTake[], target: string = MASTER): Gains {
  const gains = matchedGainsDb(takes.map((take) => soundOf(take, target).level))
  return new Map(takes.map(({ id }, index) => [id, gains[index] ?? 0]))
}

/** What the player is given for a take; null where there is nothing to hear. */
export function sourceOf(take: ReviewTake, target: string, gains: Gains = AS_SENT): Source | null {
  const { previewUrl, durationS } = soundOf(take, target)
  if (previewUrl === null) return null
  const matchGainDb = gains.get(take.id) ?? 0
  return {
    id: `${take.id} ${target}`,
    takeId: take.id,
    url: previewUrl,
    matchGainDb,
    ...(durationS > 0 && { durationS }),
  }
}

/** Variations first, then the order in which they were delivered. */
export function inOrder(takes: readonly ReviewTake[]): ReviewTake[] {
  return [...takes].sort((a, b) => a.variation - b.variation || a.number - b.number || order(a) - order(b))
}
const order = (take: ReviewTake): number => take.alternate ?? 0

/** The letter of a take among those of its variation that wait: A for the first. */
export function letterOf(take: ReviewTake, waiting: readonly ReviewTake[]): string {
  const place = inOrder(waiting.filter(({ variation }) => variation === take.variation)).findIndex(
    ({ id }) => id === take.id,
  )
  return LETTERS[place] ?? ''
}

/** "_03". */
export const variationName = (variation: number): string => `_${String(variation).padStart(2, '0')}`

/** What the checker says of a variation that is louder or softer than its set. */
const OUT_OF_SET = 'variation-set:level'

export interface Outlier {
  take: ReviewTake
  awayDb: number
}

/** The variation that stands out most from its set, by the check; null where none does. */
export function outlierOf(set: readonly ReviewTake[]): Outlier | null {
  const far = set
    .filter(({ findings }) => findings.some(({ code }) => code === OUT_OF_SET))
    .map((take) => ({ take, awayDb: take.away_from_set_lu ?? 0 }))
    .sort((a, b) => Math.abs(b.awayDb) - Math.abs(a.awayDb))
  return far[0] ?? null
}
