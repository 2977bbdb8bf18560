import type { QueryClient } from '@tanstack/react-query'
import { createRoute, lazyRouteComponent, redirect } from '@tanstack/react-router'

import { meQuery } from '@/api/me'
import { lastProject } from '@/app/lastProject'
import { nextStepsQuery } from '@/app/nextSteps'
import { shellRoute } from '@/app/roots'
import { queueQuery } from '@/verdicts/api'

import { todayQuery } from './api'

/** Where one starts: Today of the project that was open last, or of the first one, the desk for a designer. */
const start = {
  getParentRoute: () => shellRoute,
  beforeLoad: async ({ context }: { context: { queryClient: QueryClient } }) => {
    const me = await context.queryClient.ensureQueryData(meQuery)
    const teams = me.projects.filter(({ part }) => part === 'team')
    const own = teams.find(({ id }) => id === lastProject()) ?? teams[0]
    if (own) throw redirect({ to: '/projects/$projectId/today', params: { projectId: own.id }, replace: true })
    throw redirect({ href: me.projects.length > 0 ? '/desk' : '/projects', replace: true })
  },
}

export const todayRoutes = [
  createRoute({ ...start, path: '/' }),
  createRoute({ ...start, path: '/today' }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/today',
    staticData: {
      prefetch: (client, { projectId = '' }) => {
        void client.prefetchInfiniteQuery(queueQuery(projectId))
        void client.prefetchQuery(todayQuery(projectId))
        void client.prefetchQuery(nextStepsQuery(projectId))
      },
    },
    component: lazyRouteComponent(() => import('./TodayPage'), 'TodayPage'),
  }),
] as const
