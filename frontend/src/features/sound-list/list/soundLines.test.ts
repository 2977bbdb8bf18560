import { expect, test } from 'vitest'

import { readSoundLines, sheetOfLines } from './soundLines'

const plain = { description: '', durationS: null, variations: 1 }

test.each([
  ['Shield hit', { ...plain, name: 'Shield hit' }],
  [
    'Airlock cycle: door of the ship, 3 s',
    { ...plain, name: 'Airlock cycle', description: 'door of the ship', durationS: 3 },
  ],
  ['Footsteps on deck x6', { ...plain, name: 'Footsteps on deck', variations: 6 }],
  ['laser, 0,3 s × 4', { ...plain, name: 'laser', durationS: 0.3, variations: 4 }],
  ['tick 250 ms', { ...plain, name: 'tick', durationS: 0.25 }],
  ['level 2 min', { ...plain, name: 'level', durationS: 120 }],
  ['box', { ...plain, name: 'box' }],
  ['Boss 3', { ...plain, name: 'Boss 3' }],
  ['note: at 5:00, loud', { ...plain, name: 'note', description: 'at 5:00, loud' }],
  ['3 s', { ...plain, name: '3 s' }],
])('the line "%s" says what it says', (line, sound) => {
  expect(readSoundLines(`\n${line}\r\n  \n`)).toEqual([sound])
})

test('the lines make a sheet with one row each, quotes and commas kept', () => {
  const lines = readSoundLines('a "big" door, heavy\nhatch: of steel x2')
  expect(sheetOfLines(lines)).toBe(
    'name,description,duration_s,variations\n"a ""big"" door, heavy","",,1\n"hatch","of steel",,2',
  )
})
