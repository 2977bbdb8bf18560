import { infiniteQueryOptions, queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Job = Schemas['JobRead']
export type JobState = Schemas['JobState']
export type JobCount = Schemas['JobCountRead']
export type Lane = Schemas['LaneRead']
export type Storage = Schemas['StorageRead']
export type Quota = Schemas['QuotaRead']
export type Worker = Schemas['WorkerRead']
export type Scrub = Schemas['ScrubRead']

/** The whole server, or one studio by its id. */
export type Scope = 'server' | { studioId: string }

const ALIVE_MS = 5000
const KEPT_FOR_MS = 60_000

const keyOf = (scope: Scope) => (scope === 'server' ? 'server' : scope.studioId)

/** What both views show of jobs and workers. */
export interface Operations {
  counts: JobCount[]
  lanes: Lane[]
  /** How many worker processes live; an operator is shown each. */
  alive: number
  workers: Worker[]
}

async function readServer(): Promise<Operations> {
  const { counts, lanes, workers } = await get('/v1/operations')
  return { counts, lanes, workers, alive: workers.filter(({ is_alive }) => is_alive).length }
}

async function readStudio(studioId: string): Promise<Operations> {
  const { counts, lanes, workers } = await get('/v1/studios/{studio_id}/operations', { studio_id: studioId })
  return { counts, lanes, workers: [], alive: workers }
}

/** What is kept; for an operator also the free disk, where one bounds it, and the newest pass over all files. */
export interface Kept {
  studios: Storage[]
  freeBytes: number | null
  scrub: Scrub | null
}

async function readKept(scope: Scope): Promise<Kept> {
  if (scope !== 'server') {
    return {
      studios: [await get('/v1/studios/{studio_id}/storage', { studio_id: scope.studioId })],
      freeBytes: null,
      scrub: null,
    }
  }
  const { studios, free_bytes, scrub } = await get('/v1/operations/storage')
  return { studios, freeBytes: free_bytes, scrub }
}

/** Summed up over everything delivered, so asked for once a visit and not every few seconds. */
export const keptQuery = (scope: Scope) =>
  queryOptions({
    queryKey: queryKeys.operations(keyOf(scope), 'kept'),
    queryFn: () => readKept(scope),
    staleTime: KEPT_FOR_MS,
  })

/** What a studio uses of its limits, the nearest first. */
export interface Limits {
  studioId: string
  studioName: string
  quotas: Quota[]
}

async function readLimits(
  scope: Scope,
  cursor: string | undefined,
): Promise<{ items: Limits[]; next?: string | null }> {
  if (scope !== 'server') {
    const quotas = await get('/v1/studios/{studio_id}/quotas', { studio_id: scope.studioId })
    const nearestFirst = [...quotas].sort((a, b) => share(b) - share(a))
    return { items: [{ studioId: scope.studioId, studioName: '', quotas: nearestFirst }] }
  }
  const { items, next } = await get('/v1/operations/quotas', { cursor })
  return {
    items: items.map(({ studio_id, studio_name, quotas }) => ({
      studioId: studio_id,
      studioName: studio_name,
      quotas,
    })),
    next,
  }
}

/** How much of a limit is used; 1 is all of it. */
export const share = ({ used, limit }: Quota): number => (limit === 0 ? Infinity : used / limit)

export const limitsQuery = (scope: Scope) =>
  infiniteQueryOptions({
    queryKey: queryKeys.operations(keyOf(scope), 'limits'),
    queryFn: ({ pageParam: cursor }) => readLimits(scope, cursor),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    staleTime: KEPT_FOR_MS,
  })

export const operationsQuery = (scope: Scope) =>
  queryOptions({
    queryKey: queryKeys.operations(keyOf(scope), 'sums'),
    queryFn: () => (scope === 'server' ? readServer() : readStudio(scope.studioId)),
    refetchInterval: ALIVE_MS,
  })

export const jobsQuery = (scope: Scope, state: JobState | undefined) =>
  infiniteQueryOptions({
    queryKey: queryKeys.operations(keyOf(scope), 'jobs', state),
    queryFn: ({ pageParam: cursor }) =>
      scope === 'server'
        ? get('/v1/operations/jobs', { state, cursor })
        : get('/v1/studios/{studio_id}/jobs', { studio_id: scope.studioId, state, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    refetchInterval: ALIVE_MS,
  })

/** Let a job run again that gave up. */
export function useRetry(scope: Scope) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (jobId: string) =>
      scope === 'server'
        ? post('/v1/operations/jobs/{job_id}/retry', { job_id: jobId })
        : post('/v1/studios/{studio_id}/jobs/{job_id}/retry', { studio_id: scope.studioId, job_id: jobId }),
    onSettled: () =>
      invalidate(client, queryKeys.operations(keyOf(scope), 'sums'), queryKeys.operations(keyOf(scope), 'jobs')),
  })
}
