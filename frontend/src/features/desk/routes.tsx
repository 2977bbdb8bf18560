import { createRoute, lazyRouteComponent, redirect } from '@tanstack/react-router'

import { meQuery } from '@/api/me'
import { deskQuery } from '@/app/desk'
import { lastProject } from '@/app/lastProject'
import { nextStepsQuery } from '@/app/nextSteps'
import { shellRoute } from '@/app/roots'

export const deskRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/desk',
    beforeLoad: async ({ context }) => {
      const { projects } = await context.queryClient.ensureQueryData(meQuery)
      const mine = projects.filter(({ part }) => part === 'designer')
      const project = mine.find(({ id }) => id === lastProject()) ?? mine[0]
      if (project) throw redirect({ to: '/projects/$projectId/desk', params: { projectId: project.id }, replace: true })
    },
    component: lazyRouteComponent(() => import('./NoDeskPage'), 'NoDeskPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/desk',
    staticData: {
      prefetch: (client, { projectId = '' }) => {
        void client.prefetchQuery(deskQuery(projectId))
        void client.prefetchQuery(nextStepsQuery(projectId))
      },
    },
    component: lazyRouteComponent(() => import('./DeskPage'), 'DeskPage'),
  }),
]
