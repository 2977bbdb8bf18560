import { place, range } from '@/ui/format'

import type { ReviewFinding } from './api'
import { sentence } from './words'

export interface FindingWords {
  /** What was measured, figure and all. */
  head: string
  /** The limit, and what to do. */
  rest: string
  /** Where in the sound. */
  where: string
}

/** A sentence: a capital first, a full stop last. */
export const ended = (text: string): string =>
  text === '' || /[.!?]$/.test(text) ? sentence(text) : `${sentence(text)}.`

/** What a finding says, taken apart: up to the first comma or bracket it is the figure, after it the limit. */
export function wordsOf({ message, fix, start_s, end_s }: ReviewFinding): FindingWords {
  const text = sentence(message)
  const cut = text.search(/, | \(/)
  const head = cut < 0 ? text : text.slice(0, cut)
  // Its position is shown next to it; a bracket with only times adds nothing.
  const limit =
    cut < 0
      ? ''
      : text
          .slice(cut)
          .replace(/^ \([\d.,s …]+\)/, '')
          .replace(/^,\s*/, '')
          .trim()
  const rest = [ended(limit), ended(fix)].filter(Boolean).join(' ')
  return { head, rest, where: spotOf(start_s, end_s) }
}

/** "0.416 s", "0.000–0.412 s", or nothing where it is about the whole file. */
export function spotOf(startS: number | null, endS: number | null): string {
  if (startS === null) return ''
  return endS === null || endS - startS < 0.001 ? place(startS) : range(startS, endS)
}

/** Errors before warnings, then as the sound goes. */
export const worstFirst = (findings: readonly ReviewFinding[]): ReviewFinding[] =>
  findings.toSorted(
    (a, b) =>
      Number(b.severity === 'error') - Number(a.severity === 'error') ||
      (a.start_s ?? Infinity) - (b.start_s ?? Infinity),
  )
