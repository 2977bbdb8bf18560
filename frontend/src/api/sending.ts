let inFlight = 0
const listeners = new Set<() => void>()

function count(change: 1 | -1): void {
  inFlight += change
  for (const listener of listeners) listener()
}

/** Count a write as in flight until it is answered or refused. */
export async function whileSending<T>(write: () => Promise<T>): Promise<T> {
  count(1)
  try {
    return await write()
  } finally {
    count(-1)
  }
}

/** Whether any write of this page waits for its answer. */
export const isSending = (): boolean => inFlight > 0

export function subscribeSending(listener: () => void): () => void {
  listeners.add(listener)
  return () => listeners.delete(listener)
}
