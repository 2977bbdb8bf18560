import { infiniteQueryOptions, queryOptions, useMutation, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Job = Schemas['JobRead']
export type JobState = Schemas['JobState']
export type JobCount = Schemas['JobCountRead']
export type Storage = Schemas['StorageRead']
export type Worker = Schemas['WorkerRead']

/** The whole server, or one studio by its id. */
export type Scope = 'server' | { studioId: string }

const ALIVE_MS = 5000

const keyOf = (scope: Scope) => (scope === 'server' ? 'server' : scope.studioId)
const ofStudio = (studioId: string) => ({ params: { path: { studio_id: studioId } } })

/** What both views show of jobs, storage and workers. */
export interface Operations {
  counts: JobCount[]
  storage: Storage[]
  /** How many worker processes live; an operator is shown each. */
  alive: number
  workers: Worker[]
}

const SILENT_AFTER_MS = 20_000

async function readServer(): Promise<Operations> {
  const { counts, storage, workers } = await answered(api.GET('/v1/operations'))
  const alive = workers.filter(({ beat_at }) => Date.now() - Date.parse(beat_at) < SILENT_AFTER_MS).length
  return { counts, storage, workers, alive }
}

async function readStudio(studioId: string): Promise<Operations> {
  const { counts, storage, workers } = await answered(api.GET('/v1/studios/{studio_id}/operations', ofStudio(studioId)))
  return { counts, storage: [storage], workers: [], alive: workers }
}

export const operationsQuery = (scope: Scope) =>
  queryOptions({
    queryKey: ['operations', keyOf(scope), 'sums'],
    queryFn: () => (scope === 'server' ? readServer() : readStudio(scope.studioId)),
    refetchInterval: ALIVE_MS,
  })

export const jobsQuery = (scope: Scope, state: JobState | undefined) =>
  infiniteQueryOptions({
    queryKey: ['operations', keyOf(scope), 'jobs', state],
    queryFn: ({ pageParam: cursor }) =>
      scope === 'server'
        ? answered(api.GET('/v1/operations/jobs', { params: { query: { state, cursor } } }))
        : answered(
            api.GET('/v1/studios/{studio_id}/jobs', {
              params: { path: { studio_id: scope.studioId }, query: { state, cursor } },
            }),
          ),
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
        ? answered(api.POST('/v1/operations/jobs/{job_id}/retry', { params: { path: { job_id: jobId } } }))
        : answered(
            api.POST('/v1/studios/{studio_id}/jobs/{job_id}/retry', {
              params: { path: { studio_id: scope.studioId, job_id: jobId } },
            }),
          ),
    onSettled: () => client.invalidateQueries({ queryKey: ['operations', keyOf(scope)] }),
  })
}
