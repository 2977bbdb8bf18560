import { describe, expect, test } from 'vitest'

import { otherMembers, proposedPrefix } from '../words'
import { diffLines, folded } from './diff'
import { fits } from './naming'
import { correctionOf, hasComments, lineOf } from './places'
import { namesInWords } from './say'
import checks from '@/test/checks.json'

import type { Check } from '../api'
import { differences, exact, lengthOf } from './say'
import { put, same, typedNumber } from './tables'

describe('line by line', () => {
  test('the longest common lines stay', () => {
    const lines = diffLines('a\nb\nc\nd', 'a\nc\nx\nd')
    expect(lines.map(({ kind, text }) => `${kind} ${text}`)).toEqual(['same a', 'gone b', 'same c', 'new x', 'same d'])
    expect(lines.map(({ before, after }) => [before, after])).toEqual([
      [1, 1],
      [2, null],
      [3, 2],
      [null, 3],
      [4, 4],
    ])
  })

  test('what is left and what came rebuild both texts, whatever they are', () => {
    const letters = 'abc'
    let seed = 7
    const random = (below: number) => {
      seed = (seed * 1103515245 + 12345) % 2147483648
      return seed % below
    }
    const text = () => Array.from({ length: random(9) }, () => letters.charAt(random(3))).join('\n')
    for (let round = 0; round < 300; round += 1) {
      const before = text()
      const after = text()
      const lines = diffLines(before, after)
      expect(lines.flatMap(({ kind, text: one }) => (kind === 'new' ? [] : [one])).join('\n')).toBe(before)
      expect(lines.flatMap(({ kind, text: one }) => (kind === 'gone' ? [] : [one])).join('\n')).toBe(after)
    }
  })

  test('far lines that are the same fold into a count', () => {
    const before = Array.from({ length: 20 }, (_, index) => `line ${index}`)
    const after = before.with(10, 'changed')
    const parts = folded(diffLines(before.join('\n'), after.join('\n')), 2)
    expect(parts[0]).toEqual({ kind: 'skipped', count: 8 })
    expect(parts.filter(({ kind }) => kind === 'same')).toHaveLength(4)
    expect(parts.at(-1)).toEqual({ kind: 'skipped', count: 7 })
  })
})

describe('where in the text', () => {
  const TOML = [
    'format = 1', // 1
    '[limits]', // 2
    'sample_peak_dbfs = -0.1', // 3
    '[categories.music]', // 4
    'accept.duration_s = { max = 300.0 }', // 5
    '[targets."game"]', // 6
    'bit_depth = 16', // 7
  ].join('\n')

  test.each([
    ['format', 1],
    ['limits.sample_peak_dbfs', 3],
    ['categories.music.accept.duration_s.max', 5],
    ['targets.game.bit_depth', 7],
    ['targets.game.sample_rate_hz', 6],
    ['limits', 2],
  ])('%s stands in line %i', (place, line) => {
    expect(lineOf(TOML, place)).toBe(line)
  })

  test('a place that is nowhere has no line; a line that is named is taken', () => {
    expect(lineOf(TOML, 'naming.pattern')).toBeNull()
    expect(lineOf(TOML, '', 'is not TOML: Invalid value (at line 3, column 7)')).toBe(3)
  })

  test('the nearest known word takes the place of the wrong one, key or value', () => {
    expect(
      correctionOf('[limits]\npeak = 1', 'limits.peak', 'unknown key; the nearest known is "sample_peak_dbfs"')?.toml,
    ).toBe('[limits]\nsample_peak_dbfs = 1')
    const message = 'wanted one of error, warning, off, found "eror"; the nearest known is "error"'
    expect(correctionOf('[checks]\neror-peak = "eror"', 'checks.eror-peak', message)?.toml).toBe(
      '[checks]\neror-peak = "error"',
    )
    expect(correctionOf('[limits]\nx = 1', 'limits.x', 'wanted a number')).toBeNull()
  })

  test('a hash in quotes is no comment', () => {
    expect(hasComments('pattern = \'a # b\'\nname = "x # y"')).toBe(false)
    expect(hasComments('bit_depth = 16 # or any')).toBe(true)
    expect(hasComments('# words')).toBe(true)
  })
})

describe('tables', () => {
  test('a key that goes takes the table that it empties', () => {
    expect(put({ limits: { a: 1 }, name: 'x' }, ['limits', 'a'], undefined)).toEqual({ name: 'x' })
    expect(put({ limits: { a: 1, b: 2 } }, ['limits', 'a'], undefined)).toEqual({ limits: { b: 2 } })
    expect(put({}, ['accept', 'duration_s', 'max'], 3)).toEqual({ accept: { duration_s: { max: 3 } } })
  })

  test('a changed key keeps its place among the others', () => {
    expect(Object.keys(put({ a: 1, b: 2, c: 3 }, ['b'], 9))).toEqual(['a', 'b', 'c'])
  })

  test('the same is the same in any order', () => {
    expect(same({ a: [1, 2], b: { c: 1 } }, { b: { c: 1 }, a: [1, 2] })).toBe(true)
    expect(same({ a: [1, 2] }, { a: [2, 1] })).toBe(false)
    expect(same({ a: 1 }, { a: 1, b: 1 })).toBe(false)
  })

  test.each([
    ['-0.1', -0.1],
    ['−1', -1],
    ['0,05', 0.05],
    [' 30 ', 30],
    ['', undefined],
    ['any', 'any'],
    ['1e5', '1e5'],
    ['0x10', '0x10'],
    ['-', '-'],
  ])('%j is typed for %j', (typed, value) => expect(typedNumber(typed)).toBe(value))
})

describe('in words', () => {
  test('lengths and figures keep their digits', () => {
    expect(lengthOf({ min: 0.01, max: 30 })).toBe('0.01–30 s')
    expect(lengthOf({ min: null, max: 300 })).toBe('up to 300 s')
    expect(lengthOf({ min: 0.5 })).toBe('0.5 s or more')
    expect(lengthOf({})).toBe('any')
    expect(exact(-1, 1)).toBe('−1.0')
    expect(exact(0.05, 1)).toBe('0.05')
  })

  test('what a category asks otherwise', () => {
    const tables = {
      accept: { duration_s: { min: 0.01, max: 30 } },
      categories: {
        vo: {
          kind: 'voice',
          accept: { channels: [1], duration_s: { max: 60 } },
          limits: { head_silence_ms: 50, tail_silence_ms: 150, true_peak_dbtp: 'any' },
          checks: { 'true-peak': 'error', clipping: 'off' },
          targets: { handheld: { bit_depth: 24 } },
        },
      },
    }
    expect(differences(tables, 'vo', checks as Check[])).toEqual([
      'mono',
      '0.01–60 s',
      'true peak is sent back',
      'clipping is not checked',
      'leading silence 50 ms',
      'trailing silence 150 ms',
      'true peak not limited',
      'handheld 24 bit',
    ])
    expect(differences(tables, 'ui', checks as Check[])).toEqual([])
  })

  test('a pattern holds for the whole name; one that cannot be read is tried by nobody', () => {
    expect(fits('[a-z]+', 'laser')).toBe(true)
    expect(fits('[a-z]+', 'laser_1')).toBe(false)
    expect(fits('a|b', 'ab')).toBe(false)
    expect(fits('any', 'Whatever!')).toBe(true)
    expect(fits('(?P<x>a)', 'a')).toBeNull()
  })

  test.each([
    ['Shield Wing', 'SW'],
    ['Starfall', 'STA'],
    ['Éclair', 'ECL'],
    ['7 Days', 'D'],
    ['the_long-night', 'TLN'],
    ['!', ''],
  ])('%s is shortened to %s', (name, prefix) => expect(proposedPrefix(name)).toBe(prefix))
})

test('sentences with 0, 1 and 2', () => {
  expect([0, 1, 2].map(otherMembers)).toEqual([
    '+ 0 other team members',
    '+ 1 other team member',
    '+ 2 other team members',
  ])
  expect(namesInWords([], 1)).toBe('The one name in the list matches.')
  expect(namesInWords([], 2)).toBe('All 2 names in the list match.')
  expect(namesInWords(['laser'], 1)).toBe('1 of 1 name in the list doesn’t match: laser')
  expect(namesInWords(['laser'], 2)).toBe('1 of 2 names in the list doesn’t match: laser')
  expect(namesInWords(['laser', 'hum'], 2)).toBe('2 of 2 names in the list don’t match: laser, hum')
})
