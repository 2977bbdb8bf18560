import { expect, test } from 'vitest'

import { seeded } from '@/audio/random'

import { type Level, loweredWords, matchedGainsDb, matchedWords } from './levels'

const level = (loudnessLufs: number | null, truePeakDbtp: number | null = -6): Level => ({ loudnessLufs, truePeakDbtp })

test('a sound 2.1 LU above the first comes down by 2.1 dB', () => {
  expect(matchedGainsDb([level(-16), level(-13.9)])).toEqual([0, expect.closeTo(-2.1, 9)])
})

test('a softer one goes up as far as its true peak allows', () => {
  // 4 dB up from −6 dBTP is −2 dBTP.
  expect(matchedGainsDb([level(-16), level(-20)])).toEqual([0, 4])
  expect(matchedGainsDb([level(-16), level(-20, -5)])).toEqual([0, 4])
})

test('where lifting one would pass −1 dBTP, both come down instead', () => {
  // 9.1 − 3.2 = 5.9 LU apart: lifted by 5.9 dB the second would reach −1 + 3.2 dBTP.
  const gains = matchedGainsDb([level(-16, -2), level(-21.9, -3.7)])
  expect(gains[0]).toBeCloseTo(-3.2, 9)
  expect(gains[1]).toBeCloseTo(2.7, 9)
  expect(-3.7 + (gains[1] ?? 0)).toBeCloseTo(-1, 9)
})

test('a first one that is itself over the limit takes the others down with it', () => {
  expect(matchedGainsDb([level(-14, 0.5), level(-14)])).toEqual([-1.5, -1.5])
})

test('what has no loudness is heard as sent, and alone nothing is matched', () => {
  expect(matchedGainsDb([level(null), level(-16), level(-18)])).toEqual([0, 0, 2])
  expect(matchedGainsDb([level(-16, 0), level(null)])).toEqual([0, 0])
  expect(matchedGainsDb([level(-16, 0)])).toEqual([0])
  expect(matchedGainsDb([])).toEqual([])
})

test('without a known true peak nothing is lifted, and by more than 24 dB nothing either', () => {
  expect(matchedGainsDb([level(-16), level(-20, null)])).toEqual([-4, 0])
  expect(matchedGainsDb([level(-16), level(-70, -60)])).toEqual([-30, 24])
})

test('of any loudness and peaks none passes the limit, and the differences stay those of the loudness', () => {
  const random = seeded(27)
  for (let round = 0; round < 300; round += 1) {
    const levels = Array.from({ length: 2 + Math.floor(random() * 7) }, () =>
      level(random() < 0.1 ? null : -70 + 75 * random(), random() < 0.1 ? null : -60 + 66 * random()),
    )
    const gains = matchedGainsDb(levels)
    const matched = levels.flatMap(({ loudnessLufs, truePeakDbtp }, index) =>
      loudnessLufs === null ? [] : [{ loudnessLufs, truePeakDbtp, gainDb: gains[index] ?? NaN }],
    )
    if (matched.length < 2) continue
    const [first] = matched
    for (const { loudnessLufs, truePeakDbtp, gainDb } of matched) {
      if (truePeakDbtp === null) expect(gainDb).toBeLessThanOrEqual(1e-9)
      else expect(truePeakDbtp + gainDb).toBeLessThanOrEqual(-1 + 1e-9)
      expect(gainDb).toBeLessThanOrEqual(24 + 1e-9)
      expect(loudnessLufs + gainDb).toBeCloseTo((first?.loudnessLufs ?? NaN) + (first?.gainDb ?? NaN), 9)
    }
  }
})

test('what was done is said by name, of many by its range', () => {
  const named = (...gains: number[]) => gains.map((gainDb, index) => ({ name: 'ABCDEF'[index] ?? '', gainDb }))
  expect(matchedWords(named(-3.2, -9.1))).toBe('matched: A −3.2 dB, B −9.1 dB')
  expect(matchedWords(named(0, 1.44))).toBe('matched: A 0.0 dB, B +1.4 dB')
  expect(matchedWords(named(0, 1, -2, 3, -4))).toBe('matched: −4.0 dB to +3.0 dB')
  expect(matchedWords(named(-3))).toBe('')
  expect(loweredWords([-3.24, 1])).toBe('Levels matched, the first lowered by 3.2 dB')
  expect(loweredWords([0, -4])).toBe('Levels matched to the first')
})
