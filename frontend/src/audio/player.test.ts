import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'

import { Player } from './player'
import type { Source } from './playerState'

const SOUNDS: Record<string, { durationS: number; samples?: number[] }> = {
  '/a': { durationS: 1, samples: [1, 2, 3, 4] },
  '/b': { durationS: 0.5 },
  '/c': { durationS: 2 },
}
const A: Source = { id: 'a', url: '/a' }
const B: Source = { id: 'b', url: '/b', matchGainDb: -6.0206 }
const C: Source = { id: 'c', url: '/c' }

let context: HandContext
let fetched: string[]
let frames: (() => void)[]
let clockMs: number

beforeEach(() => {
  context = new HandContext()
  fetched = []
  frames = []
  clockMs = 0
  vi.stubGlobal('fetch', (url: string) => {
    fetched.push(url)
    const sound = SOUNDS[url]
    return Promise.resolve(new Response(sound ? JSON.stringify(sound) : null, { status: sound ? 200 : 404 }))
  })
})

function player(parts: { random?: () => number; reducedMotion?: boolean; held?: boolean } = {}): Player {
  return new Player({
    createContext: () => context as unknown as AudioContext,
    random: parts.random ?? (() => 0),
    reducedMotion: () => parts.reducedMotion ?? false,
    now: () => clockMs,
    held: parts.held,
    onFrame: (callback) => {
      frames.push(callback)
      return () => {
        frames = frames.filter((other) => other !== callback)
      }
    },
  })
}

async function playing(source: Source = A, parts: Parameters<typeof player>[0] = {}): Promise<Player> {
  const made = player(parts)
  await made.select(source)
  await made.play()
  return made
}

const last = () => context.started.at(-1)

describe('playing', () => {
  test('nothing sounds until asked, and taking a sound in the hand is no asking', async () => {
    const made = player()
    await made.select(A)
    made.seek(0.4)
    expect(context.started).toEqual([])
    expect(made.getState()).toMatchObject({ status: 'silent', sourceId: 'a', durationS: 1 })
    expect(made.positionS()).toBe(0.4)
  })

  test('it starts where it stands, and stands where it was paused', async () => {
    const made = player()
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
    const made = player()
    void made.select(A)
    const starting = made.play()
    made.pause()
    await starting
    expect(context.started).toEqual([])
  })

  test('what cannot be read is said, and asked for again at the next press', async () => {
    const made = player()
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
    const made = player()
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
    expect(last()?.fromS).toBeCloseTo(0.8, 9)
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
  const made = player()
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
    const made = player()
    made.setReversed(true)
    await made.select(A)
    await made.play()
    expect(last()?.fromS).toBe(0)
    expect(made.positionS()).toBe(1)
    last()?.end()
    expect(made.positionS()).toBe(0)
  })

  test('a range repeats where it lies in the turned sound', async () => {
    const made = player()
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
    const [next] = frames
    next?.()
  }

  test('variations follow one another until let go, each from its start when the one before is over', async () => {
    const made = player()
    await made.playAsGame([A, B, C])
    expect(made.getState()).toMatchObject({ status: 'playing', asGame: true, sourceId: 'a' })
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
    expect(made.getState()).toMatchObject({ status: 'paused', asGame: false })
    expect(context.started.every(({ stoppedAtS }) => stoppedAtS !== null)).toBe(true)
  })

  test('at 600 a minute one starts every 0.1 s by the context, at its own pitch and level', async () => {
    const made = player({ random: () => 0.999999999 })
    await made.playAsGame([A, { ...B, matchGainDb: 0 }], { intervalS: 0.1, pitchSemitones: 12, levelDb: 3 })
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
    const made = player()
    const starting = made.playAsGame([A, B])
    made.pause()
    await starting
    expect(context.started).toEqual([])
    expect(made.getState().asGame).toBe(false)
  })
})

describe('previews', () => {
  test('each is fetched once, however often it is asked for', async () => {
    const made = player()
    made.previews.keepReady(['/a', '/b'])
    await Promise.all([made.previews.get('/a'), made.previews.get('/a')])
    await made.select(A)
    await made.play()
    expect(fetched.filter((url) => url === '/a')).toHaveLength(1)
  })

  test('are fetched one after another, those in the hand first', async () => {
    const made = player()
    made.previews.keepReady(['/b', '/a', '/c'])
    await made.previews.released
    expect(fetched).toEqual(['/b'])
    await vi.waitFor(() => expect(fetched).toEqual(['/b', '/a', '/c']))
  })

  test('held, they wait until one is played', async () => {
    const made = player({ held: true })
    made.previews.keepReady(['/a', '/b'])
    void made.select(A)
    await new Promise((resolve) => setTimeout(resolve))
    expect(fetched).toEqual([])
    await made.play()
    expect(last()?.buffer.duration).toBe(1)
    await vi.waitFor(() => expect(fetched).toEqual(['/a', '/b']))
  })

  test('held until the page is shown, the selected one is fetched first and alone', async () => {
    const made = player({ held: true })
    made.previews.keepReady(['/b', '/c'])
    void made.select(A)
    await new Promise((resolve) => setTimeout(resolve))
    expect(fetched).toEqual([])
    made.previews.release()
    await made.previews.released
    expect(fetched).toEqual(['/a'])
    await vi.waitFor(() => expect(fetched).toEqual(['/a', '/b', '/c']))
  })

  test('of a newer list are fetched in place of what was left of the older one', async () => {
    const made = player()
    made.previews.keepReady(['/a', '/b'])
    await made.previews.released
    made.previews.keepReady(['/a', '/c'])
    await vi.waitFor(() => expect(fetched).toEqual(['/a', '/c']))
  })

  test('those kept ready stay while others are forgotten', async () => {
    const made = player()
    made.previews.keepReady(['/a'])
    await made.previews.get('/a')
    for (let index = 0; index < 12; index += 1) {
      SOUNDS[`/more${index}`] = { durationS: 1 }
      await made.previews.get(`/more${index}`)
      delete SOUNDS[`/more${index}`]
    }
    expect(made.previews.has('/a')).toBe(true)
    expect(made.previews.has('/more0')).toBe(false)
    expect(made.previews.has('/more11')).toBe(true)
  })
})

describe('the playhead', () => {
  const step = (ms: number) => {
    clockMs += ms
    const [next] = frames
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
    expect(frames).toEqual([])
  })
})

test('left, it is silent and lets go of everything', async () => {
  const made = await playing()
  made.dispose()
  expect(last()?.stoppedAtS).not.toBeNull()
  expect(context.closed).toBe(true)
  expect(made.previews.has('/a')).toBe(false)
})

describe('a light preview', () => {
  const LIGHT = 'audio/ogg'
  let arrivals: Map<string, () => void>
  const serve = (lightType = LIGHT) => {
    arrivals = new Map()
    vi.stubGlobal('fetch', (url: string) => {
      fetched.push(url)
      const [path = ''] = url.split('?')
      const type = url.endsWith('?light=true') ? lightType : 'audio/wav'
      const answer = () => new Response(JSON.stringify(SOUNDS[path]), { headers: { 'content-type': type } })
      return new Promise((resolve) => arrivals.set(url, () => resolve(answer())))
    })
  }
  const light = () =>
    new Player({
      createContext: () => Object.assign(context, { baseLatency: 0.01 }) as unknown as AudioContext,
      onFrame: () => () => undefined,
      light: true,
    })
  const arrive = async (url: string) => {
    await vi.waitFor(() => expect(arrivals.has(url)).toBe(true))
    arrivals.get(url)?.()
    await new Promise((resolve) => setTimeout(resolve))
  }

  test('plays at once, and the exact sound takes its place at the same sample, with a fade of 5 ms', async () => {
    serve()
    const made = light()
    const selected = made.select(A)
    await arrive('/a?light=true')
    await selected
    await made.play()
    expect(made.getState()).toMatchObject({ status: 'playing', isLight: true })
    expect(context.started).toHaveLength(1)
    expect(last()).toMatchObject({ atS: 0.02, fromS: 0 })
    context.currentTime = 0.42
    await arrive('/a')
    expect(made.getState()).toMatchObject({ status: 'playing', isLight: false })
    // 0.42 − 0.02 s are over; the device begins 0.02 s from now, and both are at 0.42 s of the sound then.
    expect(context.started.map(({ atS, fromS }) => [atS, fromS])).toEqual([
      [0.02, 0],
      [expect.closeTo(0.44, 9), expect.closeTo(0.42, 9)],
    ])
    expect(context.started[0]?.stoppedAtS).toBeCloseTo(0.445, 9)
    expect(last()?.gain.calls).toEqual([
      ['set', 0, expect.closeTo(0.44, 9)],
      ['ramp', 1, expect.closeTo(0.445, 9)],
    ])
  })

  test('goes round the loop to the same place where the exact one takes over near its end', async () => {
    serve()
    const made = light()
    const selected = made.select(A)
    await arrive('/a?light=true')
    await selected
    made.setLooping(true)
    await made.play()
    context.currentTime = 1.01
    await arrive('/a')
    expect(last()?.fromS).toBeCloseTo(0.01, 9)
  })

  test('that an older sound does not have is the exact one, and is not fetched again', async () => {
    serve('audio/wav')
    const made = light()
    const selected = made.select(A)
    await arrive('/a?light=true')
    await selected
    await made.play()
    expect(made.getState()).toMatchObject({ status: 'playing', isLight: false })
    expect(fetched).toEqual(['/a?light=true'])
  })

  test('of all that is next is fetched before the exact sounds, and of later ones alone', async () => {
    serve()
    const made = light()
    made.previews.keepReady(['/a', '/b'], ['/c'])
    for (const url of ['/a?light=true', '/b?light=true', '/c?light=true', '/a', '/b']) await arrive(url)
    expect(fetched).toEqual(['/a?light=true', '/b?light=true', '/c?light=true', '/a', '/b'])
  })
})
