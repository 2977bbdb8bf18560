const REDUCED_STEP_MS = 100

export interface StepParts {
  /** Calls back before the next frame, and answers how to take that back. */
  onFrame?: (callback: () => void) => () => void
  reducedMotion?: () => boolean
  now?: () => number
}

const everyFrame = (callback: () => void): (() => void) => {
  const frame = requestAnimationFrame(callback)
  return () => cancelAnimationFrame(frame)
}

/** Calls those who draw the playhead: at each frame while it moves, ten times a second under reduced motion. */
export class PlayheadSteps {
  #listeners = new Set<() => void>()
  #endFrame: (() => void) | null = null
  #steppedAt = -Infinity
  readonly #onFrame: (callback: () => void) => () => void
  readonly #reducedMotion: () => boolean
  readonly #now: () => number

  constructor(parts: StepParts) {
    this.#onFrame = parts.onFrame ?? everyFrame
    this.#reducedMotion = parts.reducedMotion ?? (() => matchMedia('(prefers-reduced-motion: reduce)').matches)
    this.#now = parts.now ?? (() => performance.now())
  }

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  step(): void {
    for (const listener of this.#listeners) listener()
  }

  /** Step at each frame, for as long as `isMoving` says so. */
  start(isMoving: () => boolean): void {
    this.stop()
    this.#endFrame = this.#onFrame(() => {
      this.#endFrame = null
      if (!isMoving()) return
      const now = this.#now()
      if (!this.#reducedMotion() || now - this.#steppedAt >= REDUCED_STEP_MS) {
        this.#steppedAt = now
        this.step()
      }
      this.start(isMoving)
    })
  }

  stop(): void {
    this.#endFrame?.()
    this.#endFrame = null
  }
}
