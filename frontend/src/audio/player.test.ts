import { beforeEach, describe, expect, test, vi } from 'vitest'

import type { HandContext } from '@/test/audioContext'
import { Hand } from '@/test/handPlayer'

import type { Player } from './player'
import type { Source } from './playerState'

const SOUNDS: Record<string, { durationS: number; samples?: number[] }> = {
  '/a': { durationS: 1, samples: [1, 2, 3, 4] },
  '/b': { durationS: 0.5 },
  '/c': { durationS: 2 },
}
const A: Source = { id: 'a', url: '/a' }
const B: Source = { id: 'b', url: '/b', matchGainDb: -6.0206 }
const C: Source = { id: 'c', url: '/c' }

let hand: Hand
let context: HandContext

beforeEach(() => {
  hand = new Hand(SOUNDS)
  context = hand.context
})

async function playing(source: Source = A, parts: Parameters<Hand['player']>[0] = {}): Promise<Player> {
  const made = hand.player(parts)
  await made.select(source)
  await made.play()
  return made
}

const last = () => context.started.at(-1)

describe('playing', () => {
  test('nothing sounds until asked, and taking a sound in the hand is no asking', async () => {
    const made = hand.player()
    await made.select(A)
    made.seek(0.4)
    expect(context.started).toEqual([])
    expect(made.getState()).toMatchObject({ status: 'silent', sourceId: 'a', durationS: 1 })
    expect(made.positionS()).toBe(0.4)
  })

  test('it starts where it stands, and stands where it was paused', async () => {
    const made = hand.player()
    await made.select(A)
    made.seek(0.25)
    await made.play()
    expect(last()?.fromS).toBe(0.25)
    context.currentTime = 0.3
    expect(made.positionS()).toBeCloseTo(0.55, 9)
    made.pause()
    context.currentTime = 9
    expect(made.positionS()).toBeCloseTo(0.55, 9)
    expect(made.getState().status).toBe('paused')
    await made.toggle()
    expect(last()?.fromS).toBeCloseTo(0.55, 9)
  })

  test('at its end it stops, and starts from the beginning again', async () => {
    const made = await playing()
    context.currentTime = 1
    last()?.end()
    expect(made.getState().status).toBe('paused')
    expect(made.positionS()).toBe(1)
    await made.play()
    expect(last()?.fromS).toBe(0)
  })

  test('a start in the middle fades in, a start at the beginning keeps its attack', async () => {
    const made = await playing()
    expect(last()?.gain.calls[0]).toEqual(['set', 1, 0])
    made.seek(0.5)
    expect(last()?.gain.calls[0]).toEqual(['set', 0, 0])
  })

  test('paused while it is still on its way, it stays silent', async () => {
    const made = hand.player()
    void made.select(A)
    const starting = made.play()
    made.pause()
    await starting
    expect(context.started).toEqual([])
  })

  test('what cannot be read is said, and asked for again at the next press', async () => {
    const made = hand.player()
    const gone = { id: 'x', url: '/gone' }
    await made.select(gone)
    await made.play()
    expect(made.getState()).toMatchObject({
      status: 'paused',
      error: expect.stringContaining('could not be loaded') as string,
    })
    SOUNDS['/gone'] = { durationS: 1 }
    await made.play()
    delete SOUNDS['/gone']
    expect(made.getState()).toMatchObject({ status: 'playing', error: null })
  })
})

test('aligned with a position that moves on, it is there when the device begins', async () => {
  const made = await playing(A)
  Object.assign(context, { baseLatency: 0.01, currentTime: 0.1 })
  made.align(0.5)
  expect(last()?.atS).toBeCloseTo(0.12, 9)
  expect(last()?.fromS).toBeCloseTo(0.52, 9)
  made.pause()
  made.align(0.3)
  expect(made.positionS()).toBe(0.3)
})

describe('repeating', () => {
  test('a range repeats inside the sound itself, without a new start', async () => {
    const made = await playing()
    context.currentTime = 0.3
    made.setRange({ startS: 0.2, endS: 0.6 })
    made.setLooping(true)
    expect(context.started).toHaveLength(1)
    expect(last()).toMatchObject({ loop: true, loopStart: 0.2, loopEnd: 0.6 })
    context.currentTime = 0.3 + 0.3 + 0.1
    // 0.3 s reach its end; 0.1 s later it stands at 0.2 + 0.1.
    expect(made.positionS()).toBeCloseTo(0.3, 9)
    context.currentTime += 4
    expect(made.positionS()).toBeCloseTo(0.3, 9)
  })

  test('progress outside the range, it goes to the range', async () => {
    const made = await playing()
    context.currentTime = 0.8
    made.setLooping(true)
    made.setRange({ startS: 0.2, endS: 0.6 })
    expect(last()?.fromS).toBe(0.2)
  })

  test('without a range the whole sound repeats, and switched off it plays on to its end', async () => {
    const made = hand.player()
    made.setLooping(true)
    await made.select(A)
    await made.play()
    expect(last()).toMatchObject({ loop: true, loopStart: 0, loopEnd: 1 })
    context.currentTime = 2.5
    made.setLooping(false)
    expect(last()?.loop).toBe(false)
    context.currentTime = 2.75
    expect(made.positionS()).toBeCloseTo(0.75, 9)
  })
})

describe('switching', () => {
  test('a copy whose start was cut takes over at the same moment of the sound', async () => {
    const made = await playing()
    context.currentTime = 0.8
    await made.select(B, -0.6)
    expect(last()).toMatchObject({ fromS: expect.closeTo(0.2, 9) as number, buffer: { duration: 0.5 } })
    await made.select(A, 0.6)
    expect(last()?.fromS, 'after the fade of the one before it').toBeCloseTo(0.805, 9)
    made.seek(0.1)
    await made.select(B, -0.6)
    expect(last()?.fromS).toBe(0)
  })

  test('the other one takes over at the same position, with a fade of 5 ms', async () => {
    const made = await playing(A)
    await made.previews.get('/b')
    context.currentTime = 0.2
    await made.select(B)
    const [first, second] = context.started
    expect(second?.fromS).toBeCloseTo(0.2, 9)
    expect(second?.atS).toBe(0.2)
    expect(first?.stoppedAtS).toBeCloseTo(0.205, 9)
    expect(made.getState()).toMatchObject({ status: 'playing', sourceId: 'b', durationS: 0.5 })
  })

  test('until the other one is decoded the first one goes on', async () => {
    const made = await playing(A)
    context.currentTime = 0.1
    const switching = made.select(C)
    expect(context.started).toHaveLength(1)
    expect(context.started[0]?.stoppedAtS).toBeNull()
    context.currentTime = 0.4
    await switching
    expect(last()?.fromS).toBeCloseTo(0.4, 9)
  })

  test('the last one asked for wins, in whatever order they arrive', async () => {
    const made = await playing(A)
    await Promise.all([made.select(B), made.select(C)])
    expect(last()?.buffer.duration).toBe(2)
    expect(context.started).toHaveLength(2)
  })

  test('a shorter one that is already over stands at its end', async () => {
    const made = await playing(A)
    context.currentTime = 0.7
    await made.select(B)
    expect(made.getState().status).toBe('paused')
    expect(made.positionS()).toBe(0.5)
  })

  test('levels are matched by gain, and heard as sent on demand', async () => {
    const made = await playing(B)
    expect(last()?.gain.value).toBeCloseTo(0.5, 5)
    made.setMatched(false)
    expect(last()?.gain.value).toBe(1)
    expect(context.started).toHaveLength(1)
  })
})

test('a mix that comes down is faded as a whole, and the sound keeps its own gain', async () => {
  const made = hand.player()
  const gains: ReturnType<HandContext['createGain']>[] = []
  const createGain = context.createGain.bind(context)
  context.createGain = () => {
    const gain = createGain()
    gains.push(gain)
    return gain
  }
  await made.select(A)
  await made.play()
  made.setMixGain(-20)
  expect(gains.map(({ gain }) => gain.calls.at(-1))).toContainEqual(['ramp', 0.1, 0.005])
  expect(last()?.gain.value).toBe(1)
})

test('a sound that is selected again at another gain goes on at that gain', async () => {
  const made = await playing(B)
  context.currentTime = 0.1
  await made.select({ ...B, matchGainDb: -20 })
  expect(last()?.gain.value).toBeCloseTo(0.1, 9)
  expect(last()?.stoppedAtS).toBeNull()
  expect(context.started).toHaveLength(1)
})

describe('backwards', () => {
  test('it plays the samples in reverse from where it stands, and its place runs back', async () => {
    const made = await playing(A)
    context.currentTime = 0.75
    made.setReversed(true)
    expect([...(last()?.buffer.getChannelData(0) ?? [])]).toEqual([4, 3, 2, 1])
    expect(last()?.fromS).toBeCloseTo(0.25, 9)
    context.currentTime = 1
    expect(made.positionS()).toBeCloseTo(0.5, 9)
    made.seek(0.9)
    expect([...(last()?.buffer.getChannelData(0) ?? [])]).toEqual([4, 3, 2, 1])
    expect(last()?.fromS).toBeCloseTo(0.1, 9)
    made.setReversed(false)
    expect([...(last()?.buffer.getChannelData(0) ?? [])]).toEqual([1, 2, 3, 4])
    expect(last()?.fromS).toBeCloseTo(0.9, 9)
  })

  test('from the beginning it starts at the end, and ends at the beginning', async () => {
    const made = hand.player()
    made.setReversed(true)
    await made.select(A)
    await made.play()
    expect(last()?.fromS).toBe(0)
    expect(made.positionS()).toBe(1)
    last()?.end()
    expect(made.positionS()).toBe(0)
  })

  test('a range repeats where it lies in the turned sound', async () => {
    const made = hand.player()
    made.setReversed(true)
    made.setLooping(true)
    made.setRange({ startS: 0.1, endS: 0.3 })
    await made.select(A)
    await made.play()
    expect(last()?.loopStart).toBeCloseTo(0.7, 9)
    expect(last()?.loopEnd).toBeCloseTo(0.9, 9)
  })
})

describe('as the game does', () => {
  const nextFrame = () => {
    const [next] = hand.frames
    next?.()
  }

  test('variations follow one another until let go, each from its start when the one before is over', async () => {
    const made = hand.player()
    await made.playRandomized([A, B, C])
    expect(made.getState()).toMatchObject({ status: 'playing', isRandomized: true, sourceId: 'a' })
    // 1 s of the first, then 0.5 s of the second: what begins within 1.5 s is handed to the context at once.
    expect(context.started.map(({ atS, fromS }) => [atS, fromS])).toEqual([
      [0, 0],
      [1, 0],
    ])
    context.currentTime = 1.2
    nextFrame()
    expect(made.getState()).toMatchObject({ sourceId: 'b', durationS: 0.5 })
    expect(made.positionS()).toBeCloseTo(0.2, 9)
    made.pause()
    expect(made.getState()).toMatchObject({ status: 'paused', isRandomized: false })
    expect(context.started.every(({ stoppedAtS }) => stoppedAtS !== null)).toBe(true)
  })

  test('at 600 a minute one starts every 0.1 s by the context, at its own pitch and level', async () => {
    const made = hand.player({ random: () => 0.999999999 })
    await made.playRandomized([A, { ...B, matchGainDb: 0 }], { intervalS: 0.1, pitchSemitones: 12, levelDb: 3 })
    expect(context.started).toHaveLength(15)
    context.started.forEach(({ atS, speed, gain }, index) => {
      expect(atS).toBeCloseTo(0.1 * index, 9)
      expect(speed).toBeCloseTo(2, 6)
      expect(gain.value).toBeCloseTo(10 ** (-6 / 20), 6)
    })
    context.currentTime = 0.05
    expect(made.positionS()).toBeCloseTo(0.1, 6)
    made.dispose()
  })

  test('let go before they are decoded, none sounds', async () => {
    const made = hand.player()
    const starting = made.playRandomized([A, B])
    made.pause()
    await starting
    expect(context.started).toEqual([])
    expect(made.getState().isRandomized).toBe(false)
  })
})

describe('the playhead', () => {
  const step = (ms: number) => {
    hand.clockMs += ms
    const [next] = hand.frames
    next?.()
  }

  test('moves at every frame', async () => {
    const made = await playing()
    const moved = vi.fn()
    made.subscribe(moved)
    for (let frame = 0; frame < 6; frame += 1) step(16)
    expect(moved).toHaveBeenCalledTimes(6)
  })

  test('steps ten times a second under reduced motion', async () => {
    const made = await playing(A, { reducedMotion: true })
    const moved = vi.fn()
    made.subscribe(moved)
    // 63 frames of 16 ms are 1.008 s.
    for (let frame = 0; frame < 63; frame += 1) step(16)
    expect(moved.mock.calls.length).toBeGreaterThanOrEqual(9)
    expect(moved.mock.calls.length).toBeLessThanOrEqual(10)
  })

  test('stands still when it is paused', async () => {
    const made = await playing()
    made.pause()
    expect(hand.frames).toEqual([])
  })
})

test('left, it is silent and lets go of everything', async () => {
  const made = await playing()
  made.dispose()
  expect(last()?.stoppedAtS).not.toBeNull()
  expect(context.closed).toBe(true)
  expect(made.previews.has('/a')).toBe(false)
})
