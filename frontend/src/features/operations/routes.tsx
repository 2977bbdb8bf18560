import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const operationRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/operations',
    validateSearch: ({ of }: Record<string, unknown>): { of?: string } => (typeof of === 'string' ? { of } : {}),
    component: lazyRouteComponent(() => import('./OperationsPage'), 'OperationsPage'),
  }),
]
