import { useQuery } from '@tanstack/react-query'

import { Button } from '@/ui/Button'
import { CopyButton } from '@/ui/CopyButton'
import { ago } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { StatusBadge } from '@/ui/StatusBadge'

import { mailedLinksQuery, useHandOverLink } from './api'

interface MailedLinkProps {
  projectId: string
  /** The invitation or the candidate that the link is for. */
  ofId: string
  recipient: string
}

/** How the mail with a person's link stands, and the link to hand over where there is no mail server. */
export function MailedLink({ projectId, ofId, recipient }: MailedLinkProps) {
  const { data } = useQuery(mailedLinksQuery(projectId))
  const handOver = useHandOverLink(projectId)
  if (data === undefined) return null
  const mail = data.links.find(({ of_id: id }) => id === ofId)
  if (mail === undefined || mail.state === 'waiting') return <StatusBadge kind="waiting">Email waiting</StatusBadge>
  if (mail.state === 'sent') {
    return <StatusBadge kind="passed">{mail.sent_at ? `Emailed ${ago(mail.sent_at)}` : 'Emailed'}</StatusBadge>
  }
  return (
    <span className="row wrap">
      {mail.state === 'failed' ? (
        <StatusBadge kind="not_sent" reason={mail.failure ?? undefined}>
          Email failed, is tried again
        </StatusBadge>
      ) : (
        <StatusBadge kind="warning">Not emailed: no mail server</StatusBadge>
      )}
      {mail.link && (
        <CopyButton text={mail.link} what="Link">
          <span>
            Copy link <span className="visually-hidden">{`for ${recipient}`}</span>
          </span>
        </CopyButton>
      )}
      {mail.state === 'failed' && mail.link === null && (
        <Button aria-busy={handOver.isPending} onClick={() => handOver.mutate(mail.mail_id)}>
          <span>
            Show link <span className="visually-hidden">{`for ${recipient}`}</span>
          </span>
        </Button>
      )}
      <Refusal error={handOver.error} />
    </span>
  )
}
