import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute } from '@/app/roots'

export const invitationRoutes = [
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/invitation/$secret',
    component: lazyRouteComponent(() => import('./InvitationPage'), 'InvitationPage'),
  }),
]
