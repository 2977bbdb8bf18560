import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'

import { wholePagesBytes } from './oggPages'
import { Player } from './player'
import type { Source } from './playerState'

const DURATION_S = 60
const SOURCE: Source = { id: 'a', url: '/a', durationS: DURATION_S }
const PAGE_BYTES = 30 + 3 * 255
/** What the decoder of these tests makes of so many bytes. */
const BYTES_PER_S = 8_000
const RATE_HZ = 1_000

const page = (): Uint8Array<ArrayBuffer> => {
  const bytes = new Uint8Array(PAGE_BYTES)
  bytes.set(new TextEncoder().encode('OggS'))
  bytes.set([3, 255, 255, 255], 26)
  return bytes
}
const pages = (count: number) => new Uint8Array(Array.from({ length: count }, () => [...page()]).flat())

let context: HandContext
let arrives: (bytes: Uint8Array) => void
let ends: () => void
let breaks: () => void
let asked: { url: string; range: string | null }[]

beforeEach(() => {
  asked = []
  context = Object.assign(new HandContext(), {
    baseLatency: 0.01,
    decodeAudioData: (data: ArrayBuffer) => {
      if (data.byteLength % PAGE_BYTES !== 0) return Promise.reject(new Error('a page is cut'))
      const durationS = data.byteLength / BYTES_PER_S
      return Promise.resolve({
        ...context.createBuffer(1, Math.floor(durationS * RATE_HZ), RATE_HZ),
        duration: durationS,
      })
    },
  })
  vi.stubGlobal('fetch', (url: string, { headers = {} }: { headers?: Record<string, string> }) => {
    const range = headers.Range ?? null
    asked.push({ url, range })
    const type = { headers: { 'content-type': 'audio/ogg' } }
    if (range) return Promise.resolve(new Response(pages(16), { ...type, status: 206 }))
    if (!url.endsWith('?light=true')) return new Promise(() => undefined) // the exact one is on its way
    const body = new ReadableStream<Uint8Array>({
      start: (controller) => {
        arrives = (bytes) => controller.enqueue(bytes)
        ends = () => controller.close()
        breaks = () => controller.error(new Error('the line is cut'))
      },
    })
    return Promise.resolve(new Response(body, type))
  })
})

const settle = () => new Promise((resolve) => setTimeout(resolve))
const light = () =>
  new Player({ createContext: () => context as unknown as AudioContext, onFrame: () => () => undefined, light: true, held: true }) // prettier-ignore

async function pressed(fromS?: number): Promise<Player> {
  const player = light()
  void player.select(SOURCE)
  void player.play(fromS)
  await settle()
  return player
}
const comes = async (bytes: Uint8Array) => {
  arrives(bytes)
  await settle()
}
const last = () => context.started.at(-1)

test('a stream is cut after its last whole page', () => {
  expect(wholePagesBytes(pages(3))).toBe(3 * PAGE_BYTES)
  expect(wholePagesBytes(pages(3).subarray(0, 3 * PAGE_BYTES - 1))).toBe(2 * PAGE_BYTES)
  expect(wholePagesBytes(pages(1).subarray(0, 28))).toBe(0)
  expect(wholePagesBytes(new Uint8Array([82, 73, 70, 70]))).toBe(0)
})

test('the first bytes play, and a piece twice as long goes on at the same sample', async () => {
  const player = await pressed()
  await comes(pages(10))
  expect(context.started).toEqual([])
  await comes(pages(10).subarray(0, 7_000))
  expect(player.getState()).toMatchObject({ status: 'playing', isLight: true, durationS: DURATION_S })
  expect(last()).toMatchObject({ atS: 0.02, fromS: 0 })
  // 18 whole pages are 1.789 s; of the last tenth nothing is played.
  expect(last()?.stoppedAtS).toBeCloseTo(0.02 + (18 * PAGE_BYTES) / BYTES_PER_S - 0.1, 6)
  context.currentTime = 1
  await comes(pages(10).subarray(7_000))
  expect(context.started).toHaveLength(1)
  await comes(pages(18))
  expect(last()).toMatchObject({ atS: 1.02, fromS: 1 })
  expect(asked.map(({ url }) => url)).toEqual(['/a?light=true'])
  ends()
  await settle()
  expect(context.started).toHaveLength(3)
  expect(asked.at(-1)?.url).toBe('/a')
})

test('what is played before more of it comes waits there, and goes on by itself', async () => {
  const player = await pressed()
  await comes(pages(18))
  context.currentTime = 2
  last()?.end()
  const untilS = (18 * PAGE_BYTES) / BYTES_PER_S - 0.1
  expect(player.getState().status).toBe('loading')
  expect(player.positionS()).toBeCloseTo(untilS, 9)
  context.currentTime = 5
  await comes(pages(18))
  expect(player.getState().status).toBe('playing')
  expect(last()?.fromS).toBeCloseTo(untilS, 9)
})

test('a place beyond what is here waits until it is', async () => {
  const player = await pressed()
  await comes(pages(18))
  player.seek(2.5)
  expect(player.getState().status).toBe('loading')
  await comes(pages(18))
  expect(last()?.fromS).toBe(2.5)
  player.pause()
  player.seek(50)
  void player.play()
  await comes(pages(40))
  expect(player.getState().status).toBe('loading')
  player.pause()
  ends()
  await settle()
  expect(player.getState().status).toBe('paused')
  expect(context.started).toHaveLength(2)
})

test('turned backwards it waits for the whole', async () => {
  const player = await pressed()
  await comes(pages(18))
  context.currentTime = 1
  player.setReversed(true)
  await comes(pages(18))
  expect(context.started).toHaveLength(1)
  ends()
  await settle()
  expect(context.started).toHaveLength(2)
  expect(player.getState().status).toBe('playing')
})

test('a sound farther down the queue plays from bytes that were fetched before', async () => {
  const player = light()
  player.previews.keepReady([], [], ['/a'])
  player.previews.release()
  await settle()
  expect(asked).toEqual([{ url: '/a?light=true', range: 'bytes=0-11999' }])
  void player.select(SOURCE)
  void player.play()
  await settle()
  expect(last()?.fromS).toBe(0)
  context.currentTime = 0.5
  await comes(pages(40))
  expect(last()?.fromS).toBeCloseTo(0.5, 9)
  expect(context.started).toHaveLength(2)
})

test('a line that is cut is said once nothing else can be loaded', async () => {
  const player = await pressed()
  await comes(pages(18))
  vi.stubGlobal('fetch', () => Promise.resolve(new Response(null, { status: 503 })))
  breaks()
  await settle()
  last()?.end()
  await settle()
  expect(player.getState()).toMatchObject({ status: 'paused', error: expect.stringContaining('could not') as string })
})
