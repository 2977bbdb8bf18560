import { expect, test } from 'vitest'

import { aFinding, aTake } from '@/test/review'

import { AS_DELIVERED, inOrder, letterOf, matchGains, outlierOf, sourceOf, soundOf, targetsOf } from './hearing'

test('takes are heard at the loudness of the first, and no true peak passes −1 dBTP', () => {
  const takes = [
    aTake('a', { loudness_lufs: -16, true_peak_dbtp: -6 }),
    aTake('b', { loudness_lufs: -13.9, true_peak_dbtp: -2 }),
    aTake('c', { loudness_lufs: -20, true_peak_dbtp: -2 }),
  ]
  // Lifted by 4 dB the last would reach +2 dBTP: all come down by 3 dB.
  const gains = matchGains(takes)
  expect([...gains.values()].map((db) => Number(db.toFixed(6)))).toEqual([-3, -5.1, 1])
  expect(takes.map((take) => sourceOf(take, 'master', gains)?.matchGainDb?.toFixed(1))).toEqual(['-3.0', '-5.1', '1.0'])
  expect(takes[1] && sourceOf(takes[1], 'master')?.matchGainDb).toBe(0)
})

const out = [aFinding({ check: 'variation-set', code: 'variation-set:level' })]

test('the odd one of a set is the farthest that the check names', () => {
  const set = [
    aTake('1', { variation: 1, away_from_set_lu: -1.2 }),
    aTake('2', { variation: 2, away_from_set_lu: -2.1, findings: out }),
    aTake('3', { variation: 3, away_from_set_lu: 4, findings: out }),
  ]
  expect(outlierOf(set)).toEqual({ take: set[2], awayDb: 4 })
})

test('a set of which the check names none has no odd one', () => {
  expect(outlierOf([aTake('1', { away_from_set_lu: 1.9 }), aTake('2', { findings: [aFinding()] })])).toBeNull()
})

test('letters follow the order of delivery within a variation', () => {
  const takes = [aTake('new', { number: 3 }), aTake('old', { number: 1 }), aTake('mid', { number: 2 })]
  expect(inOrder(takes).map(({ id }) => id)).toEqual(['old', 'mid', 'new'])
  expect(takes.map((take) => letterOf(take, takes))).toEqual(['C', 'A', 'B'])
})

test('a target is heard from its own file, and its refusal is kept', () => {
  const game = {
    id: null,
    loudness_lufs: -19,
    true_peak_dbtp: -2,
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
  expect(soundOf(take, 'game').level).toEqual({ loudnessLufs: -19, truePeakDbtp: -2 })
  expect(soundOf(take, 'master').level).toEqual({ loudnessLufs: -16, truePeakDbtp: -1 })
  expect(soundOf(take, 'handheld')).toMatchObject({ previewUrl: null, refusal: 'too low a rate' })
  expect(soundOf(take, 'master').previewUrl).toBe('/v1/sounds/a/preview')
})

const delivered = (facts: Record<string, unknown>) =>
  aTake('a', { facts: { container: 'wav', encoding: 'pcm', bit_depth: 24, channels: 2, ...facts } })

test('a master of 24 bits is heard as it was delivered too', () => {
  const take = delivered({})
  expect(targetsOf([take])).toEqual(['master', AS_DELIVERED])
  expect(sourceOf(take, AS_DELIVERED)).toMatchObject({ takeId: 'a', url: '/v1/takes/a/master' })
  expect(sourceOf(delivered({ container: 'flac' }), AS_DELIVERED)?.url).toBe('/v1/takes/a/master')
})

test.each([{ bit_depth: 16 }, { container: 'aiff' }, { channels: 6 }, { encoding: 'vorbis' }])(
  'a master with %o is heard by its preview only',
  (facts) => {
    expect(targetsOf([delivered(facts)])).toEqual(['master'])
    expect(sourceOf(delivered(facts), AS_DELIVERED)?.url).toBe('/v1/sounds/a/preview')
  },
)
