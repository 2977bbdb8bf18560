import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { rootRoute } from '@/app/roots'
import { guestSession } from '@/app/session'
import { Shell } from '@/app/shell/Shell'

/** The page of all parts in the shell, without a sign-in. */
export function partsRoute() {
  const frame = createRoute({
    getParentRoute: () => rootRoute,
    id: 'parts-frame',
    component: () => <Shell session={guestSession} />,
  })
  return frame.addChildren([
    createRoute({
      getParentRoute: () => frame,
      path: '/parts',
      component: lazyRouteComponent(() => import('./PartsPage'), 'PartsPage'),
    }),
  ])
}
