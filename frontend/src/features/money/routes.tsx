import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const moneyRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/money',
    component: lazyRouteComponent(() => import('./MoneyPage'), 'MoneyPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/milestones/$milestoneId',
    component: lazyRouteComponent(() => import('./MilestonePage'), 'MilestonePage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/plan',
    component: lazyRouteComponent(() => import('./PlanPage'), 'PlanPage'),
  }),
] as const
