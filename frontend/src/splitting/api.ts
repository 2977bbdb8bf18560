import { useQuery, useQueryClient } from '@tanstack/react-query'

import { post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Split = Schemas['SplitRead']
export type SplitPart = Schemas['SplitPartRead']
export type SplitOffer = Schemas['SplitOffer']
export type SplitUse = Schemas['SplitUse']

const POLL_MS = 700
/** What a split changes elsewhere. */
const TOUCHED = [
  queryKeys.splits.all,
  queryKeys.desk.all,
  queryKeys.delivery.all,
  queryKeys.deliveries.all,
  queryKeys.unmatched.all,
  queryKeys.undecidedFiles.all,
  queryKeys.progress.all,
  queryKeys.soundList.all,
  queryKeys.take.all,
  queryKeys.takeHistory.all,
  queryKeys.cueReview.all,
]

/** The parts of a file, and what became of them; asked again while they are being found. */
const splitQuery = queryById('/v1/takes/{take_id}/split', queryKeys.split, {
  refetchInterval: ({ state: { data } }) => (data?.state === 'making' ? POLL_MS : false),
})

export const useSplit = (takeId: string) => useQuery(splitQuery(takeId))

/** The files of a project that hold several sounds. */
export const splitsQuery = queryById('/v1/projects/{project_id}/splits', queryKeys.splits)

/** Have the parts of a file found. */
export function useFindParts(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (shortestPauseS: number) =>
      post('/v1/takes/{take_id}/split', { take_id: takeId }, { shortest_pause_s: shortestPauseS }),
    onSuccess: (split) => {
      client.setQueryData(splitQuery(takeId).queryKey, split)
    },
  })
}

/** Make the parts variations. */
export function useUseSplit(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (use: SplitUse) => post('/v1/takes/{take_id}/split/use', { take_id: takeId }, use),
    onSettled: () => invalidate(client, queryKeys.split(takeId), ...TOUCHED),
  })
}

/** Take the parts back, and the file to where it was. */
export function useUndoSplit(takeId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (actionId: string) => post('/v1/tray-actions/{tray_action_id}/undo', { tray_action_id: actionId }),
    onSettled: () => invalidate(client, queryKeys.split(takeId), ...TOUCHED),
  })
}
