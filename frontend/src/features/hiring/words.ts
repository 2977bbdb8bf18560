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
