import { queryOptions, useInfiniteQuery, useQuery, useQueryClient } from '@tanstack/react-query'

import { get, post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Target = Schemas['TargetMemory']
export type Preset = Schemas['PresetRead']
export type Memory = Schemas['MemoryRead']
export type Batch = Schemas['BatchSummary']
export type BatchSizes = Schemas['BatchSizes']
export type SealedPack = Schemas['SealedPackSummary']
export type Changes = Schemas['PackChanges']
export type Handoff = Schemas['Handoff']
export type Register = Schemas['PlaceholderRegister']
export type Placeholder = Schemas['PlaceholderRead']

const POLL_MS = 1_000
const open = ({ state }: Batch): boolean => state === 'planning' || state === 'running'

export const targetsQuery = queryById('/v1/projects/{project_id}/targets', queryKeys.targets)

// Batches

export const useBatches = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.batches(projectId),
    queryFn: ({ pageParam: cursor }) => get('/v1/projects/{project_id}/batches', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    refetchInterval: ({ state: { data } }) => (data?.pages[0]?.items.some(open) ? POLL_MS : false),
  })

/** One batch with its sizes; refetched at each progress. */
export const useBatch = (batch: Batch) =>
  useQuery({
    queryKey: queryKeys.batch(batch.id, batch.state, batch.waiting),
    queryFn: () => get('/v1/batches/{batch_id}', { batch_id: batch.id }),
    staleTime: Infinity,
    placeholderData: (before) => before,
  })

function useBatchAct<Asked>(projectId: string, act: (asked: Asked) => Promise<unknown>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: act,
    onSettled: () => invalidate(client, queryKeys.batches(projectId)),
  })
}

export const useBeginBatch = (projectId: string) =>
  useBatchAct(projectId, (targets: string[]) =>
    post('/v1/projects/{project_id}/batches', { project_id: projectId }, { targets }),
  )

export const useCancelBatch = (projectId: string) =>
  useBatchAct(projectId, (batchId: string) => post('/v1/batches/{batch_id}/cancel', { batch_id: batchId }))

// Packs

export const packQuery = (projectId: string, target: string) =>
  queryOptions({
    queryKey: queryKeys.packs(projectId, target),
    queryFn: () => get('/v1/projects/{project_id}/pack', { project_id: projectId, target }),
  })

export const useSealedPacks = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.sealedPacks(projectId),
    queryFn: ({ pageParam: cursor }) => get('/v1/projects/{project_id}/packs', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    refetchInterval: ({ state: { data } }) =>
      data?.pages[0]?.items.some(({ state }) => state === 'sealing') ? POLL_MS : false,
  })

export const useSealedPack = (packId: string, enabled: boolean) =>
  useQuery({
    queryKey: queryKeys.sealedPack(packId),
    queryFn: () => get('/v1/packs/{pack_id}', { pack_id: packId }),
    enabled,
    staleTime: Infinity,
  })

export function useSealPack(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['PackAdd']) => post('/v1/projects/{project_id}/packs', { project_id: projectId }, body),
    onSettled: () => invalidate(client, queryKeys.sealedPacks(projectId), queryKeys.packs(projectId)),
  })
}

// Placeholders

const toMake = ({ items }: Register): number =>
  items.filter(({ state }) => state === 'missing' || state === 'outdated').length

/** What is still a placeholder; read again while placeholder files are being made. */
export const useRegister = (projectId: string, target: string | undefined, isMaking: boolean) =>
  useQuery({
    queryKey: queryKeys.placeholders(projectId, target),
    queryFn: () => get('/v1/projects/{project_id}/placeholders', { project_id: projectId, target }),
    placeholderData: (before) => before,
    refetchInterval: ({ state: { data } }) => (isMaking && data && toMake(data) > 0 ? POLL_MS : false),
    select: (register) => ({ ...register, toMake: toMake(register) }),
  })

export function useMakePlaceholders(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (target: string) =>
      post('/v1/projects/{project_id}/placeholders', { project_id: projectId }, { target }),
    onSettled: () => invalidate(client, queryKeys.placeholders(projectId)),
  })
}
