import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const kitRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list/kits',
    validateSearch: (search: Record<string, unknown>): { kit?: string } => ({
      kit: typeof search.kit === 'string' ? search.kit : undefined,
    }),
    component: lazyRouteComponent(() => import('./KitsPage'), 'KitsPage'),
  }),
] as const
