import { expect, test } from 'vitest'

import { Drift, DRIFT_S, expectedS, offsetMs, thereMs } from './live'

test('the clock offset is that of the shortest round trip', () => {
  expect(offsetMs([])).toBe(0)
  // The server is 5 s ahead. A slow way back makes the first exchange 200 ms wrong, the second 5 ms.
  const slow = { sentMs: 1_000, answeredMs: 1_500, serverMs: 6_050 }
  const quick = { sentMs: 2_000, answeredMs: 2_020, serverMs: 7_005 }
  expect(offsetMs([slow])).toBe(4_800)
  expect(offsetMs([slow, quick])).toBe(4_995)
  expect(offsetMs([quick, slow])).toBe(4_995)
})

test('a request takes half of the shortest round trip to the server', () => {
  expect(thereMs([])).toBe(0)
  expect(
    thereMs([
      { sentMs: 0, answeredMs: 300, serverMs: 9_000 },
      { sentMs: 500, answeredMs: 580, serverMs: 9_540 },
    ]),
  ).toBe(40)
})

test('an offset is wrong by at most half of its round trip', () => {
  for (const there of [0, 0.25, 0.5, 1]) {
    const exchange = { sentMs: 0, answeredMs: 300, serverMs: 9_000 + 300 * there }
    expect(Math.abs(offsetMs([exchange]) - 9_000)).toBeLessThanOrEqual(150)
  }
})

test('a playhead moves on with the server’s clock while it plays', () => {
  const live = { position_s: 2, server_ms: 10_000, is_playing: true }
  expect(expectedS(live, 4_000, 6_500)).toBeCloseTo(2.5)
  expect(expectedS(live, 4_000, 1_000)).toBe(0)
  expect(expectedS({ ...live, is_playing: false }, 4_000, 60_000)).toBe(2)
})

test('a page that is far away jumps at once, and not past the end', () => {
  const jump = (wantedS: number, actualS: number) => new Drift().correction(wantedS, actualS, 5)
  expect(jump(1.1, 1)).toBeNull()
  expect(jump(1.151, 1)).toBe(1.151)
  expect(jump(0.8, 1)).toBe(0.8)
  expect(jump(9, 4.9)).toBeNull()
  expect(jump(9, 1)).toBe(5)
})

test('a page that is a little away jumps once several readings say so, and one alone moves nothing', () => {
  const jumps = (aways: readonly number[]) => {
    const drift = new Drift()
    return aways.map((awayS, index) => drift.correction(index + awayS, index, 60))
  }
  expect(jumps([0.04, 0.04, 0.04, 0.04, 0.04, 0.04])).toEqual([null, null, null, null, 4.04, null])
  expect(jumps([0.015, 0.015, 0.14, 0.015, -0.14, 0.015, 0.015])).toEqual(Array(7).fill(null))
})

test('two clocks that run apart by 100 ppm stay within the drift for five minutes', () => {
  const drift = new Drift()
  let [actualS, most, jumps] = [0, 0, 0]
  for (let tick = 1; tick <= 1_200; tick += 1) {
    const wantedS = tick / 4
    actualS += 1.0001 / 4
    // The device's time comes in steps of 10 ms.
    const read = Math.floor(actualS * 100) / 100
    const jumpS = drift.correction(wantedS, read, 600)
    most = Math.max(most, Math.abs(wantedS - actualS))
    if (jumpS === null) continue
    jumps += 1
    actualS = jumpS
  }
  expect(most).toBeLessThanOrEqual(DRIFT_S + 0.01)
  expect(jumps).toBeLessThanOrEqual(1)
})

test('two pages that follow one playhead are apart by no more than the error of their clocks', () => {
  const live = { position_s: 0, server_ms: 50_000, is_playing: true }
  // Each page's clock and round trip differ; the playhead each aims at differs by half of the round trips at most.
  const pages = [
    { skewMs: -3_000, roundMs: 20, there: 1 },
    { skewMs: 8_000, roundMs: 40, there: 0 },
  ].map(({ skewMs, roundMs, there }) => {
    const exchange = {
      sentMs: 50_000 + skewMs,
      answeredMs: 50_000 + skewMs + roundMs,
      serverMs: 50_000 + roundMs * there,
    }
    return expectedS(live, offsetMs([exchange]), 53_000 + skewMs)
  })
  expect(Math.abs((pages[0] ?? 0) - (pages[1] ?? 9))).toBeLessThanOrEqual(0.03 + 1e-9)
})
