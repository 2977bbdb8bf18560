import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const moneyRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/money',
    component: lazyRouteComponent(() => import('./MoneyPage'), 'MoneyPage'),
  }),
] as const
