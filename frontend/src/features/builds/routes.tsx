import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

const text = (value: unknown): string | undefined => (typeof value === 'string' && value !== '' ? value : undefined)
const seconds = (value: unknown): number | undefined => {
  const s = typeof value === 'string' ? Number(value) : value
  return typeof s === 'number' && Number.isFinite(s) && s >= 0 ? s : undefined
}

export const buildRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/drift',
    validateSearch: (search: Record<string, unknown>): { audit?: string } => ({ audit: text(search.audit) }),
    staticData: { keepsFocus: true },
    component: lazyRouteComponent(() => import('./DriftPage'), 'DriftPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/listening',
    component: lazyRouteComponent(() => import('./ListeningPage'), 'ListeningPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/recording',
    validateSearch: (search: Record<string, unknown>): { recording?: string; at?: number } => ({
      recording: text(search.recording),
      at: seconds(search.at),
    }),
    component: lazyRouteComponent(() => import('./RecordingPage'), 'RecordingPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/libraries',
    component: lazyRouteComponent(() => import('./LibrariesPage'), 'LibrariesPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/game-tasks',
    component: lazyRouteComponent(() => import('./TasksPage'), 'TasksPage'),
  }),
]
