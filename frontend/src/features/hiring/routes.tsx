import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute, shellRoute } from '@/app/roots'

import { type RosterSearch, SERVICES } from './roster/words'

const text = (value: unknown): string | undefined =>
  // "12" in an address is read as a number.
  (typeof value === 'string' && value !== '') || typeof value === 'number' ? String(value) : undefined

export const hiringRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/roster',
    validateSearch: (search: Record<string, unknown>): RosterSearch => ({
      studio: text(search.studio),
      q: text(search.q),
      speciality: text(search.speciality),
      service: SERVICES.find((service) => service === search.service),
      language: text(search.language),
      from: text(search.from),
      to: text(search.to),
    }),
    component: lazyRouteComponent(() => import('./roster/RosterPage'), 'RosterPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/roster/import',
    validateSearch: (search: Record<string, unknown>): { studio?: string } => ({ studio: text(search.studio) }),
    component: lazyRouteComponent(() => import('./roster/RosterImportPage'), 'RosterImportPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/roster/$entryId',
    component: lazyRouteComponent(() => import('./roster/EntryPage'), 'EntryPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/work',
    component: lazyRouteComponent(() => import('./roster/OwnWorkPage'), 'OwnWorkPage'),
  }),
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
