import type { QueryClient } from '@tanstack/react-query'
import { createRoute, lazyRouteComponent, redirect } from '@tanstack/react-router'

import { meQuery } from '@/api/me'
import { shellRoute } from '@/app/roots'

const version = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isInteger(value) && value >= 1 ? value : undefined

/** A person who may open projects and sees none begins by opening one. */
async function beginWithOne({ context }: { context: { queryClient: QueryClient } }): Promise<void> {
  const me = await context.queryClient.ensureQueryData(meQuery)
  if (me.projects.length > 0 || !me.studios.some(({ roles }) => roles.includes('producer'))) return
  throw redirect({ href: '/projects/new', replace: true })
}

export const projectRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects',
    beforeLoad: beginWithOne,
    component: lazyRouteComponent(() => import('./ProjectsPage'), 'ProjectsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/new',
    component: lazyRouteComponent(() => import('./NewProjectPage'), 'NewProjectPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId',
    component: lazyRouteComponent(() => import('./ProjectPage'), 'ProjectPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/progress',
    component: lazyRouteComponent(() => import('./ProgressPage'), 'ProgressPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/activity',
    component: lazyRouteComponent(() => import('./ActivityPage'), 'ActivityPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/settings',
    component: lazyRouteComponent(() => import('./SettingsPage'), 'SettingsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/approvers',
    component: lazyRouteComponent(() => import('./ApprovalPages'), 'ApproversPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/approval',
    component: lazyRouteComponent(() => import('./ApprovalPages'), 'ApprovalPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/tokens',
    component: lazyRouteComponent(() => import('./TokensPage'), 'TokensPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/people',
    component: lazyRouteComponent(() => import('./PeoplePage'), 'PeoplePage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/credits',
    component: lazyRouteComponent(() => import('./CreditsPage'), 'CreditsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/hours',
    component: lazyRouteComponent(() => import('./HoursPage'), 'HoursPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/builds',
    component: lazyRouteComponent(() => import('./BuildsPage'), 'BuildsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/spec',
    validateSearch: (search: Record<string, unknown>): { view?: 'all' } =>
      search.view === 'all' ? { view: 'all' } : {},
    component: lazyRouteComponent(() => import('./spec/SpecPage'), 'SpecPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/spec/versions',
    validateSearch: (search: Record<string, unknown>): { version?: number; against?: number } => ({
      version: version(search.version),
      against: version(search.against),
    }),
    component: lazyRouteComponent(() => import('./spec/VersionsPage'), 'VersionsPage'),
  }),
] as const
