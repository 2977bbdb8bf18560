/** What the server refused after the person had gone on, shown until they have read it. */
export interface RefusedWrite {
  place: string
  what: string
  why: string
}

export type WriteKind = 'verdict' | 'undo' | 'comment'

interface LaterState {
  /** What each write that waits for the connection does, in order. */
  waiting: readonly WriteKind[]
  refused: readonly RefusedWrite[]
}

/** What is kept in this browser is under these names, then the person and its place. */
export const WAITING = 'soundlist-later'
export const REFUSED = 'soundlist-refused'

const listeners = new Set<() => void>()
let state: LaterState = { waiting: [], refused: [] }

/** What every page knows of writes that are sent later; what sends them is loaded where there are any. */
export const outbox = {
  /** Whose writes these are, and what follows those that nobody waited for. */
  writer: { personId: '', onLateAnswer: (): void => undefined },
  getState: (): LaterState => state,
  subscribe: (listener: () => void): (() => void) => {
    listeners.add(listener)
    return () => listeners.delete(listener)
  },
  show: (changed: Partial<LaterState>): void => {
    state = { ...state, ...changed }
    for (const listener of listeners) listener()
  },
}
