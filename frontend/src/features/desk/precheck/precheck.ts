import { post } from '@/api'
import type { components } from '@/api/schema.gen'
import type { Picked, UploadQueue } from '@/uploads'

import type { Candidate, HeldFile, Look, PrecheckState } from './held'
import { type Judge, judgeInWorker } from '@/precheck/judgeInWorker'
import { baseName, isChanged, isPossibleName, nameProblems, renamesHere, wantedName } from './renames'

type Schemas = components['schemas']
type Previewed = Schemas['CheckPreviewed']

interface PrecheckOptions {
  projectId: string
  /** Whether a file goes to the checks at all: the queue itself refuses some, and a ZIP is unpacked by the server. */
  isSound: (file: File) => Promise<boolean>
  send: (picked: readonly Picked[], cueId: string | null) => Promise<void>
  judge?: Judge
}

/** Files whose names are asked about in one request, and that are sent on together. */
const AT_ONCE = 50
const MOST_PROPOSED = 1_000
const NOTIFY_EVERY_MS = 100
const NOTHING: PrecheckState = {
  held: [],
  renames: [],
  isRenaming: false,
  judged: 0,
  dropped: 0,
  passed: 0,
  labels: [],
}

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

const named = (projectId: string, files: readonly Candidate[], proposed: string[]): Promise<Previewed> =>
  post(
    '/v1/projects/{project_id}/check-preview',
    { project_id: projectId },
    { files: files.map(({ picked: { path }, cueId }) => ({ file_name: path, cue_id: cueId })), proposed },
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
    this.#notify()
  }

  /** Take what is typed into the field of a file's name. */
  want(id: number, wanted: string): void {
    this.#set({ held: this.#state.held.map((file) => (file.id === id ? { ...file, wanted } : file)) })
    this.#notify()
  }

  /** Give files the names in their fields and check them again; one with an unfit name keeps what it has. */
  async rename(files: readonly HeldFile[]): Promise<void> {
    const problems = nameProblems(this.#state.held)
    const before = files.filter((file) => isChanged(file) && !problems.has(file.id))
    if (before.length === 0 || this.#state.isRenaming) return
    this.#set({ isRenaming: true })
    this.#notify()
    try {
      const renamed = new Map<number, HeldFile>()
      for (let start = 0; start < before.length; start += AT_ONCE) {
        for (const file of await this.#renamed(before.slice(start, start + AT_ONCE))) renamed.set(file.id, file)
      }
      const typed = new Map(before.map(({ id, wanted }) => [id, wanted]))
      this.#replace((now) => {
        const file = renamed.get(now.id)
        // What was typed meanwhile stays in its field.
        return file && (now.wanted === typed.get(now.id) ? file : { ...file, wanted: now.wanted })
      })
      this.#set({ renames: [...this.#state.renames, before] })
    } finally {
      this.#set({ isRenaming: false })
      this.#notify()
    }
  }

  /** Put back the names of the last renaming, of the files that were not sent. */
  undoRename(): void {
    const steps = renamesHere(this.#state)
    const before = new Map(steps.at(-1)?.map((file) => [file.id, file]))
    this.#replace((now) => before.get(now.id))
    this.#set({ renames: steps.slice(0, -1) })
    this.#notify()
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
    const held = this.#isSkipped || sounds.length === 0 ? [] : await this.#toHold(sounds, cueId)
    const waiting = new Set(held.map(({ picked: { file } }) => file))
    // What the queue refuses, it lists with the reason.
    const going = picked.filter(({ file }) => !waiting.has(file))
    if (going.length > 0) await this.#options.send(going, cueId)
    const { judged, passed: before } = this.#state
    this.#set({
      held: [...this.#state.held, ...held],
      judged: judged + picked.length,
      passed: before + sounds.length - held.length,
    })
  }

  /** The files under the names in their fields, checked again. */
  async #renamed(files: readonly HeldFile[]): Promise<HeldFile[]> {
    const candidates = files.map((file) => ({
      picked: { ...file.picked, path: wantedName(file) },
      cueId: file.cueId,
    }))
    const looks = await this.#look(candidates, files)
    return files.map((file, index) => {
      const { picked } = candidates[index]!
      const look = looks[index] ?? { cue: '', listName: null, findings: [] }
      const firstName = file.firstName ?? file.picked.path
      return {
        ...file,
        ...look,
        picked,
        wanted: look.listName ?? picked.path,
        firstName: picked.path === firstName ? null : firstName,
      }
    })
  }

  #replace(otherOf: (file: HeldFile) => HeldFile | undefined): void {
    this.#set({ held: this.#state.held.map((file) => otherOf(file) ?? file) })
  }

  /** The files that wait for a decision; none where the server cannot be asked by what it judges. */
  async #toHold(picked: readonly Picked[], cueId: string | null): Promise<HeldFile[]> {
    const candidates = picked.map((one) => ({ picked: one, cueId }))
    const looks = await this.#look(candidates).catch(() => [])
    if (this.#isSkipped) return []
    return candidates.flatMap((candidate, index) => {
      const look = looks[index]
      const isWrong = look?.findings.some(({ severity }) => severity === 'error')
      if (!look || (!isWrong && (look.cue !== '' || look.listName === null))) return []
      const wanted = look.listName ?? baseName(candidate.picked.path)
      return [{ ...candidate, ...look, id: ++this.#lastId, wanted, firstName: null }]
    })
  }

  /** What is known of each file, of those that are held under another name too; null where no check is made. */
  async #look(files: readonly Candidate[], held: readonly HeldFile[] = []): Promise<(Look | null)[]> {
    const others = this.#state.held.filter((file) => !held.some(({ id }) => id === file.id))
    const proposed = others.map(wantedName).filter(isPossibleName).slice(-MOST_PROPOSED)
    const previewed = await named(this.#options.projectId, files, proposed)
    this.#set({ labels: previewed.checks.map(({ label }) => label) })
    return Promise.all(
      files.map(async ({ picked: { file } }, index) => {
        const preview = previewed.files[index]
        const spec = preview && previewed.specs[preview.spec]
        if (preview === undefined || spec === undefined || preview.is_dry_stem) return null
        const judgement = await this.#judge({ file, spec, length: preview.length })
        const ofName = judgement === null || judgement.isUnreadable ? [] : preview.findings
        const cue = preview.cue ? `${preview.cue.label} ${preview.cue.name}` : ''
        return { cue, listName: preview.list_name, findings: [...(judgement?.findings ?? []), ...ofName] }
      }),
    )
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
