import { expect, test } from 'vitest'

import { CONDITIONS } from './conditions'

/** A-weighting in octaves from 63 Hz, IEC 61672-1. */
const A_WEIGHTS_DB: Record<number, number> = {
  63: -26.2,
  125: -16.1,
  250: -8.6,
  500: -3.2,
  1000: 0,
  2000: 1.2,
  4000: 1,
  8000: -1.1,
}

test.each([
  ['quiet-room', 30.1],
  ['train', 66.8],
])('the noise of the %s is as loud as stated, in dB(A) at the level of a small room', (id, dba) => {
  const noise = CONDITIONS.find((one) => one.id === id)?.noise
  const power = noise?.octaves.reduce(
    (sum, { hz, dbfs }) => sum + 10 ** ((dbfs + 96 + (A_WEIGHTS_DB[hz] ?? 0)) / 10),
    0,
  )
  expect(10 * Math.log10(power ?? 0)).toBeCloseTo(dba, 0)
})

test('each has its own name and figures', () => {
  expect(new Set(CONDITIONS.flatMap(({ id, name }) => [id, name])).size).toBeGreaterThanOrEqual(CONDITIONS.length)
  expect(new Set(CONDITIONS.map(({ figures }) => figures)).size).toBe(CONDITIONS.length)
})
