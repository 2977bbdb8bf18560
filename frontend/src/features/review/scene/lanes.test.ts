import { beforeEach, describe, expect, test } from 'vitest'

import { HandContext } from '@/test/audioContext'

import { placed, placingOf, SceneLanes } from './lanes'

let context: HandContext
const to = {} as AudioNode

beforeEach(() => {
  context = new HandContext()
})

const real = () => context as unknown as BaseAudioContext
const sound = (durationS: number, samples: number[]): AudioBuffer => {
  const made = context.createBuffer(1, samples.length, samples.length / durationS)
  made.copyToChannel(Float32Array.from(samples), 0)
  return made
}
const start = (fromS: number, loop: { startS: number; endS: number } | null = null) => ({
  context: real(),
  to,
  atS: context.currentTime,
  fromS,
  loop,
})
const lane = (id: string, levelDb = 0, isOn = true, buffer = sound(8, [1, 2, 3, 4])) => ({ id, buffer, levelDb, isOn })

describe('a sound over the length of a scene', () => {
  const four = { lengthS: 2, loops: false }

  test('plays once from each start, and what overlaps adds up', () => {
    const whole = placed(sound(1, [1, 2, 3, 4]), real(), { ...four, startsS: [0.25, 0.75] })
    expect([...whole.getChannelData(0)]).toEqual([0, 1, 2, 4, 6, 3, 4, 0])
    expect(whole.duration).toBe(2)
  })

  test('goes round to the end as a loop, from its first start', () => {
    const whole = placed(sound(0.75, [1, 2, 3]), real(), { ...four, loops: true, startsS: [0] })
    expect([...whole.getChannelData(0)]).toEqual([1, 2, 3, 1, 2, 3, 1, 2])
  })

  test('is cut at the end of the scene, at its level', () => {
    const whole = placed(sound(1, [10, 10, 10, 10]), real(), { ...four, startsS: [1.5] }, -20)
    expect([...whole.getChannelData(0)]).toEqual([0, 0, 0, 0, 0, 0, 1, 1])
  })

  test('is placed once for each alternate, and begins where it first plays', () => {
    const placing = placingOf({ startsS: [0.5, 1], loops: false, lengthS: 2 }, 0)
    const one = sound(1, [1, 2, 3, 4])
    expect(placing.startS).toBe(0.5)
    expect(placing.place(one, real())).toBe(placing.place(one, real()))
    expect(placingOf({ startsS: [0], loops: true, lengthS: 2 }, 0).startS).toBe(0)
  })
})

describe('lanes', () => {
  test('all begin at the same moment and place, at their levels, and a muted one is silent', () => {
    const lanes = new SceneLanes()
    lanes.set([lane('engine', -6.0206), lane('music', 0, false)])
    context.currentTime = 3
    lanes.begin(start(1.5))
    expect(context.started.map(({ atS, fromS }) => [atS, fromS])).toEqual([
      [3, 1.5],
      [3, 1.5],
    ])
    expect(context.started[0]?.gain.value).toBeCloseTo(0.5)
    expect(context.started[1]?.gain.value).toBe(0)
  })

  test('go on without a gap while alternates are switched at the same place', () => {
    const lanes = new SceneLanes()
    lanes.set([lane('engine')])
    lanes.begin(start(1))
    context.currentTime = 0.7
    lanes.begin(start(1.7))
    expect(context.started).toHaveLength(1)
    expect(context.started[0]?.stoppedAtS).toBeNull()
  })

  test('go on round the loop too', () => {
    const lanes = new SceneLanes()
    lanes.set([lane('engine')])
    lanes.begin(start(7, { startS: 0, endS: 8 }))
    context.currentTime = 1.5
    lanes.begin(start(0.5, { startS: 0, endS: 8 }))
    expect(context.started).toHaveLength(1)
    expect(context.started[0]).toMatchObject({ loop: true, loopStart: 0, loopEnd: 8 })
  })

  test('begin again where the listener goes elsewhere', () => {
    const lanes = new SceneLanes()
    lanes.set([lane('engine')])
    lanes.begin(start(1))
    context.currentTime = 0.7
    lanes.begin(start(4))
    expect(context.started.map(({ atS, fromS }) => [atS, fromS])).toEqual([
      [0, 1],
      [0.7, 4],
    ])
    expect(context.started[0]?.stoppedAtS).toBeCloseTo(0.705)
  })

  test('a changed level is faded, a new sound joins where the others are, and one that is gone falls silent', () => {
    const lanes = new SceneLanes()
    const engine = lane('engine')
    lanes.set([engine, lane('old')])
    lanes.begin(start(1))
    context.currentTime = 0.5
    lanes.set([{ ...engine, levelDb: -20 }, lane('laser')])
    expect(context.started).toHaveLength(3)
    expect(context.started[0]?.gain.calls.at(-1)).toEqual(['ramp', 0.1, 0.505])
    expect(context.started[1]?.stoppedAtS).toBeCloseTo(0.505)
    expect(context.started[2]).toMatchObject({ atS: 0.5, fromS: 1.5 })
  })

  test('end together, and nothing sounds that was not begun', () => {
    const lanes = new SceneLanes()
    lanes.end(1)
    lanes.set([lane('engine')])
    expect(context.started).toHaveLength(0)
    lanes.begin(start(0))
    lanes.end(2)
    expect(context.started[0]?.stoppedAtS).toBe(2)
  })
})
