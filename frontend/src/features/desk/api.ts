import { keepPreviousData, type QueryClient, queryOptions, useQuery, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, everyPage, get, patch, post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { keptCuesQuery } from '@/api/soundList'
import type { components } from '@/api/schema.gen'
import { deskQuery } from '@/app/desk'
import { mentionsOf } from '@/verdicts/mentionNames'
import type { Accepts } from '@/uploads'

import { acceptedFiles } from './accepted'

type Schemas = components['schemas']
export type Desk = Schemas['Desk']
export type CameBack = Schemas['CameBack']
export type ToMake = Schemas['ToMake']
export type AskedQuestion = Schemas['AskedQuestion']
export type Finding = Schemas['FindingRead']
export type Take = Schemas['TakeRead']
export type TakeAdded = Schemas['TakeAdded']
export type Guess = Schemas['CueGuess']
export type Delivery = Schemas['DeliveryRead']
export type DeliveryDetail = Schemas['DeliveryDetail']
export type Archive = Schemas['ArchiveRead']
export type DryStem = Schemas['DryStemRead']
export type TakeSounds = Schemas['TakeSoundsRead']
export type Cue = Schemas['CueRead']
export type Thumb = Schemas['ThumbRead']

/** A change that was asked for, and where in the sound. */
export interface Change {
  id: string
  text: string
  start_s: number | null
  end_s: number | null
}

const POLL_MS = 1000
/** Asking for a thousand rows every second would keep the server from checking them. */
const SLOW_POLL_MS = 4000
/** For each file in the answer: a thousand take the server a second to write. */
const POLL_MS_EACH = 10
/** A file that has no picture after so long could not be read as a sound. */
const DRAWN_WITHIN_MS = 60_000

/** What the check returned is on the desk at once; its picture follows. */
const isBeingDrawn = ({ preview_url, since }: CameBack): boolean =>
  preview_url === null && Date.now() - Date.parse(since) < DRAWN_WITHIN_MS

export const useDesk = (projectId: string) =>
  useQuery({
    ...deskQuery(projectId),
    refetchInterval: ({ state: { data } }) =>
      data && (data.checking > 0 || data.came_back.some(isBeingDrawn))
        ? Math.max(POLL_MS, POLL_MS_EACH * data.checking)
        : false,
  })

/** The delivery that files go into now: the newest one that is not closed. */
export const openDeliveryQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.deliveries(projectId),
    queryFn: async () => {
      const { items } = await get('/v1/projects/{project_id}/deliveries', { project_id: projectId, limit: 1 })
      const newest = items[0]
      return newest && newest.closed_at === null ? newest : null
    },
  })

export const openDelivery = (projectId: string): Promise<Delivery> =>
  post('/v1/projects/{project_id}/deliveries', { project_id: projectId }, { note: '' })

const isMoving = (detail: DeliveryDetail): boolean =>
  detail.takes.some(({ state }) => state === 'received') || detail.archives.some(({ state }) => state === 'received')

export const deliveryQuery = queryById('/v1/deliveries/{delivery_id}', queryKeys.delivery)

export const useDelivery = (deliveryId: string | undefined) =>
  useQuery({
    ...deliveryQuery(deliveryId ?? ''),
    enabled: deliveryId !== undefined,
    refetchInterval: ({ state: { data } }) =>
      data && isMoving(data) ? Math.max(POLL_MS, POLL_MS_EACH * data.takes.length) : false,
  })

export const addTake = (deliveryId: string, body: Schemas['TakeAdd']) =>
  post('/v1/deliveries/{delivery_id}/takes', { delivery_id: deliveryId }, body)

/** Send a small file; its take is made by the same request. */
export const addFile = (
  deliveryId: string,
  file: File,
  query: { file_name: string; cue_id: string | null; received_name?: string },
  signal: AbortSignal,
) =>
  unwrap(
    api.POST('/v1/deliveries/{delivery_id}/files', {
      params: { path: { delivery_id: deliveryId }, query: { ...query, cue_id: query.cue_id ?? undefined } },
      headers: { 'Content-Type': 'application/octet-stream' },
      body: file as unknown as string, // how OpenAPI's `binary` is typed
      bodySerializer: (body: unknown) => body as BodyInit,
      signal,
    }),
  )

export const addArchive = (deliveryId: string, body: Schemas['ArchiveAdd']) =>
  post('/v1/deliveries/{delivery_id}/archives', { delivery_id: deliveryId }, body)

export function useSaveNote(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ deliveryId, note }: { deliveryId: string; note: string }) =>
      patch('/v1/deliveries/{delivery_id}', { delivery_id: deliveryId }, { note }),
    onSuccess: (saved) => {
      client.setQueryData(openDeliveryQuery(projectId).queryKey, saved)
      void invalidate(client, queryKeys.delivery(saved.id))
    },
  })
}

export const useCloseDelivery = (projectId: string) =>
  useMutation({
    mutationFn: (deliveryId: string) => post('/v1/deliveries/{delivery_id}/close', { delivery_id: deliveryId }),
    affects: [queryKeys.deliveries(projectId)],
  })

/**
 * Files that wait in the tray, all of them: what is selected or accepted at once must be here.
 * They are read again when the desk counts others, so that list and count are never apart for long.
 */
export const unmatchedQuery = (projectId: string, count: number) =>
  queryOptions({
    queryKey: queryKeys.unmatched(projectId, count),
    queryFn: () =>
      everyPage((cursor) =>
        get('/v1/projects/{project_id}/takes', { project_id: projectId, unmatched: true, limit: 200, cursor }),
      ).then((pages) => pages.flatMap(({ items }) => items)),
  })

export const useUnmatched = (projectId: string, count: number) =>
  useQuery({ ...unmatchedQuery(projectId, count), placeholderData: keepPreviousData })

export type UndecidedPlace = Schemas['UndecidedPlace']

/** Sounds for which one delivery has several files between which nobody chose. */
export const useUndecidedFiles = (projectId: string) =>
  useQuery({
    queryKey: queryKeys.undecidedFiles(projectId),
    queryFn: () => get('/v1/projects/{project_id}/takes/undecided', { project_id: projectId }),
  })

export type TrayAction = Schemas['TrayActionRead']
export type Move = Schemas['TakeMove']

/** What is done to many files at once; each answers the action, which can be undone. */
export type TrayWork =
  { what: 'accept'; takeIds: string[] } | { what: 'discard'; takeIds: string[] } | { what: 'move'; moves: Move[] }

const runTrayWork = (projectId: string, work: TrayWork): Promise<TrayAction> => {
  switch (work.what) {
    case 'accept':
      return post('/v1/projects/{project_id}/takes/accept-sure', { project_id: projectId }, { take_ids: work.takeIds })
    case 'discard':
      return post('/v1/projects/{project_id}/takes/discard', { project_id: projectId }, { take_ids: work.takeIds })
    case 'move':
      return post('/v1/projects/{project_id}/takes/move', { project_id: projectId }, { moves: work.moves })
  }
}

export function useTrayWork(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (work: TrayWork) => runTrayWork(projectId, work),
    onSettled: () => refresh(client, projectId),
  })
}

/** Undo an action; takes changed since stay as they are. */
export function useUndo(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (action: TrayAction) => post('/v1/tray-actions/{tray_action_id}/undo', { tray_action_id: action.id }),
    onSettled: () => refresh(client, projectId),
  })
}

export function useRecheck(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (takeId: string) => post('/v1/takes/{take_id}/recheck', { take_id: takeId }),
    onSettled: () => refresh(client, projectId),
  })
}

/** Answer what was said of a take. */
export function useReply(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (said: { text: string; reply_to_id?: string; change_request_id?: string }) =>
      post(
        '/v1/takes/{take_id}/comments',
        { take_id: takeId },
        { ...said, mentions: await mentionsOf(client, takeId, said.text) },
      ),
    affects: [queryKeys.desk.all],
  })
}

/** Say that the designer has seen a comment on their sound. */
export function useAcknowledge() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (commentId: string) => post('/v1/comments/{comment_id}/acknowledgement', { comment_id: commentId }),
    onSettled: () => invalidate(client, queryKeys.desk.all),
  })
}

/** What can be seen and heard of one take, once it was checked; asked again while it is being drawn. */
export const useSounds = ({ id, state }: Pick<Take, 'id' | 'state'>) =>
  useQuery({
    queryKey: queryKeys.takeSounds(id),
    queryFn: () => get('/v1/takes/{take_id}/sounds', { take_id: id }),
    enabled: state !== 'received',
    refetchInterval: ({ state: { data } }) => (data?.master.state === 'drawing' ? SLOW_POLL_MS : false),
  })

export const useCues = (projectId: string, enabled = true) => useQuery({ ...keptCuesQuery(projectId), enabled })

/** What kinds of file some category of the spec takes: only what none takes is stopped in the browser. */
export const acceptedFilesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.acceptedFiles(projectId),
    queryFn: async (): Promise<Accepts> => {
      const { tables } = await get('/v1/projects/{project_id}/spec', { project_id: projectId })
      return acceptedFiles(tables)
    },
    staleTime: 60_000,
  })

export const useAsk = (projectId: string) =>
  useMutation({
    mutationFn: ({ cueId, text }: { cueId: string; text: string }) =>
      post('/v1/cues/{cue_id}/questions', { cue_id: cueId }, { text, blocks: false }),
    affects: [queryKeys.desk(projectId), queryKeys.soundList(projectId)],
  })

/** Refetch everything that an arriving or matched file changes. */
export const refresh = (client: QueryClient, projectId: string) =>
  invalidate(
    client,
    queryKeys.desk(projectId),
    queryKeys.deliveries(projectId),
    queryKeys.unmatched(projectId),
    queryKeys.undecidedFiles(projectId),
    queryKeys.splits(projectId),
    queryKeys.delivery.all,
    queryKeys.progress(projectId),
    queryKeys.soundList(projectId),
  )
