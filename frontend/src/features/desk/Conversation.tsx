import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { meQuery } from '@/api/me'
import { useRoles } from '@/api/roles'
import { MentionedText } from '@/verdicts/MentionedText'
import { ReplyField } from '@/verdicts/ReplyField'
import { Refusal } from '@/ui/Refusal'
import { ago } from '@/ui/format'
import { Person } from '@/ui/Person'

import { type CameBack, useAcknowledge, useReply } from './api'
import classes from './CameBack.module.css'

interface ConversationProps {
  projectId: string
  takeId: string
  noteId: string
  kind: 'change' | 'comment'
  /** Who wrote the note. */
  to: string
  replies: CameBack['comments']
  /** The comment that is answered, to be acknowledged. */
  comment?: CameBack['comments'][number]
}

/** What was answered to a note, and the way to answer it. */
export function Conversation({ projectId, takeId, noteId, kind, to, replies, comment }: ConversationProps) {
  const [replying, setReplying] = useState(false)
  const reply = useReply(takeId)
  const roleOf = useRoles(projectId)
  const seen = useAcknowledge()
  const { data: me } = useQuery(meQuery)
  const isDue = comment !== undefined && !comment.acknowledgements.some(({ person }) => person.id === me?.person.id)
  const send = async (text: string) => {
    const answers = kind === 'change' ? { change_request_id: noteId } : { reply_to_id: noteId }
    await reply.mutateAsync({ text, ...answers })
  }
  return (
    <>
      {replies.length > 0 && (
        <ul className={`grid gap-1 mt-1 ${classes.replies}`} aria-label={`Replies to ${to}`}>
          {replies.map((one) => (
            <li key={one.id}>
              <Person name={one.author.name} picture={one.author.picture} role={roleOf(one.author.id)} />{' '}
              <span className="small dim">{ago(one.created_at)}</span>
              <p>
                <MentionedText text={one.text} mentions={one.mentions} />
              </p>
            </li>
          ))}
        </ul>
      )}
      {replying ? (
        <ReplyField
          takeId={takeId}
          to={to}
          draftKey={`reply:${noteId}`}
          onSend={send}
          onClose={() => setReplying(false)}
        />
      ) : (
        <p className="row">
          <button type="button" className="link small mid" onClick={() => setReplying(true)}>
            Reply<span className="visually-hidden"> to {to}</span>
          </button>
          {isDue && (
            <button type="button" className="link small mid" onClick={() => seen.mutate(comment.id)}>
              Seen<span className="visually-hidden">: what {to} said</span>
            </button>
          )}
          {comment && !isDue && <span className="small dim">Seen</span>}
        </p>
      )}
      <Refusal error={seen.error} />
      <Refusal error={reply.error} />
    </>
  )
}
