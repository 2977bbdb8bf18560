import { notifyManager, type Query, QueryClientContext } from '@tanstack/react-query'
import { useCallback, useContext, useSyncExternalStore } from 'react'

/** Whether a query that something on the page shows has no answer yet. */
const isFirst = (query: Query) =>
  query.state.status === 'pending' && query.state.fetchStatus === 'fetching' && query.isActive()

/** Whether the page waits for the first answer to anything that it shows. */
export function useIsLoading(): boolean {
  const cache = useContext(QueryClientContext)?.getQueryCache()
  const subscribe = useCallback(
    (listener: () => void) => cache?.subscribe(notifyManager.batchCalls(listener)) ?? (() => undefined),
    [cache],
  )
  return useSyncExternalStore(subscribe, () => cache?.getAll().some(isFirst) ?? false)
}
