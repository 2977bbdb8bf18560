import { post, queryById } from './endpoint'
import { queryKeys } from './queryKeys'
import { useMutation } from './useMutation'

/** What the answers of the brief ask of the delivery spec and it does not have. */
export const proposalQuery = queryById('/v1/projects/{project_id}/brief/spec', (projectId) =>
  queryKeys.brief(projectId, 'spec'),
)

/** Save what the answers ask for as a version of the spec. */
export const useApplyProposal = (projectId: string) =>
  useMutation({
    mutationFn: (body: { based_on_version: number; brief_revision: number }) =>
      post('/v1/projects/{project_id}/brief/spec', { project_id: projectId }, body),
    affects: [
      queryKeys.brief(projectId, 'spec'),
      queryKeys.spec(projectId),
      queryKeys.specVersions(projectId),
      queryKeys.project(projectId),
    ],
  })
