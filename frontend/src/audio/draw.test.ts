import { expect, test } from 'vitest'

import { rememberingSurface } from '@/test/surface'

import { drawGrid, drawLimit, drawWave, inkOf, rgbOf } from './draw'
import { finePeaks } from './peaks'

const one = (min: number, max: number, rms: number) => finePeaks({ points: 1, min: [min], max: [max], rms: [rms] })

test('full scale is the height: half an amplitude is half of it, and nothing fills up', () => {
  const { surface, rects } = rememberingSurface(1, 102)
  drawWave(surface, one(-0.5, 0.5, 0.25), { highlighted: false, pad: 1 })
  expect(rects).toEqual([
    { fill: 'wave-peak', x: 0, y: 26, w: 1, h: 50 },
    { fill: 'wave-rms', x: 0, y: 38.5, w: 1, h: 25 },
  ])
})

test('silence is a line, not nothing', () => {
  const { surface, rects } = rememberingSurface(1, 100)
  drawWave(surface, one(0, 0, 0), { highlighted: true })
  expect(rects.map(({ fill, h }) => [fill, h])).toEqual([
    ['wave-peak-on', 1],
    ['wave-rms-on', 1],
  ])
})

test('only what exceeds the limit is coloured as over it', () => {
  const { surface, rects } = rememberingSurface(1, 200)
  // −6.0206 dB is half: a crest at 1 exceeds it by half the reach of 100 px, a trough at −0.4 does not.
  drawWave(surface, one(-0.4, 1, 0.3), { highlighted: false, limitDbfs: -6.0206, pad: 0 })
  const over = rects.filter(({ fill }) => fill === 'wave-over')
  expect(over).toHaveLength(1)
  expect(over[0]?.y).toBeCloseTo(0, 2)
  expect(over[0]?.h).toBeCloseTo(51, 2)
})

test('the core stays inside the peaks of a one-sided sound', () => {
  const { surface, rects } = rememberingSurface(1, 200)
  drawWave(surface, one(0.2, 0.6, 0.4), { highlighted: false, pad: 0 })
  const core = rects.find(({ fill }) => fill === 'wave-rms')
  expect(core?.y).toBeCloseTo(60, 5)
  expect((core?.y ?? 0) + (core?.h ?? 0)).toBeCloseTo(80, 5)
})

test('the grid has a line at each round time and at −6 and −12 dB on both sides', () => {
  const { surface, rects } = rememberingSurface(840, 200)
  drawGrid(surface, 0.84, 0.1, 0)
  const upright = rects.filter(({ w }) => w === 1)
  expect(upright.map(({ x }) => x)).toEqual([100, 200, 300, 400, 500, 600, 700, 800])
  const level = rects.filter(({ w }) => w === 840).map(({ y }) => y)
  expect(level).toEqual([50, 150, 75, 125])
})

test('the limit is dashed, above and below', () => {
  const { surface, rects } = rememberingSurface(12, 200)
  drawLimit(surface, 0, 10)
  expect(new Set(rects.map(({ y }) => y))).toEqual(new Set([10, 190]))
  expect(rects.every(({ fill, w }) => fill === 'wave-limit' && w === 3)).toBe(true)
})

test('the spectrum is one ramp of ink', () => {
  const pixels = inkOf({ columns: 3, rows: 1, values: [0, 255, 51] }, rgbOf('#f1f2ef'), rgbOf('rgb(19, 21, 20)'))
  expect([...pixels.subarray(0, 4)]).toEqual([241, 242, 239, 255])
  expect([...pixels.subarray(4, 8)]).toEqual([19, 21, 20, 255])
  // A fifth of the way from 241 to 19.
  expect(pixels[8]).toBeCloseTo(196.6, -0.5)
})
