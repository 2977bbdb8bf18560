import type { QueryClient } from '@tanstack/react-query'
import { createRootRouteWithContext, createRoute, type ErrorComponentProps } from '@tanstack/react-router'

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
  notFoundComponent: () => (
    <GuestFrame>
      <NotFoundPage />
    </GuestFrame>
  ),
  errorComponent: BrokenFrame,
})

function BrokenFrame(props: ErrorComponentProps) {
  return (
    <GuestFrame>
      <ErrorPage {...props} />
    </GuestFrame>
  )
}

/** Parent of every page for people who are signed in: top bar, tabs, palette. */
export const shellRoute = createRoute({
  getParentRoute: () => rootRoute,
  id: 'shell',
  staticData: { prefetch: (_client, _params, session) => session.prefetchPerson?.() },
  beforeLoad: ({ context, location }) => context.session.ensureSignedIn(location.href),
  component: SignedInShell,
  errorComponent: BrokenFrame,
})

function SignedInShell() {
  return <Shell session={shellRoute.useRouteContext().session} />
}

/** An address that no feature knows, within the frame, so that every way on stays. */
export const notFoundRoute = createRoute({ getParentRoute: () => shellRoute, path: '$', component: NotFoundPage })

/** Parent of the pages before an account: sign-in, sign-up, an invitation. */
export const guestRoute = createRoute({
  getParentRoute: () => rootRoute,
  id: 'guest',
  component: () => <GuestFrame />,
  errorComponent: BrokenFrame,
})
