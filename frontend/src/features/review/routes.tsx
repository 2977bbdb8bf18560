import type { QueryClient } from '@tanstack/react-query'
import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'
import { isNoted } from '@/judging/afterVerdict'
import { queueQuery, reviewQuery } from '@/judging/api'
import { filterOf, type QueueFilter } from '@/judging/queueFilter'

interface Spot extends QueueFilter {
  /** The selected version. */
  take?: string
  /** Where the playhead stands, in seconds. */
  at?: number
}

const reviewPage = lazyRouteComponent(() => import('./ReviewPage'), 'ReviewPage')

/** The queue, and the cue that Review opens of it. */
async function openFirst(client: QueryClient, projectId: string): Promise<void> {
  await client.prefetchInfiniteQuery(queueQuery(projectId))
  const pages = client.getQueryData(queueQuery(projectId).queryKey)?.pages ?? []
  const first = pages.flatMap(({ items }) => items).find((item) => !isNoted(item))
  if (first) await client.prefetchQuery(reviewQuery(first.cue.id))
}

export const reviewRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/review',
    validateSearch: filterOf,
    staticData: {
      early: (client, { projectId = '' }) => {
        void openFirst(client, projectId)
        void reviewPage.preload?.()?.catch(() => undefined)
      },
    },
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
      early: (client, { projectId = '', cueId = '' }) => {
        void client.prefetchInfiniteQuery(queueQuery(projectId))
        void client.prefetchQuery(reviewQuery(cueId))
      },
    },
    component: reviewPage,
  }),
] as const
