import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

/** How the mails stand by which a project invites. */
export const mailedLinksQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.mailedLinks(projectId),
    queryFn: () => get('/v1/projects/{project_id}/mailed-links', { project_id: projectId }),
    // The worker writes and sends mails a moment after their event.
    refetchInterval: 3_000,
  })

/** Show the link of a mail that the mail server refused, to be handed over. */
export function useHandOverLink(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (mailId: string) => post('/v1/mails/{mail_id}/link', { mail_id: mailId }),
    onSuccess: () => invalidate(client, queryKeys.mailedLinks(projectId)),
  })
}
