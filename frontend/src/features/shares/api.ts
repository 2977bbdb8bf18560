import { infiniteQueryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, patch, post, put, queryById, useMutation } from '@/api'
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

export const linksQuery = (projectId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.guestLinks(projectId),
    queryFn: ({ pageParam: cursor }) => get('/v1/projects/{project_id}/guest-links', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

export const visitsQuery = (linkId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.guestLinks('visits', linkId),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/guest-links/{guest_link_id}/visits', { guest_link_id: linkId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

export const useAddLink = (projectId: string) =>
  useMutation({
    mutationFn: (body: GuestLinkAdd) =>
      post('/v1/projects/{project_id}/guest-links', { project_id: projectId }, body as Schemas['GuestLinkAdd']),
    affects: [queryKeys.guestLinks(projectId)],
  })

export const useChangeLink = (projectId: string, linkId: string) =>
  useMutation({
    mutationFn: (body: Partial<Schemas['GuestLinkChange']>) =>
      patch('/v1/guest-links/{guest_link_id}', { guest_link_id: linkId }, body as Schemas['GuestLinkChange']),
    affects: [queryKeys.guestLinks(projectId)],
  })

export const useRevokeLink = (projectId: string, linkId: string) =>
  useMutation({
    mutationFn: () => post('/v1/guest-links/{guest_link_id}/revoke', { guest_link_id: linkId }),
    affects: [queryKeys.guestLinks(projectId)],
  })

/** The address of a link that the current person made. */
export const readAddress = async (linkId: string): Promise<string> =>
  (await get('/v1/guest-links/{guest_link_id}/address', { guest_link_id: linkId })).url

export const useAddPlaylist = (projectId: string) =>
  useMutation({
    mutationFn: (body: { name: string; cue_ids: string[] }) =>
      post('/v1/projects/{project_id}/playlists', { project_id: projectId }, { ...body, take_ids: [] }),
    affects: [queryKeys.playlists(projectId)],
  })

export const playlistQuery = queryById('/v1/playlists/{playlist_id}', queryKeys.playlist)

/** Rename a playlist, or put its versions in another order: at once on the screen, as it was where it is refused. */
export function useChangePlaylist(playlistId: string) {
  const client = useQueryClient()
  const queryKey = queryKeys.playlist(playlistId)
  return useMutation({
    scope: { id: `playlist ${playlistId}` }, // one after the other, each with the edition of the one before
    mutationFn: (changes: { name?: string; take_ids?: string[] }) =>
      patch('/v1/playlists/{playlist_id}', { playlist_id: playlistId }, {
        edition: client.getQueryData<Playlist>(queryKey)?.edition ?? 0,
        ...changes,
      } as Schemas['PlaylistChange']),
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

export const useRemovePlaylist = (projectId: string, playlistId: string) =>
  useMutation({
    mutationFn: () => del('/v1/playlists/{playlist_id}', { playlist_id: playlistId }),
    affects: [queryKeys.playlists(projectId)],
  })

export const savePosition = (playlistId: string, takeId: string, atS: number) =>
  put('/v1/playlists/{playlist_id}/position', { playlist_id: playlistId }, { take_id: takeId, at_s: atS })

/** Which of a person's pages it is. */
interface OnPage {
  page_id: string
}

export const readLive = (playlistId: string, pageId: string) =>
  get('/v1/playlists/{playlist_id}/live', { playlist_id: playlistId, page_id: pageId })

export const reportPresence = (playlistId: string, body: Omit<Schemas['LiveReport'], 'page_id'> & OnPage) =>
  put('/v1/playlists/{playlist_id}/live/presence', { playlist_id: playlistId }, body)

export const movePlayhead = (playlistId: string, body: Schemas['LiveMove'] & OnPage) =>
  put('/v1/playlists/{playlist_id}/live/playhead', { playlist_id: playlistId }, body)

export const passKeys = (playlistId: string, body: { act: 'take' | 'give' | 'drop'; person_id?: string } & OnPage) =>
  put('/v1/playlists/{playlist_id}/live/keys', { playlist_id: playlistId }, body)

export const doorQuery = queryById('/v1/guest-access/{secret}', queryKeys.guestAccess, {
  retry: false,
})

export const openLink = (secret: string, body: { guest_name: string; password: string | null }) =>
  post('/v1/guest-access/{secret}/visits', { secret }, body)

export const roomQuery = queryById('/v1/guest-visits/{secret}', queryKeys.guestRoom, {
  retry: false,
  // A copy for guests takes a moment to be made.
  refetchInterval: ({ state }) => (state.data?.sounds.some(({ is_ready }) => !is_ready) ? 3_000 : false),
})

export const recordPlay = (visit: string, place: number) =>
  post('/v1/guest-visits/{secret}/sounds/{place}/plays', { secret: visit, place })

export const sendGuestComment = (visit: string, place: number, text: string, startS: number | null) =>
  post('/v1/guest-visits/{secret}/sounds/{place}/comments', { secret: visit, place }, { text, start_s: startS })
