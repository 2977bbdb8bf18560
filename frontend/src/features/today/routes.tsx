import { createRoute, lazyRouteComponent, redirect } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'
import { meQuery } from '@/judging/api'

/** Where one starts: Today of the first project one works on for its team, the desk for a designer. */
const start = {
  getParentRoute: () => shellRoute,
  beforeLoad: async ({ context }: { context: { queryClient: import('@tanstack/react-query').QueryClient } }) => {
    const me = await context.queryClient.ensureQueryData(meQuery)
    const own = me.projects.find(({ part }) => part === 'team')
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
    component: lazyRouteComponent(() => import('./TodayPage'), 'TodayPage'),
  }),
]
