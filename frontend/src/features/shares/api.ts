import { infiniteQueryOptions, queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, everyPage, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type GuestLink = Schemas['GuestLinkRead']
export type GuestLinkAdd = Pick<Schemas['GuestLinkAdd'], 'kind' | 'title'> & Partial<Schemas['GuestLinkAdd']>
export type GuestVisit = Schemas['GuestVisitRead']
export type GuestRoom = Schemas['GuestRoom']
export type GuestSound = Schemas['GuestSoundRead']
export type Playlist = Schemas['PlaylistRead']
export type PlaylistTake = Schemas['PlaylistTake']
export type Live = Schemas['LiveRead']

/** The cues that can be shared or put in a playlist. */
export const cuesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'to choose from', 'to share'),
    queryFn: async () => {
      const pages = await everyPage((cursor) =>
        answered(
          api.GET('/v1/projects/{project_id}/sound-list', {
            params: { path: { project_id: projectId }, query: { cursor, limit: 500 } },
          }),
        ),
      )
      return pages
        .flatMap(({ cues }) => cues)
        .filter(({ state }) => state !== 'cut')
        .map(({ id, label, name, category }) => ({ id, label, name, category }))
    },
  })

export const linksQuery = (projectId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.guestLinks(projectId),
    queryFn: ({ pageParam: cursor }) =>
      answered(
        api.GET('/v1/projects/{project_id}/guest-links', {
          params: { path: { project_id: projectId }, query: { cursor } },
        }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

export const visitsQuery = (linkId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.guestLinks('visits', linkId),
    queryFn: ({ pageParam: cursor }) =>
      answered(
        api.GET('/v1/guest-links/{guest_link_id}/visits', {
          params: { path: { guest_link_id: linkId }, query: { cursor } },
        }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

export function useAddLink(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: GuestLinkAdd) =>
      answered(
        api.POST('/v1/projects/{project_id}/guest-links', {
          params: { path: { project_id: projectId } },
          body: body as Schemas['GuestLinkAdd'],
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.guestLinks(projectId)),
  })
}

export function useChangeLink(projectId: string, linkId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Partial<Schemas['GuestLinkChange']>) =>
      answered(
        api.PATCH('/v1/guest-links/{guest_link_id}', {
          params: { path: { guest_link_id: linkId } },
          body: body as Schemas['GuestLinkChange'],
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.guestLinks(projectId)),
  })
}

export function useRevokeLink(projectId: string, linkId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () =>
      answered(api.POST('/v1/guest-links/{guest_link_id}/revoke', { params: { path: { guest_link_id: linkId } } })),
    onSuccess: () => invalidate(client, queryKeys.guestLinks(projectId)),
  })
}

/** The address of a link that the current person made. */
export const readAddress = async (linkId: string): Promise<string> =>
  (await answered(api.GET('/v1/guest-links/{guest_link_id}/address', { params: { path: { guest_link_id: linkId } } })))
    .url

export const playlistsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.playlists(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/playlists', { params: { path: { project_id: projectId } } })),
  })

export function useAddPlaylist(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: { name: string; cue_ids: string[] }) =>
      answered(
        api.POST('/v1/projects/{project_id}/playlists', {
          params: { path: { project_id: projectId } },
          body: { ...body, take_ids: [] },
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.playlists(projectId)),
  })
}

export const playlistQuery = (playlistId: string) =>
  queryOptions({
    queryKey: queryKeys.playlist(playlistId),
    queryFn: () => answered(api.GET('/v1/playlists/{playlist_id}', { params: { path: { playlist_id: playlistId } } })),
  })

/** Rename a playlist, or put its versions in another order: at once on the screen, as it was where it is refused. */
export function useChangePlaylist(playlistId: string) {
  const client = useQueryClient()
  const queryKey = queryKeys.playlist(playlistId)
  return useMutation({
    scope: { id: `playlist ${playlistId}` }, // one after the other, each with the edition of the one before
    mutationFn: (changes: { name?: string; take_ids?: string[] }) =>
      answered(
        api.PATCH('/v1/playlists/{playlist_id}', {
          params: { path: { playlist_id: playlistId } },
          body: {
            edition: client.getQueryData<Playlist>(queryKey)?.edition ?? 0,
            ...changes,
          } as Schemas['PlaylistChange'],
        }),
      ),
    onMutate: ({ name, take_ids: order }) => {
      client.setQueryData<Playlist>(
        queryKey,
        (now) => now && { ...now, name: name ?? now.name, takes: inOrder(now.takes, order) },
      )
    },
    onSuccess: (changed) => {
      client.setQueryData<Playlist>(
        queryKey,
        (now) =>
          now && {
            ...changed,
            takes: inOrder(
              changed.takes,
              now.takes.map(({ take_id }) => take_id),
            ),
          },
      )
      return invalidate(client, queryKeys.playlists.all)
    },
    onError: () => invalidate(client, queryKey),
  })
}

const inOrder = (takes: PlaylistTake[], order?: readonly string[]): PlaylistTake[] =>
  order === undefined ? takes : order.flatMap((id) => takes.find(({ take_id }) => take_id === id) ?? [])

export function useRemovePlaylist(projectId: string, playlistId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () =>
      answered(api.DELETE('/v1/playlists/{playlist_id}', { params: { path: { playlist_id: playlistId } } })),
    onSuccess: () => invalidate(client, queryKeys.playlists(projectId)),
  })
}

export const savePosition = (playlistId: string, takeId: string, atS: number) =>
  answered(
    api.PUT('/v1/playlists/{playlist_id}/position', {
      params: { path: { playlist_id: playlistId } },
      body: { take_id: takeId, at_s: atS },
    }),
  )

/** Which of a person's pages it is. */
interface OnPage {
  page_id: string
}

const live = (playlistId: string) => ({ params: { path: { playlist_id: playlistId } } })

export const readLive = (playlistId: string, pageId: string) =>
  answered(
    api.GET('/v1/playlists/{playlist_id}/live', {
      params: { path: { playlist_id: playlistId }, query: { page_id: pageId } },
    }),
  )

export const reportPresence = (playlistId: string, body: Omit<Schemas['LiveReport'], 'page_id'> & OnPage) =>
  answered(api.PUT('/v1/playlists/{playlist_id}/live/presence', { ...live(playlistId), body }))

export const movePlayhead = (playlistId: string, body: Schemas['LiveMove'] & OnPage) =>
  answered(api.PUT('/v1/playlists/{playlist_id}/live/playhead', { ...live(playlistId), body }))

export const passKeys = (playlistId: string, body: { act: 'take' | 'give' | 'drop'; person_id?: string } & OnPage) =>
  answered(api.PUT('/v1/playlists/{playlist_id}/live/keys', { ...live(playlistId), body }))

export const doorQuery = (secret: string) =>
  queryOptions({
    queryKey: queryKeys.guestAccess(secret),
    queryFn: () => answered(api.GET('/v1/guest-access/{secret}', { params: { path: { secret } } })),
    retry: false,
  })

export const openLink = (secret: string, body: { guest_name: string; password: string | null }) =>
  answered(api.POST('/v1/guest-access/{secret}/visits', { params: { path: { secret } }, body }))

export const roomQuery = (visit: string) =>
  queryOptions({
    queryKey: queryKeys.guestRoom(visit),
    queryFn: () => answered(api.GET('/v1/guest-visits/{secret}', { params: { path: { secret: visit } } })),
    retry: false,
    // A copy for guests takes a moment to be made.
    refetchInterval: ({ state }) => (state.data?.sounds.some(({ is_ready }) => !is_ready) ? 3_000 : false),
  })

export const recordPlay = (visit: string, place: number) =>
  answered(api.POST('/v1/guest-visits/{secret}/sounds/{place}/plays', { params: { path: { secret: visit, place } } }))

export const sendGuestComment = (visit: string, place: number, text: string, startS: number | null) =>
  answered(
    api.POST('/v1/guest-visits/{secret}/sounds/{place}/comments', {
      params: { path: { secret: visit, place } },
      body: { text, start_s: startS },
    }),
  )
