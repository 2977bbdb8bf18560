import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const referenceRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/references',
    validateSearch: (search: Record<string, unknown>): { cue?: string } => ({
      cue: typeof search.cue === 'string' ? search.cue : undefined,
    }),
    component: lazyRouteComponent(() => import('./ReferencesPage'), 'ReferencesPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/references/$referenceId/spotting',
    component: lazyRouteComponent(() => import('./spotting/SpottingPage'), 'SpottingPage'),
  }),
] as const
