import { createRoute, createRouter, lazyRouteComponent } from '@tanstack/react-router'

import { queryClient } from '@/api/queryClient'

import { ErrorPage } from './ErrorPage'
import { NotFoundPage } from './NotFoundPage'
import { guestRoute, rootRoute, shellRoute } from './roots'
import { guestSession } from './session'

/** The page of all parts, for those who build: in development and test builds only. */
const partsRoutes =
  import.meta.env.DEV || import.meta.env.MODE === 'test'
    ? [
        createRoute({
          getParentRoute: () => shellRoute,
          path: '/parts',
          component: lazyRouteComponent(() => import('@/parts/PartsPage'), 'PartsPage'),
        }),
      ]
    : []

const routeTree = rootRoute.addChildren([guestRoute.addChildren([]), shellRoute.addChildren([...partsRoutes])])

export const router = createRouter({
  routeTree,
  context: { queryClient, session: guestSession },
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
