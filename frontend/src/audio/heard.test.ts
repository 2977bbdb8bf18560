import { afterEach, expect, test, vi } from 'vitest'

import { Hand } from '@/test/handPlayer'

import { heardTimeS } from './schedule'

const A = { id: 'a', url: '/a' }
const B = { id: 'b', url: '/b' }
/** What the device is late, and how long before its start a sound is handed to it. */
const LATENCY_S = 0.03
const LEAD_S = 0.02

afterEach(() => vi.restoreAllMocks())

async function playingFrom(fromS: number) {
  const hand = new Hand({ '/a': { durationS: 10 }, '/b': { durationS: 10 } })
  Object.assign(hand.context, { baseLatency: LEAD_S / 2, outputLatency: LATENCY_S })
  const player = hand.player()
  await player.previews.get('/b')
  await player.select(A)
  player.seek(fromS)
  await player.play()
  return { player, at: (s: number) => Object.assign(hand.context, { currentTime: s }) }
}

test('what is heard is where the device is by its own clock, not a step ahead of it', () => {
  vi.spyOn(performance, 'now').mockReturnValue(5_012)
  const context = { currentTime: 2.05, outputLatency: 0.03 } as unknown as AudioContext
  expect(heardTimeS(context)).toBeCloseTo(2.02, 9)
  const timestamp = (contextTime: number) =>
    Object.assign(context, { getOutputTimestamp: () => ({ contextTime, performanceTime: 5_000 }) })
  expect(heardTimeS(timestamp(2.001))).toBeCloseTo(2.013, 9)
  // A device that has just begun says nothing yet, or what was before.
  expect(heardTimeS(timestamp(0))).toBeCloseTo(2.02, 9)
  expect(heardTimeS(timestamp(1.5))).toBeCloseTo(2.02, 9)
})

test('until a sound is heard the listener is where it begins', async () => {
  const { player, at } = await playingFrom(4)
  expect([player.heardS(), player.isHeard()]).toEqual([4, false])
  at(LEAD_S + LATENCY_S - 0.001)
  expect([player.heardS(), player.isHeard()]).toEqual([4, false])
  at(LEAD_S + LATENCY_S + 0.5)
  expect(player.heardS()).toBeCloseTo(4.5, 9)
  expect(player.isHeard()).toBe(true)
  player.pause()
  expect(player.isHeard()).toBe(false)
  expect(player.heardS()).toBe(player.positionS())
})

test('at a switch the listener goes on without a step, at each step of the playhead', async () => {
  const { player, at } = await playingFrom(4)
  at(1)
  const stepped: [number, boolean][] = []
  player.subscribeState(() => stepped.push([player.heardS(), player.isHeard()]))
  const expectedS = 4 + 1 - LEAD_S - LATENCY_S
  await player.select(B)
  expect(stepped.length).toBeGreaterThan(0)
  for (const [heardS, isHeard] of stepped) {
    expect(heardS).toBeCloseTo(expectedS, 9)
    expect(isHeard).toBe(true)
  }
  at(1.04)
  expect(player.heardS()).toBeCloseTo(expectedS + 0.04, 9)
})

test('another loop leaves the listener where they are; a seek goes there at once', async () => {
  const { player, at } = await playingFrom(4)
  at(1)
  player.setLooping(true)
  expect(player.heardS()).toBeCloseTo(4 + 1 - LEAD_S - LATENCY_S, 9)
  player.seek(8)
  expect([player.heardS(), player.isHeard()]).toEqual([8, false])
})

test('aligned with a position that moves on, the listener hears that position', async () => {
  const { player, at } = await playingFrom(4)
  at(1)
  player.align(7)
  at(1 + LEAD_S + LATENCY_S)
  expect(player.heardS()).toBeCloseTo(7 + LEAD_S + LATENCY_S, 9)
  expect(player.leadS()).toBeCloseTo(LEAD_S + LATENCY_S, 9)
})
