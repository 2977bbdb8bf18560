import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { shellRoute } from '@/app/roots'

import { STATES, VIEWS, type LinesSearch } from './search'

const text = (value: unknown): string | undefined => (typeof value === 'string' && value !== '' ? value : undefined)
const oneOf = <T extends string>(known: readonly T[], value: unknown): T | undefined =>
  known.find((option) => option === value)

export const voiceLineRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/voice-lines',
    validateSearch: (search: Record<string, unknown>): LinesSearch => ({
      view: oneOf(VIEWS, search.view),
      language: text(search.language),
      state: oneOf(STATES, search.state),
      character: text(search.character),
      search: text(search.search),
    }),
    component: lazyRouteComponent(() => import('./VoiceLinesPage'), 'VoiceLinesPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/voice-lines/import',
    component: lazyRouteComponent(() => import('./ScriptPage'), 'ScriptPage'),
  }),
]
