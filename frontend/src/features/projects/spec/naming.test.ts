import { expect, test } from 'vitest'

import { fits } from './naming'

test.each([
  ['[a-z0-9]+(_[a-z0-9]+)*', 'laser_fire', true],
  ['[a-z0-9]+(_[a-z0-9]+)*', 'Laser', false],
  ['[A-Z]{2}_[A-Za-z0-9_]+', 'SW_Laser', true],
  ['any', 'x y', true],
  ['[', 'x', null],
])('%s on %s', (pattern, name, expected) => {
  expect(fits(pattern, name)).toBe(expected)
})

test.each(['(a+)+b', '(a|a)*b', '(?:.*a){20}', '.*a.*a.*a.*a.*b', `(${'a'.repeat(300)})`])(
  '%s is left to the server, for a search could take for ever',
  (pattern) => {
    expect(fits(pattern, 'a'.repeat(90))).toBeNull()
  },
)
