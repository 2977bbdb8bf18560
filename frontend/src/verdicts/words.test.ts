import { expect, test } from 'vitest'

import { aCue } from '@/test/review'

import { isSoon, urgencyReason } from './words'

test.each([
  ['2026-11-20', true],
  ['2026-11-24', true],
  ['2026-11-26', false],
])('on 21 November %s is soon: %s', (on, soon) => {
  expect(isSoon(on, new Date('2026-11-21T12:00:00Z'))).toBe(soon)
})

test.each([
  [{ palette: true }, 'palette'],
  [{ due_on: '2026-11-24' }, 'due Tuesday 24 November, in 3 days'],
  [{ palette: true, due_on: '2026-11-20' }, 'palette, due Friday 20 November, yesterday'],
])('%o comes first: %s', (cue, words) => {
  expect(urgencyReason(aCue(cue), new Date('2026-11-21T12:00:00Z'))).toBe(words)
})
