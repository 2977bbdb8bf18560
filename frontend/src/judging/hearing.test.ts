import { expect, test } from 'vitest'

import { aFinding, aTake } from '@/test/review'

import { inOrder, letterOf, matchGainDb, oddOne, soundOf, targetsOf } from './hearing'

const loud = (id: string, variation: number, lufs: number | null) => aTake(id, { variation, loudness_lufs: lufs })

test('a take 2.1 LU above the first comes down by 2.1 dB', () => {
  expect(matchGainDb(loud('b', 1, -13.9), loud('a', 1, -16))).toBeCloseTo(-2.1, 6)
  expect(matchGainDb(loud('a', 1, -16), loud('a', 1, -16))).toBe(0)
})

test('what was not measured is left as sent, and no gain passes 24 dB', () => {
  expect(matchGainDb(loud('b', 1, null), loud('a', 1, -16))).toBe(0)
  expect(matchGainDb(loud('b', 1, -16), undefined)).toBe(0)
  expect(matchGainDb(loud('b', 1, -70), loud('a', 1, -16))).toBe(24)
})

const out = [aFinding({ check: 'variation-set', code: 'variation-set:level' })]

test('the odd one of a set is the farthest that the check names', () => {
  const set = [
    aTake('1', { variation: 1, away_from_set_lu: -1.2 }),
    aTake('2', { variation: 2, away_from_set_lu: -2.1, findings: out }),
    aTake('3', { variation: 3, away_from_set_lu: 4, findings: out }),
  ]
  expect(oddOne(set)).toEqual({ take: set[2], awayDb: 4 })
})

test('a set of which the check names none has no odd one', () => {
  expect(oddOne([aTake('1', { away_from_set_lu: 1.9 }), aTake('2', { findings: [aFinding()] })])).toBeNull()
})

test('letters follow the order of delivery within a variation', () => {
  const takes = [aTake('new', { number: 3 }), aTake('old', { number: 1 }), aTake('mid', { number: 2 })]
  expect(inOrder(takes).map(({ id }) => id)).toEqual(['old', 'mid', 'new'])
  expect(takes.map((take) => letterOf(take, takes))).toEqual(['C', 'A', 'B'])
})

test('a target is heard from its own file, and its refusal is kept', () => {
  const game = {
    id: null,
    picture_id: null,
    thumb: null,
    spectrum_url: null,
    duration_s: 0.79,
    preview_url: '/game',
    peaks_url: '/game-peaks',
  }
  const take = aTake('a', {
    renders: [
      { ...game, target: 'game', state: 'made', refusal: null, attenuation_db: 0.4 },
      {
        ...game,
        target: 'handheld',
        state: 'refused',
        preview_url: null,
        refusal: 'too low a rate',
        attenuation_db: null,
      },
    ],
  })
  expect(targetsOf([take])).toEqual(['master', 'game', 'handheld'])
  expect(soundOf(take, 'game')).toMatchObject({ previewUrl: '/game', durationS: 0.79, attenuationDb: 0.4 })
  expect(soundOf(take, 'handheld')).toMatchObject({ previewUrl: null, refusal: 'too low a rate' })
  expect(soundOf(take, 'master').previewUrl).toBe('/v1/sounds/a/preview')
})
