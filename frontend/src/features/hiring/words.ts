import { ApiProblem } from '@/api'
import { day, plural } from '@/ui/format'

import type { AskedLine, BidLine, PostingSummary } from './api'

export const STATE_WORDS: Record<PostingSummary['state'], string> = {
  draft: 'Draft',
  open: 'Open',
  closed: 'Closed',
  awarded: 'Awarded',
}

export const EXTRA_WORDS = {
  rush: 'Rush',
  voice: 'Voice',
  direction: 'Direction',
  narration: 'Narration',
  music: 'Music',
} as const satisfies Record<Exclude<BidLine['kind'], 'asked'>, string>

export const UNIT_WORDS: Record<BidLine['unit'], string> = { per_cue: 'per cue', per_hour: 'per hour', flat: 'flat' }

/** "3 cues, 10 files". */
export const countOfLine = ({ cues, files }: AskedLine): string => `${plural(cues, 'cue')}, ${plural(files, 'file')}`

/** "4 January to 31 March 2027". */
export function period(from: string | null, to: string | null): string {
  if (from && to) return `${day(from)} to ${day(to)}`
  if (from) return `from ${day(from)}`
  return to ? `until ${day(to)}` : 'no dates yet'
}

/** What the server refused, in a sentence, and what to do about it. */
export function refusal(error: unknown): { detail: string; fix?: string } | null {
  if (error === null || error === undefined) return null
  if (error instanceof ApiProblem) return { detail: sentence(error.detail), fix: error.fix || undefined }
  return { detail: 'The server could not be reached.', fix: 'Try again in a moment.' }
}

const sentence = (text: string) => `${text.slice(0, 1).toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? '' : '.'}`
