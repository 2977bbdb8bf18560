import { post, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'

/** How the mails stand by which a project invites. */
export const mailedLinksQuery = queryById('/v1/projects/{project_id}/mailed-links', queryKeys.mailedLinks, {
  // The worker writes and sends mails a moment after their event.
  refetchInterval: 3_000,
})

/** Show the link of a mail that the mail server refused, to be handed over. */
export const useHandOverLink = (projectId: string) =>
  useMutation({
    mutationFn: (mailId: string) => post('/v1/mails/{mail_id}/link', { mail_id: mailId }),
    affects: [queryKeys.mailedLinks(projectId)],
  })
