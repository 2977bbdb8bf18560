import { queryOptions } from '@tanstack/react-query'

import { del, get, post, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type ViewedPage = components['schemas']['ViewedPage']

/** The filters of a page that the current person kept in a project, or that the team shares. */
export const viewsQuery = (projectId: string, page: ViewedPage) =>
  queryOptions({
    queryKey: queryKeys.savedViews(projectId),
    queryFn: () => get('/v1/projects/{project_id}/saved-views', { project_id: projectId }),
    select: (views) => views.filter((view) => view.page === page),
  })

export const useSaveView = (projectId: string, page: ViewedPage) =>
  useMutation({
    mutationFn: (view: { name: string; query: string }) =>
      post('/v1/projects/{project_id}/saved-views', { project_id: projectId }, { page, ...view }),
    affects: [queryKeys.savedViews(projectId)],
  })

export const useDeleteView = (projectId: string) =>
  useMutation({
    mutationFn: (viewId: string) => del('/v1/saved-views/{saved_view_id}', { saved_view_id: viewId }),
    affects: [queryKeys.savedViews(projectId)],
  })
