/** Whether the server answers, known once for the whole page. */
const FIRST_PAUSE_MS = 500
const LONGEST_PAUSE_MS = 5_000

let returning: Promise<void> | null = null
const listeners = new Set<() => void>()

export const connection = {
  isUnreachable: (): boolean => returning !== null,
  subscribe: (listener: () => void): (() => void) => {
    listeners.add(listener)
    return () => listeners.delete(listener)
  },
}

async function isReady(): Promise<boolean> {
  try {
    return (await globalThis.fetch(new URL('/readyz', globalThis.location.origin))).ok
  } catch {
    return false
  }
}

async function waitForServer(): Promise<void> {
  for (let pause = FIRST_PAUSE_MS; ; pause = Math.min(LONGEST_PAUSE_MS, pause * 1.5)) {
    await new Promise((resolve) => setTimeout(resolve, pause))
    if (await isReady()) break
  }
  returning = null
  for (const listener of listeners) listener()
}

/** The server did not answer: the promise resolves once it does. */
export function serverReturns(): Promise<void> {
  if (returning === null) {
    returning = waitForServer()
    for (const listener of listeners) listener()
  }
  return returning
}

/** A connection broke: know whether the server is still there. */
export async function checkServer(): Promise<void> {
  if (returning === null && !(await isReady())) await serverReturns()
}
