import { ApiProblem } from '@/api/problem'

import type { Picked } from './drops'
import { type Accepts, ANY_WAV, judge, type Judged, kindOf, SNIFF_BYTES } from './sniff'

export type UploadState =
  'waiting' | 'sending' | 'line_lost' | 'paused' | 'finished' | 'stopped' | 'not_sent' | 'already_here'

export interface Upload {
  id: string
  file: File
  path: string
  kind: 'sound' | 'archive'
  state: UploadState
  sentBytes: number
  /** Where it went on after the line was lost, or after the page was opened again. */
  resumedAtBytes: number | null
  /** Why it was not sent. */
  reason: string | null
  /** The cue that it was dropped on. */
  cueId: string | null
}

export interface TransportEvents {
  onProgress: (sentBytes: number) => void
  /** It goes on from here rather than from the start. */
  onResumed: (fromBytes: number) => void
  onFinished: (uploadId: string) => void
  /** Nothing was answered, or the server broke: worth trying again. */
  onLost: () => void
  onRefused: (detail: string) => void
}

/** What carries one file; the queue does not care how. */
export interface Transport {
  /** Start or go on; the answer stops it, and with `forget` also takes away what was sent. */
  start: (upload: Upload, events: TransportEvents) => (forget: boolean) => void
}

export interface QueueOptions {
  transport: Transport
  /** Called when all bytes are there: this makes the take. */
  onFinished: (upload: Upload, uploadId: string) => Promise<void>
  atATime?: number
  accepts?: Accepts
  now?: () => number
}

export interface Figures {
  files: number
  finished: number
  sentBytes: number
  totalBytes: number
  bytesPerS: number
  /** null while nothing moves. */
  secondsLeft: number | null
}

const RETRY_S = [1, 2, 4, 8, 15]
const SPEED_WINDOW_MS = 5_000
const NOTIFY_EVERY_MS = 100
/** So few files are read and listed in one go that the page stays quick while a thousand are dropped. */
const ADDED_AT_ONCE = 50
const GOING: readonly UploadState[] = ['waiting', 'sending', 'line_lost', 'paused']

/** Whether a file is on its way, or waits to be. */
export const isGoing = ({ state }: Upload): boolean => GOING.includes(state)

interface Running {
  stop: (forget: boolean) => void
  retry?: ReturnType<typeof setTimeout>
  failures: number
  /** All bytes are there; only the take is still to be made. */
  uploadId?: string
}

/** Sends files, four at a time, and does not give up when the line does. */
export class UploadQueue {
  #uploads: Upload[] = []
  #running = new Map<string, Running>()
  #failures = new Map<string, number>()
  #listeners = new Set<() => void>()
  #pendingNotice: ReturnType<typeof setTimeout> | undefined
  #samples: { at: number; sentBytes: number }[] = []
  #nextId = 1
  #paused = false
  readonly #options: Required<QueueOptions>

  constructor(options: QueueOptions) {
    this.#options = { atATime: 4, accepts: ANY_WAV, now: () => performance.now(), ...options }
  }

  get = (): readonly Upload[] => this.#uploads

  subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Judge the next files by a spec that has changed. */
  accept(accepts: Accepts): void {
    this.#options.accepts = accepts
  }

  isPaused = (): boolean => this.#paused

  figures(): Figures {
    const counted = this.#uploads.filter((upload) => isGoing(upload) || upload.state === 'finished')
    const sentBytes = counted.reduce((sum, upload) => sum + upload.sentBytes, 0)
    const totalBytes = counted.reduce((sum, upload) => sum + upload.file.size, 0)
    const bytesPerS = this.#speed()
    return {
      files: counted.length,
      finished: counted.filter(({ state }) => state === 'finished').length,
      sentBytes,
      totalBytes,
      bytesPerS,
      secondsLeft: bytesPerS > 0 ? (totalBytes - sentBytes) / bytesPerS : null,
    }
  }

  /** Queue files, some at a time. What is here already, by name and size, is shown as such and not sent twice. */
  async add(picked: readonly Picked[], cueId: string | null = null): Promise<void> {
    for (let start = 0; start < picked.length; start += ADDED_AT_ONCE) {
      if (start > 0) await nextTask()
      await this.#addSome(picked.slice(start, start + ADDED_AT_ONCE), cueId)
    }
    this.#notify()
  }

  /** Whether a file goes on its way, by its name and its first bytes. */
  judge = async (file: File): Promise<Judged> => {
    const first = new Uint8Array(await file.slice(0, SNIFF_BYTES).arrayBuffer())
    return judge(file.name, file.size, kindOf(first), this.#options.accepts)
  }

  async #addSome(picked: readonly Picked[], cueId: string | null): Promise<void> {
    const judged = await Promise.all(picked.map(({ file }) => this.judge(file)))
    picked.forEach(({ file, path }, index) => {
      const verdict = judged[index]
      const base = { id: `u${this.#nextId++}`, file, path, sentBytes: 0, resumedAtBytes: null, cueId }
      if (verdict === undefined || 'refused' in verdict) {
        this.#uploads.push({ ...base, kind: 'sound', state: 'not_sent', reason: verdict?.refused ?? null })
      } else if (this.#holds(file, cueId)) {
        this.#uploads.push({ ...base, kind: verdict.send, state: 'already_here', reason: null })
      } else {
        this.#uploads.push({ ...base, kind: verdict.send, state: this.#paused ? 'paused' : 'waiting', reason: null })
      }
    })
    this.#pump()
    this.#tellSoon()
  }

  pause(id?: string): void {
    if (id === undefined) this.#paused = true
    for (const upload of this.#uploads) {
      if ((id === undefined || upload.id === id) && ['waiting', 'sending', 'line_lost'].includes(upload.state)) {
        this.#halt(upload.id, false)
        this.#set(upload.id, { state: 'paused' })
      }
    }
    this.#pump()
    this.#notify()
  }

  resume(id?: string): void {
    if (id === undefined) this.#paused = false
    for (const upload of this.#uploads) {
      if ((id === undefined || upload.id === id) && upload.state === 'paused')
        this.#set(upload.id, { state: 'waiting' })
    }
    this.#pump()
    this.#notify()
  }

  /** Stop one for good; what was sent of it is taken away. */
  stop(id: string): void {
    const upload = this.#find(id)
    if (upload === undefined || !isGoing(upload)) return
    this.#halt(id, true)
    this.#set(id, { state: 'stopped' })
    this.#pump()
    this.#notify()
  }

  /** Take a row off the list that is not on its way. */
  dismiss(id: string): void {
    this.#uploads = this.#uploads.filter((upload) => upload.id !== id || isGoing(upload))
    this.#notify()
  }

  /** The line is back: those that wait for it go on at once. */
  lineIsBack = (): void => {
    for (const upload of this.#uploads) if (upload.state === 'line_lost') this.#retry(upload.id)
  }

  dispose(): void {
    for (const id of [...this.#running.keys()]) this.#halt(id, false)
    clearTimeout(this.#pendingNotice)
  }

  #holds(file: File, cueId: string | null): boolean {
    return this.#uploads.some(
      (upload) =>
        upload.file.name === file.name &&
        upload.file.size === file.size &&
        upload.cueId === cueId &&
        (isGoing(upload) || upload.state === 'finished'),
    )
  }

  #find(id: string): Upload | undefined {
    return this.#uploads.find((upload) => upload.id === id)
  }

  #set(id: string, change: Partial<Upload>): void {
    this.#uploads = this.#uploads.map((upload) => (upload.id === id ? { ...upload, ...change } : upload))
  }

  #pump(): void {
    for (const upload of this.#uploads) {
      if (this.#running.size >= this.#options.atATime) return
      if (upload.state === 'waiting') this.#start(upload.id)
    }
  }

  #start(id: string): void {
    this.#set(id, { state: 'sending', reason: null })
    const upload = this.#find(id)
    if (upload === undefined) return
    const running: Running = { stop: () => undefined, failures: this.#failures.get(id) ?? 0 }
    this.#running.set(id, running)
    const current = () => this.#running.get(id) === running
    running.stop = this.#options.transport.start(upload, {
      onResumed: (fromBytes) => {
        if (!current()) return
        this.#set(id, { resumedAtBytes: fromBytes, sentBytes: fromBytes })
        this.#notify()
      },
      onProgress: (sentBytes) => {
        if (!current()) return
        this.#failures.delete(id)
        running.failures = 0
        this.#set(id, { sentBytes })
        this.#sample()
        this.#tellSoon()
      },
      onFinished: (uploadId) => {
        if (!current()) return
        running.uploadId = uploadId
        this.#set(id, { sentBytes: upload.file.size })
        void this.#finish(id, running)
      },
      onLost: () => {
        if (current()) this.#lost(id, running)
      },
      onRefused: (detail) => {
        if (current()) this.#refused(id, detail)
      },
    })
  }

  async #finish(id: string, running: Running): Promise<void> {
    const upload = this.#find(id)
    if (upload === undefined || running.uploadId === undefined) return
    try {
      await this.#options.onFinished(upload, running.uploadId)
    } catch (error) {
      if (this.#running.get(id) !== running) return
      if (error instanceof ApiProblem && error.status >= 400 && error.status < 500) this.#refused(id, error.detail)
      else this.#lost(id, running)
      return
    }
    if (this.#running.get(id) !== running) return
    this.#running.delete(id)
    this.#set(id, { state: 'finished', sentBytes: upload.file.size })
    this.#pump()
    // Small files finish faster than the page can draw.
    if (this.#uploads.some(isGoing)) this.#tellSoon()
    else this.#notify()
  }

  #refused(id: string, reason: string): void {
    this.#running.delete(id)
    this.#set(id, { state: 'not_sent', reason })
    this.#pump()
    this.#notify()
  }

  #lost(id: string, running: Running): void {
    const wait = RETRY_S[Math.min(running.failures, RETRY_S.length - 1)] ?? 15
    running.failures += 1
    this.#failures.set(id, running.failures)
    running.retry = setTimeout(() => this.#retry(id), wait * 1000)
    this.#set(id, { state: 'line_lost' })
    this.#samples = []
    this.#notify()
  }

  #retry(id: string): void {
    const running = this.#running.get(id)
    if (running === undefined) return
    clearTimeout(running.retry)
    if (running.uploadId !== undefined) {
      this.#set(id, { state: 'sending' })
      void this.#finish(id, running)
    } else {
      this.#running.delete(id)
      running.stop(false)
      this.#start(id)
    }
    this.#notify()
  }

  #halt(id: string, forget: boolean): void {
    const running = this.#running.get(id)
    if (running === undefined) return
    this.#running.delete(id)
    clearTimeout(running.retry)
    running.stop(forget)
  }

  #sample(): void {
    const at = this.#options.now()
    const sentBytes = this.#uploads.reduce((sum, upload) => sum + upload.sentBytes, 0)
    this.#samples = [...this.#samples.filter((sample) => at - sample.at <= SPEED_WINDOW_MS), { at, sentBytes }]
  }

  #speed(): number {
    const first = this.#samples[0]
    const last = this.#samples.at(-1)
    if (first === undefined || last === undefined || last.at <= first.at) return 0
    return Math.max(0, ((last.sentBytes - first.sentBytes) / (last.at - first.at)) * 1000)
  }

  #tellSoon(): void {
    this.#pendingNotice ??= setTimeout(() => this.#notify(), NOTIFY_EVERY_MS)
  }

  #notify(): void {
    clearTimeout(this.#pendingNotice)
    this.#pendingNotice = undefined
    this.#uploads = [...this.#uploads]
    for (const listener of this.#listeners) listener()
  }
}

/** Let the browser draw and answer clicks first. */
const nextTask = () => new Promise<void>((resolve) => setTimeout(resolve))
