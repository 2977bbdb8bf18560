import { queryOptions } from '@tanstack/react-query'

import { answered, api } from '@/api'
import { queryKeys } from '@/api/queryKeys'

/** How the mails stand by which a project invites. */
export const mailedLinksQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.mailedLinks(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/mailed-links', { params: { path: { project_id: projectId } } })),
    // The worker writes and sends mails a moment after their event.
    refetchInterval: 3_000,
  })
