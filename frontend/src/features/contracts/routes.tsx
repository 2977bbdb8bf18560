import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute, shellRoute } from '@/app/roots'

const version = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isInteger(value) && value >= 1 ? value : undefined

export const contractRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts',
    component: lazyRouteComponent(() => import('./ContractsPage'), 'ContractsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId',
    component: lazyRouteComponent(() => import('./ContractPage'), 'ContractPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/draft',
    validateSearch: (search: Record<string, unknown>): { view?: 'text' } =>
      search.view === 'text' ? { view: 'text' } : {},
    component: lazyRouteComponent(() => import('./DraftPage'), 'DraftPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/redlines',
    component: lazyRouteComponent(() => import('./RedlinesPage'), 'RedlinesPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/compare',
    validateSearch: (search: Record<string, unknown>): { from?: number; to?: number } => ({
      from: version(search.from),
      to: version(search.to),
    }),
    component: lazyRouteComponent(() => import('./ComparePage'), 'ComparePage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/changes',
    component: lazyRouteComponent(() => import('./ChangeOrdersPage'), 'ChangeOrdersPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/ending',
    component: lazyRouteComponent(() => import('./EndingPage'), 'EndingPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/contracts/$contractId/record',
    component: lazyRouteComponent(() => import('./RecordPage'), 'RecordPage'),
  }),
] as const

export const verifyRoutes = [
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/verify',
    component: lazyRouteComponent(() => import('./VerifyPage'), 'VerifyPage'),
  }),
] as const
