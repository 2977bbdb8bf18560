import type { Query, QueryClient } from '@tanstack/react-query'

/** Answers of one family that no page shows any more: as many are one step back, and memory stays the same all day. */
const MOST_UNSEEN = 40
/** A page that is being drawn asks first, and says a moment later that it shows the answer. */
const TRIM_AFTER_MS = 1_000

const familyOf = ({ queryKey }: Pick<Query, 'queryKey'>): string => String(queryKey[0])

/** Drop the oldest answers that no page shows, so that judging hundreds of sounds keeps the memory of some tens. */
export function boundCache(client: QueryClient, mostUnseen = MOST_UNSEEN): void {
  const cache = client.getQueryCache()
  const grown = new Set<string>()
  const trim = () => {
    for (const family of grown) {
      const unseen = cache
        .findAll({ fetchStatus: 'idle', predicate: (query) => familyOf(query) === family })
        .filter((query) => query.getObserversCount() === 0)
        .sort((a, b) => b.state.dataUpdatedAt - a.state.dataUpdatedAt)
      for (const query of unseen.slice(mostUnseen)) cache.remove(query)
    }
    grown.clear()
  }
  cache.subscribe(({ type, query }) => {
    if (type !== 'added') return
    if (grown.size === 0) setTimeout(trim, TRIM_AFTER_MS)
    grown.add(familyOf(query as Query))
  })
}
