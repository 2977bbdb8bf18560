import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'
import { EmptyState } from '@/ui/EmptyState'
import { age } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Mail, useOutbox, useSendMail } from './api'
import { CardProblem } from './CardProblem'
import classes from './Studio.module.css'

/** The studio's mails: those that wait first, without a mail server each with its link to copy. */
export function OutboxCard({ studioId }: { studioId: string }) {
  const { data: outbox, error } = useOutbox(studioId, true)
  const send = useSendMail(studioId)
  const waiting = outbox?.mails.filter(({ sent_at }) => sent_at === null).length ?? 0
  return (
    <Card aria-labelledby="outbox">
      <CardHead
        id="outbox"
        title="Sent emails"
        count={waiting > 0 ? waiting : undefined}
        note={
          outbox === undefined
            ? undefined
            : outbox.can_send
              ? 'only recipients see the links'
              : 'no mail server is set up: copy the links and send them yourself'
        }
      />
      <CardProblem error={error ?? send.error} />
      {outbox?.mails.length === 0 && (
        <div className="p-inset">
          <EmptyState head="No emails yet." level={3}>
            Invitations, decisions and answers sent by email are listed here.
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Emails" className={classes.mails}>
        {outbox?.mails.map((mail) => (
          <MailRow
            key={mail.id}
            mail={mail}
            canSend={outbox.can_send}
            onSend={() => send.mutate(mail.id, { onSuccess: () => showToast('Sending the email again.') })}
          />
        ))}
      </Rows>
    </Card>
  )
}

function MailRow({ mail, canSend, onSend }: { mail: Mail; canSend: boolean; onSend: () => void }) {
  const { recipient, subject, text, link, created_at, sent_at, failure } = mail
  return (
    <Row className={classes.mailRow}>
      <details className="grow">
        <summary>
          <span className="strong">{subject}</span>{' '}
          <span className="small mid wrap-anywhere">
            to {recipient}, {sent_at ? `sent, ${age(sent_at)}` : `written, ${age(created_at)}`}
          </span>
        </summary>
        <pre className={`bg-well wrap-anywhere p-3 pre-wrap font-inherit rounded ${classes.text}`}>{text}</pre>
      </details>
      {failure !== null && sent_at === null && <StatusBadge kind="not_sent" reason={failure} />}
      {sent_at !== null && <StatusBadge kind="passed">Sent</StatusBadge>}
      {sent_at === null && failure === null && <StatusBadge kind="waiting" />}
      {link !== null && sent_at === null && (
        <CopyButton text={link} what="Link" variant="quiet" aria-label={`Copy link of “${subject}” to ${recipient}`}>
          Copy link
        </CopyButton>
      )}
      {failure !== null && canSend && sent_at === null && <Button onClick={onSend}>Try again</Button>}
    </Row>
  )
}
