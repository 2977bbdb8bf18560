import type { Source } from '@/audio'

import type { ReviewTake } from './api'

export const MASTER = 'master'
/** More than this is no matching of levels but another sound. */
const MAX_GAIN_DB = 24

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
  return Math.max(-MAX_GAIN_DB, Math.min(MAX_GAIN_DB, wanted - own))
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

/** What the checker says of a variation that is louder or softer than its set. */
const OUT_OF_SET = 'variation-set:level'

export interface OddOne {
  take: ReviewTake
  awayDb: number
}

/** The variation that stands out most from its set, by the check; null where none does. */
export function oddOne(set: readonly ReviewTake[]): OddOne | null {
  const far = set
    .filter(({ findings }) => findings.some(({ code }) => code === OUT_OF_SET))
    .map((take) => ({ take, awayDb: take.away_from_set_lu ?? 0 }))
    .sort((a, b) => Math.abs(b.awayDb) - Math.abs(a.awayDb))
  return far[0] ?? null
}
