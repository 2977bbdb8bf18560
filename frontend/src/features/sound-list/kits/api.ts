import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import { type Cue, refreshList } from '../api'

export type Kit = components['schemas']['KitRead']
export type KitRow = components['schemas']['KitRow']

export const kitQuery = (projectId: string, key: string) =>
  queryOptions({
    queryKey: queryKeys.kit(projectId, key),
    queryFn: () => get('/v1/projects/{project_id}/kits/{kit_key}', { project_id: projectId, kit_key: key }),
  })

/** Removes what was just added, as long as nothing was done with it. */
export function useUndoAddition(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (cues: readonly Cue[]) =>
      post(
        '/v1/projects/{project_id}/cues/undo-addition',
        { project_id: projectId },
        { cue_ids: cues.map(({ id }) => id) },
      ),
    onSuccess: () => Promise.all([refreshList(client, projectId), invalidate(client, queryKeys.kit(projectId))]),
  })
}
