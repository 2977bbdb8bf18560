import { expect, test } from 'vitest'

import type { ContractBrief } from './api'
import { figureInWords, progress } from './words'

const SIGNED = {
  state: 'agreed',
  my_party: 'designer',
  waits_for: [],
  agreed_at: '2026-11-26T11:00:00Z',
  notice: null,
} as unknown as ContractBrief
const notice = (last: string | null): ContractBrief => ({
  ...SIGNED,
  notice: { given_at: '2026-11-30T10:00:00Z', ends_on: last },
})

test('a contract under notice says when it ends', () => {
  expect(progress(SIGNED)).toEqual({ kind: 'accepted', text: 'Signed Thursday 26 November' })
  expect(progress(notice('2026-12-14')).text).toMatch(/^Signed, ends Monday 14 December/)
  expect(progress(notice('2026-12-14')).kind).toBe('warning')
  expect(progress(notice(null)).text).toBe('Signed, notice given')
})

test.each([
  ['extra_round_bp', 2500, '25 %'],
  ['hour_rate_minor', 8000, '€80.00'],
  ['rounds_included', 4, '4'],
  ['court', 'Bern', 'Bern'],
])('the figure %s of %s reads %s', (name, value, words) => {
  expect(figureInWords(name, value, 'EUR')).toBe(words)
})
