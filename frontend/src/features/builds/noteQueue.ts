import { ApiProblem } from '@/api'
import { serverReturns } from '@/api/connection'

import { type NoteAdd, sendNote, sendUndo } from './api'

/** What was said and is not on the server yet. */
export type Pending = { kind: 'note'; passId: string; body: NoteAdd; cueName: string } | { kind: 'undo'; id: string }

/** A note that the server refused, with its reason: it is shown until the person has read it. */
export interface RefusedNote {
  cueName: string
  body: NoteAdd
  why: string
}

interface Kept {
  pending: Pending[]
  refused: RefusedNote[]
}

const PREFIX = 'soundlist-listening'
const NONE: Kept = { pending: [], refused: [] }

/** An id made here, by which a note that is sent twice counts once; randomUUID would want HTTPS. */
export function newNoteId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16))
  bytes[6] = ((bytes[6] ?? 0) & 0x0f) | 0x40
  bytes[8] = ((bytes[8] ?? 0) & 0x3f) | 0x80
  const hex = [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join('')
  return [hex.slice(0, 8), hex.slice(8, 12), hex.slice(12, 16), hex.slice(16, 20), hex.slice(20)].join('-')
}

/** Notes of one person in one project, kept in this browser until the server has them, and sent in order, one at a time. */
export class NoteQueue {
  #kept: Kept
  #sending = false
  readonly #key: string
  readonly #listeners = new Set<() => void>()
  readonly #onSent: () => void

  constructor(personId: string, projectId: string, onSent: () => void) {
    this.#key = `${PREFIX}:${personId}:${projectId}`
    this.#onSent = onSent
    this.#kept = this.#read()
  }

  getState = (): Kept => this.#kept

  subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  add(entry: Pending): void {
    this.#keep({ ...this.#kept, pending: [...this.#kept.pending, entry] })
    void this.send()
  }

  forgetRefused(): void {
    this.#keep({ ...this.#kept, refused: [] })
  }

  /** Send what is kept, the oldest first; while the line is lost, wait for it. */
  async send(): Promise<void> {
    if (this.#sending) return
    this.#sending = true
    try {
      for (let next = this.#kept.pending[0]; next; next = this.#kept.pending[0]) {
        const answer = await this.#sendOne(next)
        if (answer.isKept) await serverReturns()
        else this.#drop(next, answer.refusal)
      }
    } finally {
      this.#sending = false
    }
    this.#onSent()
  }

  async #sendOne(entry: Pending): Promise<{ isKept: boolean; refusal: string | null }> {
    try {
      if (entry.kind === 'note') await sendNote(entry.passId, entry.body)
      else await sendUndo(entry.id)
      return { isKept: false, refusal: null }
    } catch (error) {
      const isFinal = error instanceof ApiProblem && error.status >= 400 && error.status < 500
      if (isFinal && error.status !== 401 && error.status !== 429) return { isKept: false, refusal: error.detail }
      return { isKept: true, refusal: null }
    }
  }

  #drop(entry: Pending, refusal: string | null): void {
    const refused =
      refusal !== null && entry.kind === 'note'
        ? [...this.#kept.refused, { cueName: entry.cueName, body: entry.body, why: refusal }]
        : this.#kept.refused
    this.#keep({ pending: this.#kept.pending.filter((other) => other !== entry), refused })
  }

  #keep(kept: Kept): void {
    this.#kept = kept
    try {
      if (kept.pending.length + kept.refused.length === 0) localStorage.removeItem(this.#key)
      else localStorage.setItem(this.#key, JSON.stringify(kept))
    } catch {
      // A browser that keeps nothing keeps them as long as the page stands.
    }
    for (const listener of this.#listeners) listener()
  }

  #read(): Kept {
    try {
      const kept = JSON.parse(localStorage.getItem(this.#key) ?? 'null') as Partial<Kept> | null
      return kept ? { pending: kept.pending ?? [], refused: kept.refused ?? [] } : NONE
    } catch {
      return NONE
    }
  }
}
