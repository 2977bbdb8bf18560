/** What people typed and did not send yet, kept in this browser for each person until it is sent or a month old. */
const PREFIX = 'soundlist-draft'
const KEPT_FOR_MS = 30 * 24 * 3_600_000

let owner = ''
/** What the browser could not keep lives as long as the page. */
const memory = new Map<string, unknown>()

const listeners = new Set<() => void>()

/** Hear of each draft that is kept or deleted; the answer ends it. */
export function subscribeDrafts(listener: () => void): () => void {
  listeners.add(listener)
  return () => listeners.delete(listener)
}

/** What was typed since this page was opened, and is not sent: leaving asks about it. */
const typed = new Set<string>()

interface Kept {
  atMs: number
  value: unknown
}

const keyOf = (key: string) => `${PREFIX}:${owner}:${key}`

function keys(prefix: string): string[] {
  return Array.from({ length: localStorage.length }, (_, index) => localStorage.key(index) ?? '').filter((key) =>
    key.startsWith(prefix),
  )
}

function read(fullKey: string): Kept | null {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(fullKey) ?? 'null')
    return typeof kept === 'object' && kept !== null && 'atMs' in kept && 'value' in kept ? (kept as Kept) : null
  } catch {
    return null
  }
}

/** Whose drafts are read and kept from now on; those that grew old are deleted. */
export function openDraftsOf(personId: string): void {
  if (owner === personId) return
  owner = personId
  typed.clear()
  try {
    for (const key of keys(`${PREFIX}:`)) {
      if (Date.now() - (read(key)?.atMs ?? 0) > KEPT_FOR_MS) localStorage.removeItem(key)
    }
  } catch {
    // A browser that keeps nothing keeps what was typed as long as the page stands.
  }
}

/** Delete what the person typed here and did not send: they sign out. */
export function forgetDrafts(): void {
  try {
    for (const key of keys(`${PREFIX}:${owner}:`)) localStorage.removeItem(key)
  } catch {
    // There are none.
  }
  memory.clear()
  typed.clear()
  owner = ''
}

export const isAnythingTyped = (): boolean => owner !== '' && typed.size > 0

/** The person leaves: what they typed is kept for when they come back. */
export function keepDrafts(): void {
  typed.clear()
}

/** The person leaves, and wants none of what they typed. */
export function discardDrafts(): void {
  for (const key of [...typed]) keepDraft(key, null)
}

export function keptDraft<T>(key: string): T | null {
  if (memory.has(keyOf(key))) return memory.get(keyOf(key)) as T
  const kept = owner === '' ? null : read(keyOf(key))
  return kept === null || Date.now() - kept.atMs > KEPT_FOR_MS ? null : (kept.value as T)
}

/**
 * Keep a draft, or delete it where it is null; the answer is whether it outlives this page. What is `handedOver` was not
 * typed here: another page opens with it.
 */
export function keepDraft(key: string, value: unknown, handedOver = false): boolean {
  const isKept = write(key, value, handedOver)
  for (const listener of listeners) listener()
  return isKept
}

function write(key: string, value: unknown, handedOver: boolean): boolean {
  if (value === null) typed.delete(key)
  else if (!handedOver && JSON.stringify(value) !== JSON.stringify(keptDraft(key))) typed.add(key)
  memory.delete(keyOf(key))
  try {
    if (owner === '') throw new Error('nobody is signed in')
    if (value === null) localStorage.removeItem(keyOf(key))
    else localStorage.setItem(keyOf(key), JSON.stringify({ atMs: Date.now(), value } satisfies Kept))
    return true
  } catch {
    if (value !== null) memory.set(keyOf(key), value) // no room, or turned off
    return false
  }
}
