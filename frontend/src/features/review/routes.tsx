import type { QueryClient } from '@tanstack/react-query'
import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'
import { isNoted } from '@/verdicts/afterVerdict'
import { queueQuery, reviewQuery } from '@/verdicts/api'
import { filterOf, type QueueFilter } from '@/verdicts/queueFilter'
import { heardTakes } from '@/verdicts/words'

import { foundReasonsOf } from './foundReasons'

interface Spot extends QueueFilter {
  /** The selected version. */
  take?: string
  /** Where the playhead stands, in seconds. */
  at?: number
}

const reviewPage = lazyRouteComponent(() => import('./ReviewPage'), 'ReviewPage')

/** Ask for the queue, for the cue that Review opens of it and for its waveform, while the page itself is loaded. */
async function openFirst(client: QueryClient, projectId: string, filter: QueueFilter = {}): Promise<void> {
  const query = queueQuery(projectId, filter)
  const page = reviewPage.preload?.()?.catch(() => undefined) // the route loads it again, and says what is wrong
  await client.prefetchInfiniteQuery(query)
  const pages = client.getQueryData(query.queryKey)?.pages ?? []
  const first = pages.flatMap(({ items }) => items).find((item) => !isNoted(item))
  if (first === undefined) return
  void client.prefetchQuery(reviewQuery(first.cue.id))
  const shape = heardTakes(first)[0]?.peaks_url
  if (!shape) return
  await page
  const { prefetchPeaks } = await import('@/verdicts/peaks')
  await prefetchPeaks(client, shape)
}

export const reviewRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/review',
    validateSearch: filterOf,
    staticData: {
      prefetch: (client, { projectId = '' }) => void openFirst(client, projectId),
      preloads: reviewPage,
    },
    beforeLoad: ({ context: { queryClient }, params: { projectId }, search }) =>
      void openFirst(queryClient, projectId, search),
    component: lazyRouteComponent(() => import('./ReviewStart'), 'ReviewStart'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/review/$cueId',
    validateSearch: (search: Record<string, unknown>): Spot => ({
      ...filterOf(search),
      take: typeof search.take === 'string' ? search.take : undefined,
      at: typeof search.at === 'number' && search.at >= 0 ? search.at : undefined,
    }),
    staticData: {
      keepsFocus: true,
      prefetch: (client, { projectId = '', cueId = '' }) => {
        void client.prefetchInfiniteQuery(queueQuery(projectId))
        void client.prefetchQuery(reviewQuery(cueId))
      },
    },
    component: reviewPage,
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/reasons',
    validateSearch: foundReasonsOf,
    component: lazyRouteComponent(() => import('./ReasonsPage'), 'ReasonsPage'),
  }),
] as const
