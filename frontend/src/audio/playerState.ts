import type { TimeRange } from './draw'
import type { StepParts } from './playheadSteps'

export interface PlayerParts extends StepParts {
  createContext?: () => AudioContext
  random?: () => number
  /** Fetch no sound before one is played, or before `previews.release`. */
  held?: boolean
  /** Begin with light previews, where the browser plays them. */
  light?: boolean
}

/** Something to hear: a take, an alternate, the same take as master or as a game file. */
export interface Source {
  id: string
  url: string
  /** The take that is heard, as master or as a game file; without it nothing is recorded as heard. */
  takeId?: string
  /** How long it is; where that is known, a light preview plays from its first bytes on. */
  durationS?: number
  /** What brings it to the level of the others; used while levels are matched. */
  matchGainDb?: number
  /** Where it plays longer than it is: the sound at its places in a scene. */
  place?: (sound: AudioBuffer, context: BaseAudioContext) => AudioBuffer
}

/** From where on the others sound, on the clock of what is heard. */
export interface CompanyStart {
  context: BaseAudioContext
  to: AudioNode
  atS: number
  fromS: number
  loop: TimeRange | null
}

/** What sounds beside the source, from the same sample on. */
export interface Company {
  /** Sound from there; what sounds there already goes on without a gap. */
  begin: (start: CompanyStart) => void
  end: (atS: number) => void
}

export interface PlayerState {
  status: 'silent' | 'loading' | 'playing' | 'paused'
  sourceId: string | null
  takeId: string | null
  durationS: number
  looping: boolean
  /** What the loop repeats; the whole sound without it. */
  range: TimeRange | null
  reversed: boolean
  matched: boolean
  /** What is heard began at its start, and nothing of it was left out since. */
  fromStart: boolean
  /** A set is being played as the game does. */
  isRandomized: boolean
  error: string | null
  /** What is heard is a light preview; the exact sound takes its place once it is here. */
  isLight: boolean
}

export const SILENT: PlayerState = {
  status: 'silent',
  sourceId: null,
  takeId: null,
  durationS: 0,
  looping: false,
  range: null,
  reversed: false,
  matched: true,
  fromStart: true,
  isRandomized: false,
  error: null,
  isLight: false,
}

/** The state of a player, and who draws it. */
export class StateStore {
  state = SILENT
  #listeners = new Set<() => void>()

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  change(change: Partial<PlayerState>): void {
    this.state = { ...this.state, ...change }
    for (const listener of this.#listeners) listener()
  }
}
