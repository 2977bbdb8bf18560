import { queryOptions } from '@tanstack/react-query'

import { ApiProblem, del, get, post, put, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { useAsyncJob } from '@/api/useAsyncJob'

type Schemas = components['schemas']
export type Take = Schemas['TakeDetail']
export type Check = Schemas['CheckRead']
export type Finding = Schemas['FindingRead']
export type Sounds = Schemas['TakeSoundsRead']
export type GameFile = Schemas['RenderSoundRead']
export type HistoryEntry = Schemas['HistoryEntry']
export type MasterExport = Schemas['MasterExportRead']
export type Bands = Schemas['BandsRead']
export type SourceBank = Schemas['SourceBankRead']
export type SourceFile = Schemas['SourceFileRead']

const POLL_MS = 1000

/** One delivered file; asked again while it is being checked. */
export const takeQuery = queryById('/v1/takes/{take_id}', queryKeys.take, {
  refetchInterval: ({ state: { data } }) => (data?.state === 'received' ? POLL_MS : false),
})

const UNDECIDED: readonly Take['state'][] = ['received', 'conforming', 'returned', 'unjudged']

/** Whether there is no verdict yet, so that it may be checked again. */
export const hasNoVerdict = ({ state }: Pick<Take, 'state'>): boolean => UNDECIDED.includes(state)

/** Whether it is being checked again with another dry stem, or without. */
export const isComparing = (check: Check): boolean => !check.is_newest_stem && hasNoVerdict(check)

/** What the newest check says of it, asked again while that is about to change; null before the first one. */
export const checkQuery = (take: Take) =>
  queryOptions({
    refetchInterval: ({ state: { data } }: { state: { data?: Check | null } }) =>
      data && isComparing(data) ? POLL_MS : false,
    queryKey: queryKeys.take(take.id, 'check', take.state, take.state_since),
    queryFn: async (): Promise<Check | null> => {
      try {
        return await get('/v1/takes/{take_id}/check', { take_id: take.id })
      } catch (refusal) {
        if (refusal instanceof ApiProblem && refusal.code === 'check-not-found') return null
        throw refusal
      }
    },
  })

/** Give a version its dry stem, which an upload into its delivery brought. */
export const giveDryStem = (takeId: string, uploadId: string) =>
  put('/v1/takes/{take_id}/dry-stem', { take_id: takeId }, { upload_id: uploadId })

export const useWithdrawDryStem = (takeId: string) =>
  useMutation({
    mutationFn: () => del('/v1/takes/{take_id}/dry-stem', { take_id: takeId }),
    affects: [queryKeys.take(takeId)],
  })

export const sourceBankQuery = queryById('/v1/takes/{take_id}/source-bank', (takeId) =>
  queryKeys.take(takeId, 'source-bank'),
)

/** Keep a file, which an upload into its delivery brought, in the source bank of a version. */
export const giveSourceFile = (takeId: string, uploadId: string) =>
  post('/v1/takes/{take_id}/source-files', { take_id: takeId }, { upload_id: uploadId })

export const useSetRecipe = (takeId: string) =>
  useMutation({
    mutationFn: (body: Schemas['RecipeSet']) => put('/v1/takes/{take_id}/source-bank', { take_id: takeId }, body),
    affects: [queryKeys.take(takeId, 'source-bank')],
  })

export const useRemoveSourceFile = (takeId: string) =>
  useMutation({
    mutationFn: (id: string) => del('/v1/source-files/{source_file_id}', { source_file_id: id }),
    affects: [queryKeys.take(takeId, 'source-bank')],
  })

/** How a version lies among the approved sounds; for the team. */
export const fitQuery = (take: Take) =>
  queryOptions({
    queryKey: queryKeys.take(take.id, 'fit', take.state_since),
    queryFn: () => get('/v1/takes/{take_id}/fit', { take_id: take.id }),
  })

export const deliveryFitQuery = queryById('/v1/deliveries/{delivery_id}/fit', queryKeys.deliveryFit)

/** The spectrum of a sound, in addition to its waveform; null if an earlier version drew it. */
export const bandsQuery = (peaksUrl: string | null) =>
  queryOptions({
    queryKey: queryKeys.bands(peaksUrl),
    queryFn: async (): Promise<Bands | null> => {
      const response = await fetch(peaksUrl ?? '', { credentials: 'same-origin' })
      if (!response.ok) return null
      return ((await response.json()) as Schemas['PeaksRead']).bands ?? null
    },
    enabled: peaksUrl !== null,
    staleTime: Infinity,
  })

/** Ask for a master with what is known of it written into it. */
export const useMasterExport = (takeId: string) =>
  useAsyncJob<void, MasterExport>(
    'master-export',
    () => post('/v1/takes/{take_id}/master-exports', { take_id: takeId }),
    (id) => get('/v1/master-exports/{master_export_id}', { master_export_id: id }),
  )
