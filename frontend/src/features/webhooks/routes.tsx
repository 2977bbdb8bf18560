import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const webhookRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/webhooks',
    validateSearch: (search: Record<string, unknown>): { studio?: string } => ({
      studio: typeof search.studio === 'string' ? search.studio : undefined,
    }),
    component: lazyRouteComponent(() => import('./WebhooksPage'), 'WebhooksPage'),
  }),
] as const
