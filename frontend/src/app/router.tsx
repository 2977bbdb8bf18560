import { createRoute, createRouter, lazyRouteComponent } from '@tanstack/react-router'

import { queryClient } from '@/api/queryClient'
import { reviewRoutes } from '@/features/review/routes'
import { todayRoutes } from '@/features/today/routes'
import { accountGuestRoutes, accountRoutes } from '@/features/accounts/routes'
import { createSession } from '@/features/accounts/session'

import { ErrorPage } from './ErrorPage'
import { NotFoundPage } from './NotFoundPage'
import { guestRoute, nowhereRoute, rootRoute, shellRoute } from './roots'
import { guestSession } from './session'
import { Shell } from './shell/Shell'

/** The page of all parts, for those who build: in development and test builds only, and without anyone signed in. */
const partsFrame = createRoute({
  getParentRoute: () => rootRoute,
  id: 'parts-frame',
  component: () => <Shell session={guestSession} />,
})
const partsRoutes =
  import.meta.env.DEV || import.meta.env.MODE === 'test'
    ? [
        partsFrame.addChildren([
          createRoute({
            getParentRoute: () => partsFrame,
            path: '/parts',
            component: lazyRouteComponent(() => import('@/parts/PartsPage'), 'PartsPage'),
          }),
        ]),
      ]
    : []

const routeTree = rootRoute.addChildren([
  guestRoute.addChildren([...accountGuestRoutes]),
  shellRoute.addChildren([...todayRoutes, ...reviewRoutes, ...accountRoutes, nowhereRoute]),
  ...partsRoutes,
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
