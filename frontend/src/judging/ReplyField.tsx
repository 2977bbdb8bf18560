import { useState } from 'react'

import { useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import classes from './ReplyField.module.css'

interface ReplyFieldProps {
  /** Who wrote the note. */
  to: string
  draftKey: string
  /** Rejects where the server refuses; what was typed stays then. */
  onSend: (text: string) => Promise<void>
  onClose: () => void
}

/** One line to answer a note with; Enter sends. */
export function ReplyField({ to, draftKey, onSend, onClose }: ReplyFieldProps) {
  const [text, setText, draft] = useDraft(draftKey, '')
  const [sending, setSending] = useState(false)
  const field = useFocusOnMount<HTMLInputElement>(true)
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
    <div className={classes.reply}>
      <input
        ref={field}
        aria-label={`Reply to ${to}`}
        placeholder={`Reply to ${to}`}
        maxLength={10_000}
        value={text}
        onChange={(event) => setText(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === 'Enter' && !event.nativeEvent.isComposing) void send()
          else if (event.key === 'Escape') {
            event.stopPropagation()
            onClose()
          }
        }}
      />
      <Button disabled={sending || text.trim() === ''} onClick={() => void send()}>
        Send
      </Button>
    </div>
  )
}
