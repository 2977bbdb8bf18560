import { keepDraft, keptDraft } from '@/app/drafts'

/** A file that was refused before a byte of it was sent. */
export interface RefusedFile {
  /** With its folders, as it was dropped. */
  name: string
  reason: string
}

const MOST_KEPT = 200

/** What was refused is still on the desk after a reload; the files themselves are not, and are dropped again. */
export class RefusedFiles {
  #earlier: readonly RefusedFile[]
  #kept: string
  readonly #key: string
  readonly #listeners = new Set<() => void>()

  constructor(projectId: string) {
    this.#key = `refused-files:${projectId}`
    this.#earlier = keptDraft<RefusedFile[]>(this.#key) ?? []
    this.#kept = JSON.stringify(this.#earlier)
  }

  /** Those of an earlier page that were not dropped again. */
  get = (): readonly RefusedFile[] => this.#earlier

  subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Keep what is refused now; what was dropped again is no longer of an earlier page. */
  update(refused: readonly RefusedFile[], dropped: ReadonlySet<string>): void {
    if (this.#earlier.some(({ name }) => dropped.has(name))) {
      this.#set(this.#earlier.filter(({ name }) => !dropped.has(name)))
    }
    this.#keep(refused)
  }

  forget(name: string, refused: readonly RefusedFile[]): void {
    this.#set(this.#earlier.filter((file) => file.name !== name))
    this.#keep(refused)
  }

  #set(earlier: readonly RefusedFile[]): void {
    this.#earlier = earlier
    for (const listener of this.#listeners) listener()
  }

  #keep(refused: readonly RefusedFile[]): void {
    const all = [...this.#earlier, ...refused].slice(-MOST_KEPT)
    const kept = JSON.stringify(all)
    if (kept === this.#kept) return
    this.#kept = kept
    keepDraft(this.#key, all.length === 0 ? null : all, true)
  }
}
