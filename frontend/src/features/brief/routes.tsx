import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

const version = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isInteger(value) && value >= 1 ? value : undefined

export const briefRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/brief',
    validateSearch: (search: Record<string, unknown>): { topic?: string } => ({
      topic: typeof search.topic === 'string' ? search.topic : undefined,
    }),
    component: lazyRouteComponent(() => import('./BriefPage'), 'BriefPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/brief/versions',
    validateSearch: (search: Record<string, unknown>): { from?: number; to?: number } => ({
      from: version(search.from),
      to: version(search.to),
    }),
    component: lazyRouteComponent(() => import('./BriefVersionsPage'), 'BriefVersionsPage'),
  }),
] as const
