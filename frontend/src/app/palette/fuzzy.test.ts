import { expect, test } from 'vitest'

import { fit, fitting } from './fuzzy'

const CUES = ['foot_deck_walk', 'foot_ice_run', 'shield_hit', 'suit_hit', 'drone_swarm_loop', 'airlock_cycle']
const find = (query: string) => fitting(query, CUES, (cue) => [cue])

test('letters that begin words find a name', () => {
  expect(find('fdw')[0]).toBe('foot_deck_walk')
  expect(find('dsl')[0]).toBe('drone_swarm_loop')
})

test('a run of letters beats scattered ones', () => {
  expect(find('hit')).toEqual(['suit_hit', 'shield_hit'])
  expect(find('foot')).toEqual(['foot_ice_run', 'foot_deck_walk'])
})

test('what does not hold every letter in order is left out', () => {
  expect(find('ufo')).toEqual([])
  expect(fit('kcol', 'airlock')).toBeNull()
})

test('nothing asked leaves everything as it came', () => {
  expect(find('  ')).toEqual(CUES)
})

test('any of its texts may fit', () => {
  const commands = [
    { label: 'Switch to dark', also: ['theme'] },
    { label: 'Approve', also: [] },
  ]
  expect(fitting('theme', commands, ({ label, also }) => [label, ...also])).toEqual([commands[0]])
})
