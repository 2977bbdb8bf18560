import { waitFor } from '@testing-library/react'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import type { HandContext } from '@/test/audioContext'
import { Hand } from '@/test/handPlayer'

import { Player } from './player'
import type { Source } from './playerState'

const SOUNDS: Record<string, { durationS: number; samples?: number[] }> = {
  '/a': { durationS: 1, samples: [1, 2, 3, 4] },
  '/b': { durationS: 0.5 },
  '/c': { durationS: 2 },
}
const A: Source = { id: 'a', url: '/a' }

let hand: Hand
let context: HandContext

beforeEach(() => {
  hand = new Hand(SOUNDS)
  context = hand.context
})

const last = () => context.started.at(-1)

describe('previews', () => {
  test('each is fetched once, however often it is asked for', async () => {
    const made = hand.player()
    made.previews.keepReady(['/a', '/b'])
    await Promise.all([made.previews.get('/a'), made.previews.get('/a')])
    await made.select(A)
    await made.play()
    expect(hand.fetched.filter((url) => url === '/a')).toHaveLength(1)
  })

  test('are fetched one after another, those in the hand first', async () => {
    const made = hand.player()
    made.previews.keepReady(['/b', '/a', '/c'])
    await made.previews.released
    expect(hand.fetched).toEqual(['/b'])
    await waitFor(() => expect(hand.fetched).toEqual(['/b', '/a', '/c']))
  })

  test('held, they wait until one is played', async () => {
    const made = hand.player({ held: true })
    made.previews.keepReady(['/a', '/b'])
    void made.select(A)
    await new Promise((resolve) => setTimeout(resolve))
    expect(hand.fetched).toEqual([])
    await made.play()
    expect(last()?.buffer.duration).toBe(1)
    await waitFor(() => expect(hand.fetched).toEqual(['/a', '/b']))
  })

  test('held until the page is shown, the selected one is fetched first and alone', async () => {
    const made = hand.player({ held: true })
    made.previews.keepReady(['/b', '/c'])
    void made.select(A)
    await new Promise((resolve) => setTimeout(resolve))
    expect(hand.fetched).toEqual([])
    made.previews.release()
    await made.previews.released
    expect(hand.fetched).toEqual(['/a'])
    await waitFor(() => expect(hand.fetched).toEqual(['/a', '/b', '/c']))
  })

  test('of a newer list are fetched in place of what was left of the older one', async () => {
    const made = hand.player()
    made.previews.keepReady(['/a', '/b'])
    await made.previews.released
    made.previews.keepReady(['/a', '/c'])
    await waitFor(() => expect(hand.fetched).toEqual(['/a', '/c']))
  })

  test('those kept ready stay while others are forgotten', async () => {
    const made = hand.player()
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

describe('a light preview', () => {
  const LIGHT = 'audio/ogg'
  let arrivals: Map<string, () => void>
  const serve = (lightType = LIGHT) => {
    arrivals = new Map()
    vi.stubGlobal('fetch', (url: string) => {
      hand.fetched.push(url)
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
    await waitFor(() => expect(arrivals.has(url)).toBe(true))
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
    expect(hand.fetched).toEqual(['/a?light=true'])
  })

  test('of all that is next is fetched before the exact sounds, and of later ones alone', async () => {
    serve()
    const made = light()
    made.previews.keepReady(['/a', '/b'], ['/c'])
    for (const url of ['/a?light=true', '/b?light=true', '/c?light=true', '/a', '/b']) await arrive(url)
    expect(hand.fetched).toEqual(['/a?light=true', '/b?light=true', '/c?light=true', '/a', '/b'])
  })
})
