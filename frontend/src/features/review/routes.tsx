import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

interface Spot {
  /** The selected version. */
  take?: string
  /** Where the playhead stands, in seconds. */
  at?: number
}

export const reviewRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/review',
    component: lazyRouteComponent(() => import('./ReviewStart'), 'ReviewStart'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/review/$cueId',
    validateSearch: (search: Record<string, unknown>): Spot => ({
      take: typeof search.take === 'string' ? search.take : undefined,
      at: typeof search.at === 'number' && search.at >= 0 ? search.at : undefined,
    }),
    staticData: { keepsFocus: true },
    component: lazyRouteComponent(() => import('./ReviewPage'), 'ReviewPage'),
  }),
] as const
