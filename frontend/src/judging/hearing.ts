import type { Source } from '@/audio'

import type { ReviewTake } from './api'

export const MASTER = 'master'
/** A variation this much louder or softer than the others of its set is named. */
const ODD_DB = 3
/** More than this is no matching of levels but another sound. */
const MOST_GAIN_DB = 24

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
}

export const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'

/** The targets that the takes are rendered to, in the spec's order. */
export function targetsOf(takes: readonly ReviewTake[]): string[] {
  return [MASTER, ...new Set(takes.flatMap((take) => take.renders.map(({ target }) => target)))]
}

export function soundOf(take: ReviewTake, target: string): Sound {
  const render = take.renders.find((one) => one.target === target)
  const { duration_s, preview_url, peaks_url, spectrum_url } = render ?? take
  return {
    durationS: duration_s ?? take.duration_s ?? secondsOf(take.facts.duration_s),
    previewUrl: preview_url,
    peaksUrl: peaks_url,
    spectrumUrl: spectrum_url,
    refusal: render?.refusal ?? null,
    attenuationDb: render?.attenuation_db ?? null,
  }
}

const secondsOf = (value: unknown): number => (typeof value === 'number' ? value : 0)

/** What brings a take to the loudness of the first one; 0 where one of them is not known. */
export function matchGainDb(take: ReviewTake, reference: ReviewTake | undefined): number {
  const own = take.loudness_lufs
  const wanted = reference?.loudness_lufs
  if (own === null || wanted === null || wanted === undefined) return 0
  return Math.max(-MOST_GAIN_DB, Math.min(MOST_GAIN_DB, wanted - own))
}

/** What the player is given for a take; null where there is nothing to hear. */
export function sourceOf(take: ReviewTake, target: string, reference?: ReviewTake): Source | null {
  const { previewUrl } = soundOf(take, target)
  if (previewUrl === null) return null
  return { id: `${take.id} ${target}`, url: previewUrl, matchGainDb: matchGainDb(take, reference) }
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

function median(values: number[]): number {
  const sorted = values.toSorted((a, b) => a - b)
  const middle = sorted.length >> 1
  const upper = sorted[middle] ?? 0
  return sorted.length % 2 === 1 ? upper : ((sorted[middle - 1] ?? upper) + upper) / 2
}

/** How far a take stands from the middle of the others of its set, in dB; null where that cannot be said. */
export function awayFromSet(take: ReviewTake, set: readonly ReviewTake[]): number | null {
  const others = set.flatMap((other) =>
    other.variation !== take.variation && other.loudness_lufs !== null ? [other.loudness_lufs] : [],
  )
  if (take.loudness_lufs === null || others.length < 2) return null
  return take.loudness_lufs - median(others)
}

export interface OddOne {
  take: ReviewTake
  awayDb: number
}

/** The variation that stands out most from its set, if one does. */
export function oddOne(set: readonly ReviewTake[]): OddOne | null {
  const far = set
    .map((take) => ({ take, awayDb: awayFromSet(take, set) ?? 0 }))
    .filter(({ awayDb }) => Math.abs(awayDb) >= ODD_DB)
    .sort((a, b) => Math.abs(b.awayDb) - Math.abs(a.awayDb))
  return far[0] ?? null
}
