import { expect, test } from 'vitest'

import type { Brief } from './api'
import { fitInWords, openWords } from './words'

test.each([
  [0, 0, 'all answered'],
  [1, 0, '1 open'],
  [1, 1, '1 open, named in the contract'],
  [2, 1, '2 open, 1 of them named in the contract'],
  [2, 2, '2 open, 2 of them named in the contract'],
])('%d open questions, of which the contract names %d', (open, needed, words) => {
  const numbers = (count: number) => Array.from({ length: count }, (_, place) => String(place + 1))
  expect(openWords({ open: numbers(open), open_required: numbers(needed) } as unknown as Brief)).toBe(words)
})

test.each([
  [0, 1, '0 of 1 name on the list fit.'],
  [1, 1, 'The one name on the list fits.'],
  [1, 2, '1 of 2 names on the list fits.'],
  [2, 2, 'All 2 names on the list fit.'],
])('%d of %d names fit', (fitting, count, words) => {
  expect(fitInWords(fitting, count)).toBe(words)
})
