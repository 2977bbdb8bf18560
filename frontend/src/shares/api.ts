import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

/** The filters of the list that the current person kept in a project. */
export const viewsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.savedViews(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/saved-views', { params: { path: { project_id: projectId } } })),
  })

export function useSaveView(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (view: { name: string; query: string }) =>
      answered(
        api.POST('/v1/projects/{project_id}/saved-views', {
          params: { path: { project_id: projectId } },
          body: { page: 'sound_list', ...view },
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.savedViews(projectId)),
  })
}

export function useDeleteView(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (viewId: string) =>
      answered(api.DELETE('/v1/saved-views/{saved_view_id}', { params: { path: { saved_view_id: viewId } } })),
    onSuccess: () => invalidate(client, queryKeys.savedViews(projectId)),
  })
}
