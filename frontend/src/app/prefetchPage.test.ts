import {
  createMemoryHistory,
  createRootRoute,
  createRoute,
  createRouter,
  lazyRouteComponent,
} from '@tanstack/react-router'
import { describe, expect, test, vi } from 'vitest'

import { preloadPages } from './prefetchPage'

describe('the code of a page that is likely opened next', () => {
  test('is loaded with that of the page it leads to, and no data is asked for', () => {
    const loaded: string[] = []
    const page = (name: string) =>
      lazyRouteComponent(() => {
        loaded.push(name)
        return Promise.resolve({ default: () => null })
      })
    const asked = vi.fn()
    const getParentRoute = () => root
    const root = createRootRoute()
    const router = createRouter({
      history: createMemoryHistory(),
      routeTree: root.addChildren([
        createRoute({ getParentRoute, path: '/', component: page('home') }),
        createRoute({
          getParentRoute,
          path: '/projects/$projectId/review',
          component: page('start'),
          staticData: { prefetch: asked, preloads: page('cue') },
          beforeLoad: asked,
        }),
        createRoute({ getParentRoute, path: '/projects/$projectId/today', component: page('today') }),
      ]),
    })
    preloadPages(router, ['/projects/one/review'])
    expect(loaded).toEqual(['start', 'cue'])
    expect(asked).not.toHaveBeenCalled()
  })
})
