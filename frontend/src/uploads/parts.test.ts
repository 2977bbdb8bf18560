import { waitFor } from '@testing-library/react'
import { File as NodeFile } from 'node:buffer'
import { createHash } from 'node:crypto'

import { afterEach, beforeEach, expect, test, vi } from 'vitest'

import { partsTransport, PARTS_FROM_BYTES, type Put } from './parts'
import type { Transport, TransportEvents, Upload } from './queue'

// jsdom's files cannot be read; Node's can.
const File = NodeFile as unknown as typeof globalThis.File
const MIB = 2 ** 20
const PART = 8 * MIB

/** A server whose store takes parts, as far as a sender sees it. */
class Store {
  offers = true
  length = 0
  here = new Map<number, number>()
  asked: { method: string; path: string; headers: Headers; body: unknown }[] = []
  refuse: { path: RegExp; status: number; code: string; times: number } | null = null

  answer = async (input: Request | string, init?: RequestInit): Promise<Response> => {
    const request = new Request(new URL(typeof input === 'string' ? input : input.url, 'http://127.0.0.1'), {
      method: init?.method ?? (input as Request).method,
      headers: init?.headers ?? (input as Request).headers,
      body: typeof input === 'string' ? null : await input.text().then((text) => text || null),
    })
    const path = new URL(request.url).pathname
    const text = request.body === null ? '' : await request.text()
    const body = (text ? JSON.parse(text) : null) as { parts?: { number: number; sha256: string }[] } | null
    this.asked.push({ method: request.method, path, headers: request.headers, body })
    if (this.refuse !== null && this.refuse.times > 0 && this.refuse.path.test(`${request.method} ${path}`)) {
      this.refuse.times -= 1
      return Response.json({ code: this.refuse.code, detail: 'refused' }, { status: this.refuse.status })
    }
    if (request.method === 'OPTIONS') {
      return new Response(null, { headers: { 'Tus-Extension': this.offers ? 'creation,soundlist-parts' : 'creation' } })
    }
    if (request.method === 'DELETE') return new Response(null, { status: 204 })
    if (path === '/v1/uploads') {
      this.length = Number(request.headers.get('Upload-Length'))
      return new Response(null, { status: 201, headers: { Location: '/v1/uploads/u-1' } })
    }
    if (path.endsWith('/finish')) return Response.json({ upload_id: 'u-1' })
    return Response.json({
      part_bytes: PART,
      parts: Math.ceil(this.length / PART),
      here: [...this.here.keys()],
      links: (body?.parts ?? []).map(({ number, sha256 }) => ({
        number,
        start: (number - 1) * PART,
        length: Math.min(PART, this.length - (number - 1) * PART),
        url: `https://store.example/${number}`,
        headers: { 'x-amz-checksum-sha256': sha256 },
      })),
    })
  }

  put: Put = ({ url, headers }, bytes, onProgress) => {
    onProgress(bytes.byteLength / 2)
    const right = createHash('sha256').update(new Uint8Array(bytes)).digest('hex')
    if (headers['x-amz-checksum-sha256'] !== right) return Promise.resolve(400)
    this.here.set(Number(url.split('/').at(-1)), bytes.byteLength)
    return Promise.resolve(200)
  }

  paths = () => this.asked.map(({ method, path }) => `${method} ${path}`)
}

const fileOf = (size: number) => new File([new Uint8Array(size)], 'Bö ambience.wav', { lastModified: 7 })
const uploadOf = (file: globalThis.File) => ({ file, path: file.name }) as Upload

let store: Store
let otherwise: Transport & { start: ReturnType<typeof vi.fn<Transport['start']>> }
const stopOther = vi.fn()

const transportOf = (put: Put = store.put) =>
  partsTransport({ endpoint: '/v1/uploads', metadata: () => ({ file_name: 'Bö ambience.wav' }), otherwise, put })

function sent(transport: Transport, file: globalThis.File) {
  const reported: (string | number)[] = []
  let stop: (forget: boolean) => void = () => undefined
  const end = new Promise<string>((resolve) => {
    const events: TransportEvents = {
      onProgress: (bytes) => reported.push(bytes),
      onResumed: (bytes) => reported.push(`from ${bytes}`),
      onFinished: (id) => resolve(`finished ${id}`),
      onLost: () => resolve('lost'),
      onRefused: (detail) => resolve(`refused: ${detail}`),
    }
    stop = transport.start(uploadOf(file), events)
  })
  return { reported, end, stop: (forget: boolean) => stop(forget) }
}

beforeEach(() => {
  store = new Store()
  otherwise = { start: vi.fn(() => stopOther) }
  stopOther.mockClear()
  localStorage.clear()
  document.cookie = 'soundlist_csrf=token; path=/'
  vi.stubGlobal('fetch', store.answer)
})
afterEach(() => vi.unstubAllGlobals())

test('a large file goes to the store part by part, and is finished by the server', async () => {
  const { end, reported } = sent(transportOf(), fileOf(2 * PART + 100))
  await expect(end).resolves.toBe('finished u-1')
  expect([...store.here]).toEqual([
    [1, PART],
    [2, PART],
    [3, 100],
  ])
  expect(reported).toEqual([PART / 2, PART, 1.5 * PART, 2 * PART, 2 * PART + 50, 2 * PART + 100])
  expect(store.paths()).toEqual([
    'OPTIONS /v1/uploads',
    'POST /v1/uploads',
    ...Array.from({ length: 4 }, () => 'POST /v1/uploads/u-1/parts'),
    'POST /v1/uploads/u-1/finish',
  ])
  const created = store.asked[1]?.headers
  expect(created?.get('Upload-Length')).toBe(String(2 * PART + 100))
  expect(created?.get('X-CSRF-Token')).toBe('token')
  const [name, value] = (created?.get('Upload-Metadata') ?? '').split(' ')
  const text = new TextDecoder().decode(Uint8Array.from(atob(value ?? ''), (letter) => letter.charCodeAt(0)))
  expect([name, text]).toEqual(['file_name', 'Bö ambience.wav'])
  expect(localStorage).toHaveLength(0)
})

test('small files, and all where the store takes no parts, go as they went', async () => {
  sent(transportOf(), fileOf(PARTS_FROM_BYTES - 1))
  await waitFor(() => expect(otherwise.start).toHaveBeenCalledTimes(1))
  expect(store.asked).toEqual([])
  store.offers = false
  const { stop } = sent(transportOf(), fileOf(PARTS_FROM_BYTES))
  await waitFor(() => expect(otherwise.start).toHaveBeenCalledTimes(2))
  stop(true)
  expect(stopOther).toHaveBeenCalledWith(true)
})

test('a page that cannot hash sends as it did', async () => {
  vi.stubGlobal('crypto', {})
  sent(transportOf(), fileOf(2 * PART))
  await waitFor(() => expect(otherwise.start).toHaveBeenCalledTimes(1))
})

test('a file that was moved away is reported in words', async () => {
  const file = fileOf(2 * PART)
  vi.spyOn(file, 'slice').mockReturnValue({ arrayBuffer: () => Promise.reject(new Error('gone')) } as unknown as Blob)
  await expect(sent(transportOf(), file).end).resolves.toMatch(/^refused: The file can’t be read any more/)
})

test('whether parts are taken is asked once', async () => {
  const transport = transportOf()
  await sent(transport, fileOf(PARTS_FROM_BYTES)).end
  store.here.clear()
  await sent(transport, fileOf(PARTS_FROM_BYTES)).end
  expect(store.paths().filter((asked) => asked.startsWith('OPTIONS'))).toHaveLength(1)
})

test('a lost line goes on with the parts that are missing, also after the page was opened again', async () => {
  let failing = true
  const put: Put = (link, ...rest) =>
    failing && link.url.endsWith('/2') ? Promise.resolve(0) : store.put(link, ...rest)
  await expect(sent(transportOf(put), fileOf(3 * PART)).end).resolves.toBe('lost')
  failing = false
  const { end, reported } = sent(transportOf(put), fileOf(3 * PART))
  await expect(end).resolves.toBe('finished u-1')
  expect(reported[0]).toBe(`from ${PART}`)
  expect(store.paths().filter((asked) => asked === 'POST /v1/uploads')).toHaveLength(1)
})

test.each([403, 500, 503, 0])(
  'a part that the store answers with %s is tried again with a new link',
  async (status) => {
    const answers = [status, 200, 200]
    const put: Put = async (url, bytes, onProgress, stop) => {
      const answer = answers.shift() ?? 200
      return answer === 200 ? store.put(url, bytes, onProgress, stop) : answer
    }
    const transport = transportOf(put)
    await expect(sent(transport, fileOf(2 * PART)).end).resolves.toBe('lost')
    await expect(sent(transport, fileOf(2 * PART)).end).resolves.toBe('finished u-1')
  },
)

test('a store that is never reached is left alone: the bytes go through the server', async () => {
  const transport = transportOf(() => Promise.resolve(0))
  for (let time = 0; time < 3; time += 1) await expect(sent(transport, fileOf(2 * PART)).end).resolves.toBe('lost')
  sent(transport, fileOf(2 * PART))
  await waitFor(() => expect(otherwise.start).toHaveBeenCalledTimes(1))
  await waitFor(() => expect(store.paths().at(-1)).toBe('DELETE /v1/uploads/u-1'))
  expect(localStorage).toHaveLength(0)
})

test('an upload that has expired begins again', async () => {
  const put: Put = () => Promise.resolve(0)
  await sent(transportOf(put), fileOf(2 * PART)).end
  store.refuse = { path: /parts$/, status: 404, code: 'upload-not-found', times: 1 }
  const transport = transportOf()
  await expect(sent(transport, fileOf(2 * PART)).end).resolves.toBe('lost')
  await expect(sent(transport, fileOf(2 * PART)).end).resolves.toBe('finished u-1')
  expect(store.paths().filter((asked) => asked === 'POST /v1/uploads')).toHaveLength(2)
})

test.each([
  ['POST /v1/uploads$', 409, 'delivery-closed', 'refused: refused'],
  ['POST /v1/uploads$', 404, 'delivery-not-found', 'refused: refused'],
  ['POST /v1/uploads$', 503, 'store-unavailable', 'lost'],
  ['OPTIONS', 502, 'http-502', 'lost'],
  ['finish', 423, 'upload-busy', 'lost'],
  ['finish', 409, 'upload-unfinished', 'lost'],
  ['parts', 409, 'parts-not-taken', 'lost'],
])('%s answered with %s %s is %s', async (path, status, code, outcome) => {
  store.refuse = { path: new RegExp(path), status, code, times: 1 }
  await expect(sent(transportOf(), fileOf(2 * PART)).end).resolves.toBe(outcome)
})

test('stopped for good, what was sent is taken away', async () => {
  let stopNow: () => void = () => undefined
  const put: Put = (link, ...rest) => {
    if (link.url.endsWith('/2')) stopNow()
    return store.put(link, ...rest)
  }
  const { stop, reported } = sent(transportOf(put), fileOf(3 * PART))
  stopNow = () => stop(true)
  await waitFor(() => expect(store.paths().at(-1)).toBe('DELETE /v1/uploads/u-1'))
  expect(store.here.has(3)).toBe(false)
  expect(reported.at(-1)).toBe(1.5 * PART)
  expect(localStorage).toHaveLength(0)
})

test('paused, it keeps what is there', async () => {
  let pause: () => void = () => undefined
  const put: Put = (link, ...rest) => {
    if (link.url.endsWith('/2')) pause()
    return store.put(link, ...rest)
  }
  const transport = transportOf(put)
  const { stop } = sent(transport, fileOf(3 * PART))
  await new Promise<void>((resolve) => {
    pause = () => {
      stop(false)
      resolve()
    }
  })
  pause = () => undefined
  const { end } = sent(transport, fileOf(3 * PART))
  await expect(end).resolves.toBe('finished u-1')
  expect(store.paths().some((asked) => asked.startsWith('DELETE'))).toBe(false)
})
