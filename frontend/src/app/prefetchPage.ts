import type { QueryClient } from '@tanstack/react-query'
import type { AnyRoute, AnyRouteMatch, AnyRouter, ParsedLocation } from '@tanstack/react-router'

import type { Session } from './session'

/** A page whose code is loaded when it is first shown. */
export interface Code {
  preload?: () => Promise<unknown> | undefined
}

/**
 * Ask for what the page of the address shows first, and load the page, beside the question of who is signed in.
 * Browsers send six requests at a time: the answers that everything waits for are asked for first.
 */
export function prefetchPage(router: AnyRouter, client: QueryClient, session: Session): void {
  const matches = router.matchRoutes(router.latestLocation as ParsedLocation)
  for (const { params, staticData } of matches) {
    staticData.prefetch?.(client, params as Record<string, string>, session)
  }
  loadCode(router, matches)
}

/** Load the code of pages that are likely opened next. Their data is asked for when they are opened. */
export function preloadPages(router: AnyRouter, paths: readonly string[]): void {
  for (const to of paths) {
    const { pathname } = router.buildLocation({ to })
    loadCode(router, router.matchRoutes(pathname, {}))
  }
}

function loadCode(router: AnyRouter, matches: readonly AnyRouteMatch[]): void {
  for (const { routeId, staticData } of matches) {
    const route = (router.routesById as Record<string, AnyRoute | undefined>)[routeId as string]
    for (const code of [route?.options.component as Code | undefined, staticData.preloads]) {
      code?.preload?.()?.catch(() => undefined) // the route loads it again, and says what is wrong
    }
  }
}
