import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute, shellRoute } from '@/app/roots'

export const hiringRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/postings',
    component: lazyRouteComponent(() => import('./PostingsPage'), 'PostingsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/postings/$postingId',
    component: lazyRouteComponent(() => import('./PostingPage'), 'PostingPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/postings/$postingId/bids',
    component: lazyRouteComponent(() => import('./BidsPage'), 'BidsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/postings/$postingId',
    component: lazyRouteComponent(() => import('./BidPage'), 'BidPage'),
  }),
] as const

export const postingLinkRoutes = [
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/posting/$secret',
    component: lazyRouteComponent(() => import('./PostingLinkPage'), 'PostingLinkPage'),
  }),
] as const
