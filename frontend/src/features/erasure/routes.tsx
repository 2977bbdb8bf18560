import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

export const erasureRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/erase/account',
    component: lazyRouteComponent(() => import('./ErasurePages'), 'EraseAccountPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/erase/projects/$id',
    component: lazyRouteComponent(() => import('./ErasurePages'), 'EraseProjectPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/erase/studios/$id',
    component: lazyRouteComponent(() => import('./ErasurePages'), 'EraseStudioPage'),
  }),
] as const
