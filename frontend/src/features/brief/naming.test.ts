import { describe, expect, test } from 'vitest'

import { correctedName, exampleOf, type Naming, namingFrom, readName } from './naming'
import { fitInWords } from './words'

const NAMING: Naming = {
  tokens: [
    { name: 'what', case: 'lower' },
    { name: 'detail', case: 'lower', repeats: true, optional: true },
    { name: 'variation', digits: 2, optional: true },
  ],
  separator: '_',
  extension: '.wav',
}
const parts = (name: string) => readName(NAMING, name)?.map((token) => token.name) ?? null

describe('reading a name by its parts', () => {
  test.each([
    ['warp.wav', ['what']],
    ['warp_in.wav', ['what', 'detail']],
    ['foot_deck_walk_run.wav', ['what', 'detail', 'detail', 'detail']],
    ['laser_fire_01.wav', ['what', 'detail', 'variation']],
    ['airlock-cycle.wav', null],
    ['Warp_in.wav', null],
    ['warp__in.wav', null],
    ['', null],
  ])('%s', (name, wanted) => expect(parts(name)).toEqual(wanted))

  test('a number of other digits is a detail, since letters and digits are', () => {
    expect(parts('foot_walk_001.wav')).toEqual(['what', 'detail', 'detail'])
  })

  test('a name of many parts is read in a moment', () => {
    const long = `${'a_'.repeat(400)}A.wav`
    expect(parts(long)).toBeNull()
  })

  test('words of a part are these only', () => {
    const naming: Naming = {
      ...NAMING,
      tokens: [
        { name: 'kind', one_of: ['sfx', 'amb'] },
        { name: 'what', case: 'lower' },
      ],
    }
    expect(readName(naming, 'sfx_door.wav')).not.toBeNull()
    expect(readName(naming, 'ui_door.wav')).toBeNull()
  })
})

test('an example shows each part', () => {
  expect(exampleOf(NAMING)).toBe('what_detail_01.wav')
  const capital: Naming = { tokens: [{ name: 'what', case: 'capital' }], separator: '_', extension: '.flac' }
  expect(exampleOf(capital)).toBe('What.flac')
})

test('a name that differs in separators or letters is put right; another is not', () => {
  expect(correctedName(NAMING, 'Airlock-Cycle.wav')).toBe('airlock_cycle.wav')
  expect(correctedName(NAMING, 'airlock (2).wav')).toBeNull()
})

describe('a convention read from names', () => {
  test('parts, separator and the digits of the variation', () => {
    expect(namingFrom('foot_deck_01.wav\nfoot_sand_02.wav\nui_confirm.wav')).toEqual(NAMING)
    expect(namingFrom('audio/SFX-Door-1.wav\naudio/SFX-Gate-2.wav')).toEqual({
      tokens: [
        { name: 'what', case: 'capital' },
        { name: 'detail', case: 'capital', repeats: true, optional: true },
        { name: 'variation', digits: 1, optional: true },
      ],
      separator: '-',
      extension: '.wav',
    })
  })

  test('names that have nothing in common have none', () => {
    expect(namingFrom('door_é.wav ui_confirm.wav')).toBeNull()
    expect(namingFrom('  ')).toBeNull()
  })
})

test('how many names fit is read with 0, 1 and 2', () => {
  expect(fitInWords(0, 1)).toBe('0 of 1 name on the list fit.')
  expect(fitInWords(1, 1)).toBe('The one name on the list fits.')
  expect(fitInWords(0, 2)).toBe('0 of 2 names on the list fit.')
  expect(fitInWords(1, 2)).toBe('1 of 2 names on the list fits.')
  expect(fitInWords(2, 2)).toBe('All 2 names on the list fit.')
})
