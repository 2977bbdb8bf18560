import { useState } from 'react'

import { ApiProblem } from '@/api'
import { useRoles } from '@/api/roles'
import { ReplyField } from '@/judging/ReplyField'
import { ago } from '@/ui/format'
import { Person } from '@/ui/Person'
import { ProblemNote } from '@/ui/ProblemNote'

import { type CameBack, useReply } from './api'
import classes from './CameBack.module.css'

interface ConversationProps {
  projectId: string
  takeId: string
  noteId: string
  kind: 'change' | 'comment'
  /** Who wrote the note. */
  to: string
  replies: CameBack['comments']
}

/** What was answered to a note, and the way to answer it. */
export function Conversation({ projectId, takeId, noteId, kind, to, replies }: ConversationProps) {
  const [replying, setReplying] = useState(false)
  const reply = useReply(takeId)
  const roleOf = useRoles(projectId)
  const send = async (text: string) => {
    const answers = kind === 'change' ? { change_request_id: noteId } : { reply_to_id: noteId }
    await reply.mutateAsync({ text, ...answers })
  }
  return (
    <>
      {replies.length > 0 && (
        <ul className={classes.replies} aria-label={`Replies to ${to}`}>
          {replies.map((one) => (
            <li key={one.id}>
              <Person name={one.author.name} role={roleOf(one.author.id)} />{' '}
              <span className="small dim">{ago(one.created_at)}</span>
              <p>{one.text}</p>
            </li>
          ))}
        </ul>
      )}
      {replying ? (
        <ReplyField to={to} draftKey={`reply:${noteId}`} onSend={send} onClose={() => setReplying(false)} />
      ) : (
        <button type="button" className="link small mid" onClick={() => setReplying(true)}>
          Reply<span className="visually-hidden"> to {to}</span>
        </button>
      )}
      {reply.error instanceof ApiProblem && <ProblemNote detail={reply.error.detail} fix={reply.error.fix} />}
    </>
  )
}
