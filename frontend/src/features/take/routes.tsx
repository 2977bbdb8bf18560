import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { keepLastProject } from '@/app/lastProject'
import { shellRoute } from '@/app/roots'

import { deliveryFitQuery, takeQuery } from './api'

interface Place {
  /** Where in the sound, in seconds. */
  at?: number
}

export const takeRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/takes/$takeId',
    validateSearch: (search: Record<string, unknown>): Place => ({
      at: typeof search.at === 'number' && search.at >= 0 ? search.at : undefined,
    }),
    // The frame shows the project that the version is of; a version that is not there says so on its page.
    loader: async ({ context, params }) => {
      const take = await context.queryClient.ensureQueryData(takeQuery(params.takeId)).catch(() => null)
      if (take) keepLastProject(take.project_id)
    },
    component: lazyRouteComponent(() => import('./TakePage'), 'TakePage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/deliveries/$deliveryId/fit',
    loader: async ({ context, params }) => {
      const fit = await context.queryClient.ensureQueryData(deliveryFitQuery(params.deliveryId)).catch(() => null)
      if (fit) keepLastProject(fit.project_id)
    },
    component: lazyRouteComponent(() => import('./DeliveryFitPage'), 'DeliveryFitPage'),
  }),
] as const
