import { QueryClient } from '@tanstack/react-query'

import { boundCache } from './boundedCache'
import { ApiProblem } from './problem'

/** Asking again helps when nothing was answered or the server broke, never when it refused. */
export function worthAskingAgain(failures: number, error: unknown): boolean {
  const refused = error instanceof ApiProblem && error.status >= 400 && error.status < 500
  return !refused && failures < 2
}

export const queryClient = new QueryClient({
  defaultOptions: {
    queries: { retry: worthAskingAgain, staleTime: 10_000, refetchOnWindowFocus: true },
    // Without a line they are not put off in silence: the client refuses them at once, or keeps them and says so.
    mutations: { retry: false, networkMode: 'always' },
  },
})

boundCache(queryClient)
