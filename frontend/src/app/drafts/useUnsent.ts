import { useSyncExternalStore } from 'react'

import { keptDraft, subscribeDrafts } from './store'

/** The first of these drafts that holds what was typed and not sent, null where none does. */
export function useUnsent<T extends string>(keys: readonly T[]): T | null {
  return useSyncExternalStore(subscribeDrafts, () => keys.find((key) => keptDraft(key) !== null) ?? null)
}
