import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { keepLastProject } from '@/app/lastProject'
import { shellRoute } from '@/app/roots'

import { deliveryQuery } from './api'

export const deliveryRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/deliveries',
    component: lazyRouteComponent(() => import('./DeliveriesPage'), 'DeliveriesPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/deliveries/$deliveryId',
    // The frame shows the project that the delivery is of; one that is not there says so on its page.
    loader: async ({ context, params }) => {
      const delivery = await context.queryClient.ensureQueryData(deliveryQuery(params.deliveryId)).catch(() => null)
      if (delivery) keepLastProject(delivery.project_id)
    },
    component: lazyRouteComponent(() => import('./DeliveryPage'), 'DeliveryPage'),
  }),
] as const
