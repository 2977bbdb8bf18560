import { expect, test } from 'vitest'

import { isSoon } from './words'

test.each([
  ['2026-11-20', true],
  ['2026-11-24', true],
  ['2026-11-26', false],
])('on 21 November %s is soon: %s', (on, soon) => {
  expect(isSoon(on, new Date('2026-11-21T12:00:00Z'))).toBe(soon)
})
