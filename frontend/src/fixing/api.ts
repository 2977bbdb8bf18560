import { useQuery, useQueryClient } from '@tanstack/react-query'

import { get, post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Fix = Schemas['FixRead']
export type FixOffer = Schemas['FixOffer']
export type Repair = Schemas['RepairRead']
export type Spot = Schemas['SpotRead']
export type Shape = Schemas['ShapeRead']
export type Sounds = Schemas['TakeSoundsRead']
export type SoundBrief = Schemas['SoundBrief']

const POLL_MS = 700
/** What a fix changes elsewhere. */
const TOUCHED = [
  queryKeys.fixes.all,
  queryKeys.desk.all,
  queryKeys.delivery.all,
  queryKeys.deliveries.all,
  queryKeys.unmatched.all,
  queryKeys.progress.all,
  queryKeys.take.all,
  queryKeys.takeHistory.all,
  queryKeys.cueReview.all,
]

/** What a fix can do, or did, about a take; asked again while it is being made. */
export const fixQuery = queryById('/v1/takes/{take_id}/fix', queryKeys.fix, {
  refetchInterval: ({ state: { data } }) => (data?.state === 'making' ? POLL_MS : false),
})

export const useFix = (takeId: string) => useQuery(fixQuery(takeId))

/** What can be heard of a take, its fixed copy too; asked again while something is still being drawn. */
export const useSounds = (takeId: string, fix?: Fix) =>
  useQuery({
    queryKey: queryKeys.takeSounds(takeId),
    queryFn: () => get('/v1/takes/{take_id}/sounds', { take_id: takeId }),
    refetchInterval: ({ state: { data } }) =>
      data && (data.master.state === 'drawing' || (fix?.state === 'made' && data.fix === null)) ? POLL_MS : false,
  })

/** The takes of a project of which a fix would be enough. */
export const fixesQuery = queryById('/v1/projects/{project_id}/fixes', queryKeys.fixes)

/** Have the fixed copy made. */
export function useAskForFix(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => post('/v1/takes/{take_id}/fix', { take_id: takeId }),
    onSuccess: (fix) => {
      client.setQueryData(fixQuery(takeId).queryKey, fix)
    },
  })
}

/** Make the fixed copy a version; the result is shown even if the desk no longer shows its origin. */
export function useUseFix(takeId: string, onUsed: (take: Schemas['TakeRead']) => void) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => post('/v1/takes/{take_id}/fix/use', { take_id: takeId }),
    onSuccess: onUsed,
    onSettled: () => invalidate(client, queryKeys.fix(takeId), ...TOUCHED),
  })
}

const AT_ONCE = 3

/** Make the fixed copies of many takes versions; returns how many. Those done before a refusal stay done. */
export function useUseFixes() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (takeIds: readonly string[]) => {
      for (let at = 0; at < takeIds.length; at += AT_ONCE) {
        const some = takeIds.slice(at, at + AT_ONCE)
        await Promise.all(some.map((id) => post('/v1/takes/{take_id}/fix/use', { take_id: id })))
      }
      return takeIds.length
    },
    onSettled: () => invalidate(client, ...TOUCHED),
  })
}
