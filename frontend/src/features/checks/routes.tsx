import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute } from '@/app/roots'

export const checkRoutes = [
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/checks/$check',
    component: lazyRouteComponent(() => import('./CheckPage'), 'CheckPage'),
  }),
]
