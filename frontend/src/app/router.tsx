import type { QueryClient } from '@tanstack/react-query'
import { createRouter } from '@tanstack/react-router'

import { queryClient } from '@/api/queryClient'
import { accountGuestRoutes, accountRoutes } from '@/features/accounts/routes'
import { createSession } from '@/features/accounts/session'
import { adoptionRoutes } from '@/features/adoption/routes'
import { briefRoutes } from '@/features/brief/routes'
import { buildRoutes } from '@/features/builds/routes'
import { checkRoutes } from '@/features/checks/routes'
import { contractRoutes, verifyRoutes } from '@/features/contracts/routes'
import { deliveryRoutes } from '@/features/deliveries/routes'
import { deskRoutes } from '@/features/desk/routes'
import { erasureRoutes } from '@/features/erasure/routes'
import { gameFilesRoutes } from '@/features/game-files/routes'
import { hiringRoutes, postingLinkRoutes } from '@/features/hiring/routes'
import { invitationRoutes } from '@/features/invitation/routes'
import { moneyRoutes } from '@/features/money/routes'
import { noticeRoutes } from '@/features/notices/routes'
import { operationRoutes } from '@/features/operations/routes'
import { projectRoutes } from '@/features/projects/routes'
import { referenceRoutes } from '@/features/references/routes'
import { reviewRoutes } from '@/features/review/routes'
import { kitRoutes } from '@/features/sound-list/kits/routes'
import { listenRoutes, shareRoutes } from '@/features/shares/routes'
import { soundListRoutes } from '@/features/sound-list/routes'
import { takeRoutes } from '@/features/take/routes'
import { todayRoutes } from '@/features/today/routes'
import { voiceLineRoutes } from '@/features/voice-lines/routes'
import { webhookRoutes } from '@/features/webhooks/routes'
import { partsRoute } from '@/parts/routes'
import { PageSkeleton } from '@/ui/Skeleton'

import { ErrorPage } from './ErrorPage'
import { NotFoundPage } from './NotFoundPage'
import { guestRoute, notFoundRoute, rootRoute, shellRoute } from './roots'
import type { Session } from './session'
import type { Code } from './prefetchPage'

const pages = [
  guestRoute.addChildren([
    ...accountGuestRoutes,
    ...invitationRoutes,
    ...postingLinkRoutes,
    ...listenRoutes,
    ...checkRoutes,
    ...verifyRoutes,
  ]),
  shellRoute.addChildren([
    ...todayRoutes,
    ...projectRoutes,
    ...briefRoutes,
    ...referenceRoutes,
    ...voiceLineRoutes,
    ...hiringRoutes,
    ...moneyRoutes,
    ...gameFilesRoutes,
    ...buildRoutes,
    ...reviewRoutes,
    ...shareRoutes,
    ...soundListRoutes,
    ...kitRoutes,
    ...adoptionRoutes,
    ...deskRoutes,
    ...contractRoutes,
    ...deliveryRoutes,
    ...takeRoutes,
    ...accountRoutes,
    ...operationRoutes,
    ...erasureRoutes,
    ...noticeRoutes,
    ...webhookRoutes,
    notFoundRoute,
  ]),
] as const
const routeTree = rootRoute.addChildren(pages)
// For those who build: in development and test builds only, and unknown to the types of the product.
if (import.meta.env.DEV || import.meta.env.MODE === 'test') rootRoute.addChildren([...pages, partsRoute()])

export const router = createRouter({
  routeTree,
  context: { queryClient, session: createSession(queryClient) },
  defaultPreload: 'intent',
  defaultPreloadStaleTime: 0,
  defaultErrorComponent: ErrorPage,
  // What waits shows it after 300 ms: until then the page before it stays.
  defaultPendingComponent: PageSkeleton,
  defaultPendingMs: 300,
  defaultPendingMinMs: 0,
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
    /** Asks for what the page shows first, as soon as the address is known. What is refused is asked for again by the page. */
    prefetch?: (client: QueryClient, params: Record<string, string>, session: Session) => void
    /** The page that this one opens at once. */
    preloads?: Code
  }
}
