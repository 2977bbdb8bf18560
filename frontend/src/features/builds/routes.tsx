import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

const text = (value: unknown): string | undefined => (typeof value === 'string' && value !== '' ? value : undefined)

export const buildRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/drift',
    validateSearch: (search: Record<string, unknown>): { audit?: string } => ({ audit: text(search.audit) }),
    staticData: { keepsFocus: true },
    component: lazyRouteComponent(() => import('./DriftPage'), 'DriftPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/listening',
    component: lazyRouteComponent(() => import('./ListeningPage'), 'ListeningPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/game-tasks',
    component: lazyRouteComponent(() => import('./TasksPage'), 'TasksPage'),
  }),
]
