import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'
import type { Picked, UploadQueue } from '@/uploads'

import type { Finding } from './checks'
import { type Judge, judgeInWorker } from './judgeInWorker'

type Schemas = components['schemas']
type Previewed = Schemas['CheckPreviewed']

/** A file that would come back. */
export interface HeldFile {
  id: number
  picked: Picked
  /** The cue that it was dropped on. */
  cueId: string | null
  /** The number and name of the cue that it is for, once its name says so. */
  cue: string
  findings: Finding[]
}

export interface PrecheckState {
  held: readonly HeldFile[]
  /** Files that were judged, of those that were dropped since all were. */
  judged: number
  dropped: number
  /** Files that passed and were sent since then. */
  passed: number
  /** What is checked before the upload, in words of the server. */
  labels: readonly string[]
}

interface PrecheckOptions {
  projectId: string
  /** Whether a file goes to the checks at all: the queue itself refuses some, and a ZIP is unpacked by the server. */
  isSound: (file: File) => Promise<boolean>
  send: (picked: readonly Picked[], cueId: string | null) => Promise<void>
  judge?: Judge
}

/** Files whose names are asked about in one request, and that are sent on together. */
const AT_ONCE = 50
const NOTIFY_EVERY_MS = 100
const NOTHING: PrecheckState = { held: [], judged: 0, dropped: 0, passed: 0, labels: [] }

/** What the files of a delivery go through before they are sent. */
export const precheckOf = (projectId: string, queue: UploadQueue, send: PrecheckOptions['send']): Precheck =>
  new Precheck({
    projectId,
    isSound: async (file) => {
      const judged = await queue.judge(file)
      return 'send' in judged && judged.send === 'sound'
    },
    send,
  })

const named = (projectId: string, picked: readonly Picked[], cueId: string | null): Promise<Previewed> =>
  answered(
    api.POST('/v1/projects/{project_id}/check-preview', {
      params: { path: { project_id: projectId } },
      body: { files: picked.map(({ path }) => ({ file_name: path, cue_id: cueId })) },
    }),
  )

/** Judges files before they are sent: what passes goes at once, what would come back waits for a decision. */
export class Precheck {
  #state = NOTHING
  #lastId = 0
  #last: Promise<void> = Promise.resolve()
  #isSkipped = false
  #notice: ReturnType<typeof setTimeout> | undefined
  readonly #listeners = new Set<() => void>()
  readonly #options: PrecheckOptions
  readonly #judge: Judge

  constructor(options: PrecheckOptions) {
    this.#options = options
    this.#judge = options.judge ?? judgeInWorker()
  }

  get = (): PrecheckState => this.#state

  subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Judge files after those dropped before, and send what passes; resolves once all are judged. */
  add(picked: readonly Picked[], cueId: string | null): Promise<void> {
    const { judged, dropped, passed } = this.#state
    const isNew = judged === dropped
    this.#set({
      judged: isNew ? 0 : judged,
      passed: isNew ? 0 : passed,
      dropped: (isNew ? 0 : dropped) + picked.length,
    })
    const added = this.#last.then(() => this.#addAll(picked, cueId))
    this.#last = added.catch(() => undefined)
    return added
  }

  /** Send files that wait, though they would come back. */
  async send(files: readonly HeldFile[]): Promise<void> {
    this.leaveOut(files)
    try {
      for (const { picked, cueId } of files) await this.#options.send([picked], cueId)
    } catch (refusal) {
      this.putBack(files)
      throw refusal
    }
  }

  /** Send everything: what waits, and what is still to be judged. */
  async sendAll(): Promise<void> {
    this.#isSkipped = this.#state.judged < this.#state.dropped
    await this.send(this.#state.held)
  }

  leaveOut(files: readonly HeldFile[]): void {
    const gone = new Set(files.map(({ id }) => id))
    this.#set({ held: this.#state.held.filter(({ id }) => !gone.has(id)) })
  }

  putBack(files: readonly HeldFile[]): void {
    this.#set({ held: [...this.#state.held, ...files].toSorted((one, other) => one.id - other.id) })
  }

  async #addAll(picked: readonly Picked[], cueId: string | null): Promise<void> {
    let counted = 0
    try {
      for (let start = 0; start < picked.length; start += AT_ONCE) {
        const some = picked.slice(start, start + AT_ONCE)
        await this.#addSome(some, cueId)
        counted += some.length
      }
    } finally {
      // What was refused together with these is shown by the page.
      if (counted < picked.length) this.#set({ judged: this.#state.judged + picked.length - counted })
      if (this.#state.judged >= this.#state.dropped) this.#isSkipped = false
      this.#notify()
    }
  }

  async #addSome(picked: readonly Picked[], cueId: string | null): Promise<void> {
    const areSounds = await Promise.all(picked.map(({ file }) => this.#options.isSound(file)))
    const sounds = picked.filter((_, index) => areSounds[index])
    const held = this.#isSkipped || sounds.length === 0 ? [] : await this.#wouldComeBack(sounds, cueId)
    const waiting = new Set(held.map(({ picked: { file } }) => file))
    const passed = picked.filter(({ file }) => !waiting.has(file))
    if (passed.length > 0) await this.#options.send(passed, cueId)
    const { judged, passed: before } = this.#state
    this.#set({
      held: [...this.#state.held, ...held],
      judged: judged + picked.length,
      passed: before + passed.length,
    })
  }

  /** The files that the server would return; none where it cannot be asked by what it judges. */
  async #wouldComeBack(picked: readonly Picked[], cueId: string | null): Promise<HeldFile[]> {
    const previewed = await named(this.#options.projectId, picked, cueId).catch(() => null)
    if (previewed === null) return []
    this.#set({ labels: previewed.checks.map(({ label }) => label) })
    const judged = await Promise.all(
      picked.map(async (one, index) => {
        const preview = previewed.files[index]
        const spec = preview && previewed.specs[preview.spec]
        if (preview === undefined || spec === undefined || preview.is_dry_stem) return null
        const judgement = await this.#judge({ file: one.file, spec, length: preview.length })
        if (judgement === null || this.#isSkipped) return null
        const findings = judgement.isUnreadable ? judgement.findings : [...judgement.findings, ...preview.findings]
        if (!findings.some(({ severity }) => severity === 'error')) return null
        const cue = preview.cue ? `${preview.cue.label} ${preview.cue.name}` : ''
        return { id: ++this.#lastId, picked: one, cueId, cue, findings }
      }),
    )
    return judged.filter((one) => one !== null)
  }

  #set(change: Partial<PrecheckState>): void {
    this.#state = { ...this.#state, ...change }
    this.#notice ??= setTimeout(() => this.#notify(), NOTIFY_EVERY_MS)
  }

  #notify(): void {
    clearTimeout(this.#notice)
    this.#notice = undefined
    for (const listener of this.#listeners) listener()
  }
}
