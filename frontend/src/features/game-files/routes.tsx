import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

const target = (search: Record<string, unknown>): { target?: string } =>
  typeof search.target === 'string' ? { target: search.target } : {}

export const gameFilesRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/game-files',
    component: lazyRouteComponent(() => import('./GameFilesPage'), 'GameFilesPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/packs',
    component: lazyRouteComponent(() => import('./PacksPage'), 'PacksPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/placeholders',
    validateSearch: target,
    component: lazyRouteComponent(() => import('./PlaceholdersPage'), 'PlaceholdersPage'),
  }),
] as const
