import { useState } from 'react'

import { useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { Mentions } from './Mentions'
import { SendField } from './SendField'
import classes from './ReplyField.module.css'

interface ReplyFieldProps {
  /** The version that it is about. */
  takeId: string
  /** Who wrote the note. */
  to: string
  draftKey: string
  /** Rejects where the server refuses; what was typed stays then. */
  onSend: (text: string) => Promise<void>
  onClose: () => void
}

/** What a note is answered with; Enter sends. */
export function ReplyField({ takeId, to, draftKey, onSend, onClose }: ReplyFieldProps) {
  const [text, setText, draft] = useDraft(draftKey, '')
  const [sending, setSending] = useState(false)
  const field = useFocusOnMount<HTMLTextAreaElement>(true)
  const send = async () => {
    if (text.trim() === '' || sending) return
    setSending(true)
    try {
      await onSend(text.trim())
      draft.discard()
      onClose()
    } catch {
      field.current?.focus() // the refusal stands where the notes are
    } finally {
      setSending(false)
    }
  }
  return (
    <div>
      <div className={`flex gap-2 mt-1 ${classes.reply}`}>
        <SendField
          ref={field}
          aria-label={`Reply to ${to}`}
          placeholder={`Reply to ${to}`}
          value={text}
          onText={setText}
          onSend={() => void send()}
          onLeave={onClose}
        />
        <Button disabled={sending || text.trim() === ''} onClick={() => void send()}>
          Send
        </Button>
      </div>
      <Mentions takeId={takeId} field={field} text={text} onText={setText} />
    </div>
  )
}
