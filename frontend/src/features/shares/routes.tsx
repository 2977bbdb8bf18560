import { createRoute, lazyRouteComponent } from '@tanstack/react-router'

import { guestRoute, shellRoute } from '@/app/roots'

interface Chosen {
  /** The cue to share. */
  cue?: string
  /** The playlist to share. */
  playlist?: string
}

const id = (value: unknown): string | undefined => (typeof value === 'string' && value !== '' ? value : undefined)

export const shareRoutes = [
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/sharing',
    validateSearch: (search: Record<string, unknown>): Chosen => ({
      cue: id(search.cue),
      playlist: id(search.playlist),
    }),
    component: lazyRouteComponent(() => import('./SharingPage'), 'SharingPage'),
  }),
  createRoute({
    getParentRoute: () => shellRoute,
    path: '/projects/$projectId/playlists/$playlistId',
    component: lazyRouteComponent(() => import('./PlaylistPage'), 'PlaylistPage'),
  }),
] as const

export const listenRoutes = [
  createRoute({
    getParentRoute: () => guestRoute,
    path: '/listen/$secret',
    component: lazyRouteComponent(() => import('./ListenPage'), 'ListenPage'),
  }),
] as const
