import { createRoute, createRouter, lazyRouteComponent } from '@tanstack/react-router'

import { queryClient } from '@/api/queryClient'
import { accountGuestRoutes, accountRoutes } from '@/features/accounts/routes'
import { createSession } from '@/features/accounts/session'

import { ErrorPage } from './ErrorPage'
import { NotFoundPage } from './NotFoundPage'
import { guestRoute, nowhereRoute, rootRoute, shellRoute } from './roots'

/** The page of all parts, for those who build: in development and test builds only, and without anyone signed in. */
const partsRoute = createRoute({
  getParentRoute: () => rootRoute,
  id: 'parts',
  beforeLoad: () => ({ session: guestSession }),
  component: Shell,
}).addChildren([
  createRoute({
    getParentRoute: () => partsRoute,
    path: '/parts',
    component: lazyRouteComponent(() => import('@/parts/PartsPage'), 'PartsPage'),
  }),
])
const partsRoutes = import.meta.env.DEV || import.meta.env.MODE === 'test' ? [partsRoute] : []

const routeTree = rootRoute.addChildren([
  guestRoute.addChildren([...accountGuestRoutes]),
  shellRoute.addChildren([...accountRoutes, ...partsRoutes]),
])

export const router = createRouter({
  routeTree,
  context: { queryClient, session: createSession(queryClient) },
  defaultPreload: 'intent',
  defaultPreloadStaleTime: 0,
  defaultErrorComponent: ErrorPage,
  defaultNotFoundComponent: NotFoundPage,
  scrollRestoration: true,
})

declare module '@tanstack/react-router' {
  interface Register {
    router: typeof router
  }
  interface StaticDataRouteOption {
    /** Moving between two addresses of this route leaves the focus where it is, as when stepping through a queue. */
    keepsFocus?: boolean
  }
}
