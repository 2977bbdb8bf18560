import type { QueryClient } from '@tanstack/react-query'
import { createRootRouteWithContext, createRoute } from '@tanstack/react-router'

import { ErrorPage } from './ErrorPage'
import { NotFoundPage } from './NotFoundPage'
import type { Session } from './session'
import { GuestFrame } from './shell/GuestFrame'
import { Root } from './shell/Root'
import { Shell } from './shell/Shell'

export interface RouterContext {
  queryClient: QueryClient
  session: Session
}

export const rootRoute = createRootRouteWithContext<RouterContext>()({
  component: Root,
  notFoundComponent: NotFoundPage,
})

/** Parent of every page for people who are signed in: top bar, tabs, palette. */
export const shellRoute = createRoute({
  getParentRoute: () => rootRoute,
  id: 'shell',
  beforeLoad: ({ context, location }) => context.session.ensureSignedIn(location.href),
  component: Shell,
  errorComponent: ErrorPage,
})

/** Parent of the pages before an account: sign-in, sign-up, an invitation. */
export const guestRoute = createRoute({
  getParentRoute: () => rootRoute,
  id: 'guest',
  component: GuestFrame,
  errorComponent: ErrorPage,
})
