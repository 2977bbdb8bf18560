import { type QueryClient, queryOptions, useMutation, useQuery, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Mend = Schemas['MendRead']
export type MendOffer = Schemas['MendOffer']
export type Repair = Schemas['RepairRead']
export type Spot = Schemas['SpotRead']
export type Shape = Schemas['ShapeRead']
export type Sounds = Schemas['TakeSoundsRead']
export type SoundBrief = Schemas['SoundBrief']

const POLL_MS = 700
/** Where the answers that a mend touches are kept. */
const TOUCHED = [
  'mends',
  'desk',
  'delivery',
  'deliveries',
  'unmatched',
  'standing',
  'take',
  'take-history',
  'cue-review',
]

const ofTake = (takeId: string) => ({ params: { path: { take_id: takeId } } })

/** What a mend can do, or did, about a take; asked again while it is being made. */
export const mendQuery = (takeId: string) =>
  queryOptions({
    queryKey: ['mend', takeId],
    queryFn: () => answered(api.GET('/v1/takes/{take_id}/mend', ofTake(takeId))),
    refetchInterval: ({ state: { data } }) => (data?.state === 'making' ? POLL_MS : false),
  })

export const useMend = (takeId: string) => useQuery(mendQuery(takeId))

/** What can be heard of a take, its mended copy too; asked again while something is still being drawn. */
export const useSounds = (takeId: string, mend?: Mend) =>
  useQuery({
    queryKey: ['take-sounds', takeId],
    queryFn: () => answered(api.GET('/v1/takes/{take_id}/sounds', ofTake(takeId))),
    refetchInterval: ({ state: { data } }) =>
      data && (data.master.state === 'drawing' || (mend?.state === 'made' && data.mend === null)) ? POLL_MS : false,
  })

/** The takes of a project of which a mend would be enough. */
export const mendsQuery = (projectId: string) =>
  queryOptions({
    queryKey: ['mends', projectId],
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/mends', { params: { path: { project_id: projectId } } })),
  })

/** Have the mended copy made. */
export function useAskForMend(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.POST('/v1/takes/{take_id}/mend', ofTake(takeId))),
    onSuccess: (mend) => {
      client.setQueryData(mendQuery(takeId).queryKey, mend)
    },
  })
}

/** Make the mended copy a version; what it became is told even where the desk no longer shows what it came from. */
export function useUseMend(takeId: string, onUsed: (made: Schemas['TakeRead']) => void) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => answered(api.POST('/v1/takes/{take_id}/mend/use', ofTake(takeId))),
    onSuccess: onUsed,
    onSettled: () => refresh(client, takeId),
  })
}

async function refresh(client: QueryClient, takeId: string): Promise<void> {
  const touched = [mendQuery(takeId).queryKey, ...TOUCHED.map((key) => [key])]
  await Promise.all(touched.map((queryKey) => client.invalidateQueries({ queryKey })))
}
