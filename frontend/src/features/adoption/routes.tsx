import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const adoptionRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list/adopt',
    validateSearch: (search: Record<string, unknown>): { adoption?: string } => ({
      adoption: typeof search.adoption === 'string' ? search.adoption : undefined,
    }),
    component: lazyRouteComponent(() => import('./AdoptPage'), 'AdoptPage'),
  }),
]
