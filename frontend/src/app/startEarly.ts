import type { QueryClient } from '@tanstack/react-query'
import type { AnyRoute, AnyRouter, ParsedLocation } from '@tanstack/react-router'

import type { Session } from './session'

interface Preloadable {
  preload?: () => Promise<unknown> | undefined
}

/**
 * Ask for what the page of the address shows first, and load the page, beside the question of who is signed in.
 * Browsers send six requests at a time: the answers that everything waits for are asked for first.
 */
export function startEarly(router: AnyRouter, client: QueryClient, session: Session): void {
  const matches = router.matchRoutes(router.latestLocation as ParsedLocation)
  for (const { params, staticData } of matches) {
    staticData.early?.(client, params as Record<string, string>, session)
  }
  for (const { routeId } of matches) {
    const route = (router.routesById as Record<string, AnyRoute | undefined>)[routeId as string]
    const component = route?.options.component as Preloadable | undefined
    component?.preload?.()?.catch(() => undefined) // the route loads it again, and says what is wrong
  }
}
