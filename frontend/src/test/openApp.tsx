import { QueryClientProvider } from '@tanstack/react-query'
import { createMemoryHistory, createRouter, RouterProvider } from '@tanstack/react-router'

import { queryClient } from '@/api/queryClient'
import { router } from '@/app/router'

import { draw } from './draw'

/** Open the product at an address, as a browser would, with nothing remembered. */
export function openApp(path: string) {
  queryClient.clear()
  const app = createRouter({
    ...router.options,
    history: createMemoryHistory({ initialEntries: [path] }),
    scrollRestoration: false,
  })
  draw(
    <QueryClientProvider client={queryClient}>
      <RouterProvider router={app} />
    </QueryClientProvider>,
  )
  return {
    isLoaded: () => app.state.status === 'idle',
    at: () => app.state.location.pathname,
    search: () => app.state.location.search as Record<string, string>,
  }
}
