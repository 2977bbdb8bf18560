import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post } from './endpoint'
import { invalidate, queryKeys } from './queryKeys'
import { useMutation } from './useMutation'

/** What the answers of the brief ask of the delivery spec and it does not have. */
export const proposalQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.brief(projectId, 'spec'),
    queryFn: () => get('/v1/projects/{project_id}/brief/spec', { project_id: projectId }),
  })

/** Save what the answers ask for as a version of the spec. */
export function useApplyProposal(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: { based_on_version: number; brief_revision: number }) =>
      post('/v1/projects/{project_id}/brief/spec', { project_id: projectId }, body),
    onSuccess: () =>
      invalidate(
        client,
        queryKeys.brief(projectId, 'spec'),
        queryKeys.spec(projectId),
        queryKeys.specVersions(projectId),
        queryKeys.project(projectId),
      ),
  })
}
