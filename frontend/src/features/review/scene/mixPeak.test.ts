import { expect, test } from 'vitest'

import { loweringDb, mixPeak, truePeak } from './mixPeak'

const RATE_HZ = 48_000
const tone = (hz: number, top: number, { phase = 0, frames = 4_800 } = {}): Float32Array =>
  Float32Array.from({ length: frames }, (_, frame) => top * Math.sin((2 * Math.PI * hz * frame) / RATE_HZ + phase))

const bufferOf = (...channels: Float32Array[]): AudioBuffer =>
  ({
    length: channels[0]?.length ?? 0,
    numberOfChannels: channels.length,
    getChannelData: (channel: number) => channels[channel],
  }) as unknown as AudioBuffer

const db = (ratio: number) => 20 * Math.log10(ratio)

test('between samples the curve is higher: a quarter of the rate at 45° reads 3.01 dB above its samples', () => {
  const samples = tone(RATE_HZ / 4, 0.5, { phase: Math.PI / 4 })
  expect(db(Math.max(...samples))).toBeCloseTo(db(0.5) - 3.01, 1)
  expect(Math.abs(db(truePeak(samples)) - db(0.5))).toBeLessThan(0.2)
})

test('a crest on a sample reads as that sample, and silence and nothing as 0', () => {
  expect(truePeak(tone(12_000, 0.5))).toBeCloseTo(0.5, 2)
  expect(truePeak(new Float32Array(1_000))).toBe(0)
  expect(truePeak(new Float32Array(0))).toBe(0)
})

test('the peak is found wherever it is, even across the edge of a block', () => {
  for (const at of [0, 255, 256, 257, 900, 999]) {
    const samples = tone(440, 0.1, { frames: 1_000 })
    samples[at] = 0.9
    expect(truePeak(samples)).toBeGreaterThanOrEqual(0.9 - 1e-6)
  }
})

test('two sounds that would clip together come down to −1 dBTP together, and one below the limit stays', () => {
  const part = { buffer: bufferOf(tone(1_000, 0.8)), gain: 1 }
  expect(mixPeak([part, part])).toBeCloseTo(1.6, 2)
  expect(loweringDb([[part, part]])).toBeCloseTo(db(1.6) + 1, 1)
  expect(loweringDb([[part]])).toBe(0)
  expect(loweringDb([[]])).toBe(0)
})

test('what cancels does not count, and of several mixes the loudest says how far', () => {
  const [up, down] = [bufferOf(tone(1_000, 0.8)), bufferOf(tone(1_000, 0.8, { phase: Math.PI }))]
  const cancelled = [up, down].map((buffer) => ({ buffer, gain: 1 }))
  expect(loweringDb([cancelled])).toBe(0)
  const doubled = [up, up].map((buffer) => ({ buffer, gain: 1 }))
  expect(loweringDb([cancelled, doubled])).toBeCloseTo(db(1.6) + 1, 1)
})

test('each channel counts by itself, a mono sound in both, at its gain; what is muted does not', () => {
  const stereo = bufferOf(tone(1_000, 0.1), tone(1_000, 0.9))
  const mono = bufferOf(tone(1_000, 0.8))
  expect(
    mixPeak([
      { buffer: stereo, gain: 1 },
      { buffer: mono, gain: 0.5 },
    ]),
  ).toBeCloseTo(1.3, 2)
  expect(
    mixPeak([
      { buffer: stereo, gain: 1 },
      { buffer: mono, gain: 0 },
    ]),
  ).toBeCloseTo(0.9, 2)
})
