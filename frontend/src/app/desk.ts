import { queryOptions } from '@tanstack/react-query'

import { answered, api } from '@/api'

/** A designer's work in one project: the desk shows it, and its tab counts what came back. */
export const deskQuery = (projectId: string) =>
  queryOptions({
    queryKey: ['desk', projectId],
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/desk', { params: { path: { project_id: projectId } } })),
  })
