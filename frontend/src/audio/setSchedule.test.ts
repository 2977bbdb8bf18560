import { expect, test } from 'vitest'

import { seeded } from './random'
import { type Hit, hitsOf, nextInSet, IN_ORDER, type SetPlaybackMode } from './setSchedule'

function first(count: number, durationsS: number[], way: SetPlaybackMode, seed = 1): Hit[] {
  const hits = hitsOf(durationsS, way, seeded(seed))
  return Array.from({ length: count }, () => hits.next().value)
}

const STEPS = [0.3, 0.4, 0.5, 0.6]

test('two steps a second start every 0.5 s, 600 rounds a minute every 0.1 s', () => {
  const at = (intervalS: number) => first(5, STEPS, { ...IN_ORDER, intervalS }).map(({ atS }) => Number(atS.toFixed(9)))
  expect(at(0.5)).toEqual([0, 0.5, 1, 1.5, 2])
  expect(at(0.1)).toEqual([0, 0.1, 0.2, 0.3, 0.4])
})

test('free, each starts when the one before is over, at the pitch it was played', () => {
  const hits = first(50, STEPS, { intervalS: null, pitchSemitones: 2, levelDb: 0 })
  hits.slice(1).forEach(({ atS }, index) => {
    const before = hits[index]
    expect(before && before.atS + (STEPS[before.index] ?? 0) / before.speed).toBeCloseTo(atS, 9)
  })
})

test('never the same twice running, and all of them about as often', () => {
  const indexes = first(4_000, STEPS, IN_ORDER).map(({ index }) => index)
  expect(indexes.filter((index, at) => index === indexes[at - 1])).toEqual([])
  for (const wanted of [0, 1, 2, 3]) {
    const share = indexes.filter((index) => index === wanted).length / indexes.length
    expect(Math.abs(share - 0.25)).toBeLessThan(0.02)
  }
})

test('from any one each of the others is reached, and one alone repeats', () => {
  for (let last = 0; last < 4; last += 1) {
    const reached = new Set([0, 0.34, 0.67, 0.999].map((value) => nextInSet(last, 4, () => value)))
    expect(reached).toEqual(new Set([0, 1, 2, 3].filter((index) => index !== last)))
  }
  expect(first(3, [0.5], IN_ORDER).map(({ index }) => index)).toEqual([0, 0, 0])
})

test('pitch and level stray as far as stated and no farther, and none is louder than the sound itself', () => {
  const hits = first(2_000, STEPS, { intervalS: 0.1, pitchSemitones: 2, levelDb: 3 })
  const semitones = hits.map(({ speed }) => 12 * Math.log2(speed))
  const gains = hits.map(({ gainDb }) => gainDb)
  for (const [values, low, high] of [
    [semitones, -2, 2],
    [gains, -6, 0],
  ] as const) {
    const margin = 0.01 * (high - low)
    expect(Math.min(...values)).toBeGreaterThanOrEqual(low)
    expect(Math.min(...values)).toBeLessThan(low + margin)
    expect(Math.max(...values)).toBeLessThanOrEqual(high)
    expect(Math.max(...values)).toBeGreaterThan(high - margin)
  }
})

test('the same seed gives the same schedule', () => {
  const way = { intervalS: 0.5, pitchSemitones: 1, levelDb: 1 }
  expect(first(20, STEPS, way, 7)).toEqual(first(20, STEPS, way, 7))
  expect(first(20, STEPS, way, 7)).not.toEqual(first(20, STEPS, way, 8))
})
