import { ApiProblem, csrfToken, networkError, post, problemOf } from '@/api'

import type { Transport, TransportEvents, Upload } from './queue'
import { bodyOf, type TusOptions, uploadIdOf } from './tus'

/** Below this a file is one request anyway, and the server takes it as it comes. */
export const PARTS_FROM_BYTES = 16 * 2 ** 20
const EXTENSION = 'soundlist-parts'
/** So often a store that was never reached is tried before bytes go through the server instead. */
const STRIKES = 3

export interface PartLink {
  url: string
  headers: Record<string, string>
}

/** Puts bytes at an address of the store; resolves with the status, 0 where the line dropped. */
export type Put = (
  link: PartLink,
  bytes: ArrayBuffer,
  onProgress: (sentBytes: number) => void,
  stop: AbortSignal,
) => Promise<number>

interface PartsOptions extends TusOptions {
  /** What carries a file where the store takes no parts. */
  otherwise: Transport
  put?: Put
}

/** Sends large files to the store itself, in parts, where the server says that it takes them. */
export function partsTransport({ endpoint, metadata, otherwise, put = putByXhr }: PartsOptions): Transport {
  let offered: Promise<boolean> | null = null
  let strikes = 0

  const isOffered = (): Promise<boolean> => {
    offered ??= takesParts(endpoint).catch((error: unknown) => {
      offered = null
      throw error
    })
    return offered
  }

  const send = async (upload: Upload, events: TransportEvents, place: Place, stop: AbortSignal): Promise<void> => {
    const id = place.known() ?? place.keep(await create(endpoint, metadata(upload), upload.file, stop))
    const progress = await ask(id, [])
    const lengthOf = (number: number) =>
      Math.min(progress.part_bytes, upload.file.size - (number - 1) * progress.part_bytes)
    const here = new Set(progress.here)
    let sent = [...here].reduce((sum, number) => sum + lengthOf(number), 0)
    if (sent > 0) events.onResumed(sent)
    for (let number = 1; number <= progress.parts; number += 1) {
      if (here.has(number)) continue
      stop.throwIfAborted()
      const start = (number - 1) * progress.part_bytes
      const bytes = await read(upload.file.slice(start, start + lengthOf(number)))
      const { links } = await ask(id, [{ number, sha256: await sha256Of(bytes) }])
      const before = sent
      const report = (some: number) => events.onProgress(before + some)
      const status = links[0] === undefined ? 0 : await put(links[0], bytes, report, stop)
      stop.throwIfAborted()
      if (status < 200 || status >= 300) {
        strikes += 1
        throw networkError() // also a link that expired: the next try asks for new ones
      }
      strikes = Number.NEGATIVE_INFINITY
      sent += bytes.byteLength
      events.onProgress(sent)
    }
    const finished = await post('/v1/uploads/{upload_id}/finish', { upload_id: id })
    place.forget()
    events.onFinished(finished.upload_id)
  }

  return {
    start(upload, events) {
      const stopping = new AbortController()
      const place = placeOf(endpoint, metadata(upload), upload)
      let halt = (forget: boolean) => {
        const id = place.known()
        if (!forget || id === null) return
        place.forget()
        giveUp(id)
      }
      const run = async () => {
        if (upload.file.size < PARTS_FROM_BYTES || !canHash() || !(await isOffered()) || strikes >= STRIKES) {
          if (stopping.signal.aborted) return
          halt(true)
          halt = otherwise.start(upload, events)
          return
        }
        await send(upload, events, place, stopping.signal)
      }
      run().catch((error: unknown) => {
        if (stopping.signal.aborted) return
        const problem = error instanceof ApiProblem ? error : networkError()
        if (problem.code === 'parts-not-taken') offered = null
        fail(problem, place, events)
      })
      return (forget) => {
        stopping.abort()
        halt(forget)
      }
    },
  }
}

/** Errors that the next try fixes: it requests new links, starts over, or finds that the server takes the bytes itself. */
const PASSING = ['upload-not-found', 'upload-unfinished', 'upload-busy', 'parts-not-taken', 'checksum-mismatch']

function fail(problem: ApiProblem, place: Place, events: TransportEvents): void {
  if (['upload-not-found', 'parts-not-taken'].includes(problem.code)) place.forget()
  const passes = problem.status === 0 || problem.status >= 500 || [408, 429].includes(problem.status)
  if (passes || PASSING.includes(problem.code)) events.onLost()
  else events.onRefused(problem.detail)
}

async function takesParts(endpoint: string): Promise<boolean> {
  const answer = await asked(endpoint, { method: 'OPTIONS' })
  return (answer.headers.get('Tus-Extension') ?? '').split(',').includes(EXTENSION)
}

async function create(
  endpoint: string,
  given: Record<string, string>,
  file: File,
  signal: AbortSignal,
): Promise<string> {
  const pairs = Object.entries(given).map(([name, value]) => `${name} ${base64(value)}`)
  const headers = { 'Tus-Resumable': '1.0.0', 'Upload-Length': String(file.size), 'Upload-Metadata': pairs.join(',') }
  const answer = await asked(endpoint, { method: 'POST', headers, signal })
  return uploadIdOf(answer.headers.get('Location'))
}

function giveUp(id: string): void {
  const request = { method: 'DELETE', headers: { 'Tus-Resumable': '1.0.0' } }
  asked(`/v1/uploads/${id}`, request).catch(() => undefined) // what stays expires by itself
}

const ask = (id: string, parts: { number: number; sha256: string }[]) =>
  post('/v1/uploads/{upload_id}/parts', { upload_id: id }, { parts })

/** Browsers hash on secure pages only. */
const canHash = () => (globalThis.crypto as Partial<Crypto> | undefined)?.subtle !== undefined

async function sha256Of(bytes: ArrayBuffer): Promise<string> {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes))
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('')
}

function read(bytes: Blob): Promise<ArrayBuffer> {
  return bytes.arrayBuffer().catch(() => {
    const detail = 'The file can’t be read any more. It was changed or moved. Choose it again.'
    throw new ApiProblem(400, { code: 'file-unreadable', detail })
  })
}

async function asked(url: string, request: RequestInit & { headers?: Record<string, string> }): Promise<Response> {
  const token = csrfToken()
  const headers = { ...request.headers, ...(token === undefined ? {} : { 'X-CSRF-Token': token }) }
  const answer = await fetch(url, { ...request, headers, credentials: 'same-origin' }).catch(() => {
    throw networkError()
  })
  if (!answer.ok) throw problemOf(answer.status, bodyOf(await answer.text()))
  return answer
}

function base64(text: string): string {
  return btoa(String.fromCharCode(...new TextEncoder().encode(text)))
}

/** Where the id of an upload that was begun is kept, so that it goes on after the page was closed. */
interface Place {
  known: () => string | null
  keep: (id: string) => string
  forget: () => void
}

function placeOf(endpoint: string, given: Record<string, string>, { file, path }: Upload): Place {
  const key = ['soundlist-parts', endpoint, JSON.stringify(given), path, file.size, file.lastModified].join('|')
  return {
    known: () => localStorage.getItem(key),
    keep: (id) => {
      localStorage.setItem(key, id)
      return id
    },
    forget: () => localStorage.removeItem(key),
  }
}

/** By XMLHttpRequest: fetch does not report the upload's progress. */
const putByXhr: Put = ({ url, headers }, bytes, onProgress, stop) =>
  new Promise((resolve) => {
    const request = new XMLHttpRequest()
    request.open('PUT', url)
    for (const [name, value] of Object.entries(headers)) request.setRequestHeader(name, value)
    request.upload.onprogress = (event) => onProgress(event.loaded)
    request.onloadend = () => resolve(request.status)
    stop.addEventListener('abort', () => request.abort())
    request.send(bytes)
  })
