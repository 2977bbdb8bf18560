import { type Mutation, QueryClientContext } from '@tanstack/react-query'
import { useCallback, useContext, useEffect, useState } from 'react'

const isPending = ({ state }: Mutation) => state.status === 'pending'

/**
 * Run acts, and know whether the mutations that they began still wait for an answer. A part that runs its acts this way
 * shows that it waits and can refuse a second press, without being told by whoever uses it.
 */
export function usePending(): [isWaiting: boolean, run: <T>(act: () => T) => T] {
  const cache = useContext(QueryClientContext)?.getMutationCache()
  const [begun, setBegun] = useState<readonly Mutation[]>([])
  useEffect(() => {
    if (begun.length === 0) return
    const look = () => setBegun((mutations) => (mutations.every(isPending) ? mutations : mutations.filter(isPending)))
    look()
    // Of other events some are told while a page is rendered, when no state may be set.
    return cache?.subscribe(({ type }) => {
      if (type === 'updated' || type === 'removed') look()
    })
  }, [begun, cache])
  const run = useCallback(
    <T>(act: () => T): T => {
      const before = new Set(cache?.getAll())
      const result = act()
      const pending = cache?.getAll().filter((mutation) => !before.has(mutation) && isPending(mutation)) ?? []
      if (pending.length > 0) setBegun(pending)
      return result
    },
    [cache],
  )
  return [begun.length > 0, run]
}
