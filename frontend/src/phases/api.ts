import { useQueryClient } from '@tanstack/react-query'

import { post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

/** The phases of the production that have cues, in order. */
export const phasesQuery = queryById('/v1/projects/{project_id}/phases', queryKeys.phases)

export function useApprovePalette(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => post('/v1/projects/{project_id}/palette-approval', { project_id: projectId }),
    onSettled: () => invalidate(client, queryKeys.phases(projectId)),
  })
}
