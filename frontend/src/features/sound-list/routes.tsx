import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

import { readPersonFilter } from './people'
import type { ListSearch } from './rows'
import { PHASES } from '@/phases'
import { NEEDS, STATUS_ORDER } from './words'

interface CompareSearch {
  from?: number
  to?: number
}

const revision = (value: unknown): number | undefined =>
  typeof value === 'number' && Number.isInteger(value) && value >= 0 ? value : undefined

export const soundListRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list',
    validateSearch: ({
      state,
      category,
      need,
      phase,
      person,
      by,
      view,
      unclear,
      heard,
      q,
    }: Record<string, unknown>): ListSearch => ({
      state: STATUS_ORDER.find((status) => status === state),
      category: typeof category === 'string' && category !== '' ? category : undefined,
      need: NEEDS.find(({ value }) => value === need)?.value,
      phase: PHASES.find(({ value }) => value === phase)?.value,
      person: readPersonFilter(person),
      view: view === 'content' ? view : undefined,
      by: by === 'category' || by === 'state' || by === 'priority' ? by : undefined,
      unclear: unclear === true ? true : undefined,
      heard: heard === 'no' ? heard : undefined,
      // "12" in an address is read as a number.
      q: typeof q === 'string' || typeof q === 'number' ? String(q) : undefined,
    }),
    component: lazyRouteComponent(() => import('./list/SoundListPage'), 'SoundListPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list/import',
    component: lazyRouteComponent(() => import('./import/ImportPage'), 'ImportPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list/columns',
    component: lazyRouteComponent(() => import('./columns/ColumnsPage'), 'ColumnsPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list/compare',
    validateSearch: ({ from, to }: Record<string, unknown>): CompareSearch => ({
      from: revision(from),
      to: revision(to),
    }),
    component: lazyRouteComponent(() => import('./compare/ComparePage'), 'ComparePage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sound-list/cues/$cueId',
    staticData: { keepsFocus: true },
    component: lazyRouteComponent(() => import('./cue/CuePage'), 'CuePage'),
  }),
] as const
