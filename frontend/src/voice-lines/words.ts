import type { StateKind } from '@/ui/StatusBadge'

import type { VoiceLine } from './api'

/** How the state of a line is shown: icon and colour of a known state, in the words of a recording session. */
export const LINE_STATES: Readonly<Record<VoiceLine['state'], { kind: StateKind; word: string }>> = {
  no_text: { kind: 'waiting', word: 'Not translated' },
  no_take: { kind: 'to_make', word: 'No take' },
  stale: { kind: 'warning', word: 'Text changed' },
  returned: { kind: 'returned', word: 'Returned' },
  change_requested: { kind: 'change_requested', word: 'Change requested' },
  in_review: { kind: 'to_review', word: 'To review' },
  approved: { kind: 'approved', word: 'Approved' },
  cut: { kind: 'cut', word: 'Cut' },
}

/** A length against the original's: +20 %. */
export const percentOf = (percent: number): string =>
  `${percent > 0 ? '+' : percent < 0 ? '−' : '±'}${Math.abs(percent).toFixed(percent % 1 === 0 ? 0 : 1)} %`

const names = new Intl.DisplayNames(['en'], { type: 'language', fallback: 'code' })

/** A language by its English name, with its tag: German (de). */
export function languageName(tag: string): string {
  try {
    const name = names.of(tag)
    return name === undefined || name === tag ? tag : `${name} (${tag})`
  } catch {
    return tag
  }
}
