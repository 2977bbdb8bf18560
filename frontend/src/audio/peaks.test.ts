import { describe, expect, test } from 'vitest'

import { amplitudeOf, columnsOf, finePeaks, levelsOf, type Peaks } from './peaks'

const flat = (points: number, value: number): Peaks => ({
  points,
  min: Array<number>(points).fill(-value),
  max: Array<number>(points).fill(value),
  rms: Array<number>(points).fill(value),
})

describe('columns', () => {
  test('an extreme of one point is seen, however many points share its column', () => {
    const peaks = flat(1000, 0)
    const max = [...peaks.max]
    max[501] = 127
    const columns = columnsOf({ ...peaks, max }, 10)
    expect([...columns.max]).toEqual([0, 0, 0, 0, 0, 1, 0, 0, 0, 0])
  })

  test('the RMS of a column is the root of the mean of the squares', () => {
    const columns = columnsOf({ points: 2, min: [0, 0], max: [127, 127], rms: [127, 0] }, 1)
    expect(columns.rms[0]).toBeCloseTo(Math.SQRT1_2, 6)
  })

  test('quiet stays quiet: one step of 127 is not scaled up', () => {
    const columns = columnsOf(flat(100, 1), 50)
    expect(Math.max(...columns.max)).toBeCloseTo(1 / 127, 6)
    expect(Math.min(...columns.min)).toBeCloseTo(-1 / 127, 6)
  })

  test('between few points it draws straight lines, and the ends keep their values', () => {
    const columns = columnsOf({ points: 2, min: [0, 0], max: [0, 127], rms: [0, 0] }, 4)
    expect([...columns.max].map((value) => Number(value.toFixed(3)))).toEqual([0, 0.25, 0.75, 1])
  })

  test('fine peaks are parts of full scale', () => {
    const columns = columnsOf(finePeaks({ points: 1, min: [-0.5], max: [0.25], rms: [0.125] }), 1)
    expect([columns.min[0], columns.max[0], columns.rms[0]]).toEqual([-0.5, 0.25, 0.125])
  })

  test('fine peaks in steps of a full scale draw the same', () => {
    const columns = columnsOf(finePeaks({ points: 1, min: [-5000], max: [2500], rms: [1250], full_scale: 10_000 }), 1)
    expect([columns.min[0], columns.max[0], columns.rms[0]]).toEqual([-0.5, 0.25, 0.125])
  })

  test('no points draw nothing', () => {
    expect([...columnsOf({ points: 0, min: [], max: [], rms: [] }, 2).max]).toEqual([0, 0])
  })
})

describe('levels', () => {
  test('full scale is 0 dBFS, half of it −6.02, silence −∞', () => {
    expect(levelsOf(finePeaks({ points: 1, min: [-1], max: [1], rms: [1] }), 1)[0]).toBeCloseTo(0, 5)
    expect(levelsOf(finePeaks({ points: 1, min: [-1], max: [1], rms: [0.5] }), 1)[0]).toBeCloseTo(-6.0206, 3)
    expect(levelsOf(flat(4, 0), 1)[2]).toBe(-Infinity)
  })

  test('a window averages power: one of three points at full scale reads −4.77 dB', () => {
    const peaks = finePeaks({ points: 5, min: [], max: [], rms: [0, 0, 1, 0, 0] })
    // 5 points in 0.1 s are 20 ms apart; a window of 40 ms takes one neighbour on each side.
    const levels = levelsOf(peaks, 0.1, 0.04)
    expect(levels[2]).toBeCloseTo(10 * Math.log10(1 / 3), 4)
    expect(levels[0]).toBe(-Infinity)
  })
})

test('−6.0206 dB is half', () => {
  expect(amplitudeOf(-6.0206)).toBeCloseTo(0.5, 5)
})
