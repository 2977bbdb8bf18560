import { type Dispatch, type SetStateAction, useLayoutEffect, useRef } from 'react'

import { DraftNote, keepDraft } from '@/app/drafts'
import type { CueReview, ReviewTake } from '@/verdicts/api'
import { Mentions } from '@/verdicts/Mentions'
import { SendField } from '@/verdicts/SendField'
import { capital } from '@/verdicts/words'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { place, range } from '@/ui/format'

import type { useComment } from './api'
import classes from './Side.module.css'

/** A comment that is being written, and where in the sound it stands. */
export interface Writing {
  text: string
  startS: number
  endS?: number
  isRestored?: boolean
}

interface ComposerProps {
  review: CueReview
  hand: ReviewTake
  writing: Writing
  onWriting: Dispatch<SetStateAction<Writing | null>>
  comment: ReturnType<typeof useComment>
}

/** Where a comment is written, once it is asked for; it is kept as a draft. */
export function Composer({ review, hand, writing, onWriting, comment }: ComposerProps) {
  const field = useRef<HTMLTextAreaElement>(null)
  // Before the next key: continued typing must not decide anything.
  useLayoutEffect(() => {
    field.current?.focus()
    field.current?.setSelectionRange(field.current.value.length, field.current.value.length)
  }, [])
  const { text } = writing
  const draftKey = `comment:${review.cue.id}`
  const where = whereWords(writing)
  const send = () => {
    if (text.trim() === '' || comment.isPending) return
    const isPoint = writing.startS > 0 || writing.endS !== undefined
    const body = {
      takeId: hand.id,
      text: text.trim(),
      startS: isPoint ? writing.startS : undefined,
      endS: writing.endS,
    }
    // The next cue may be open by the time it is sent.
    comment.mutateAsync(body).then(
      () => {
        keepDraft(draftKey, null)
        onWriting((now) => (now === writing ? null : now))
      },
      () => field.current?.focus(),
    )
    field.current?.blur() // the next key is a single-key shortcut again
  }
  return (
    <div className={`grid gap-1 bg-raised flex-none border-edge rounded ${classes.composer}`}>
      <SendField
        ref={field}
        aria-label={`Comment ${where}`}
        placeholder={`Comment ${where}`}
        rows={3}
        value={text}
        onText={(next) => onWriting({ ...writing, text: next })}
        onSend={send}
        onLeave={() => {
          field.current?.blur()
          onWriting(null)
        }}
      />
      <Mentions takeId={hand.id} field={field} text={text} onText={(next) => onWriting({ ...writing, text: next })} />
      <p className="row between">
        <span className="small dim">{capital(where)}</span>
        <Button keys="Enter" disabled={comment.isPending || text.trim() === ''} onClick={send}>
          Send
        </Button>
      </p>
      <DraftNote
        draft={{
          isRestored: writing.isRestored === true,
          discard: () => {
            keepDraft(draftKey, null)
            onWriting({ ...writing, text: '', isRestored: false })
          },
        }}
      />
      <Refusal error={comment.error} />
    </div>
  )
}

function whereWords(writing: Writing): string {
  if (writing.endS !== undefined) return `at ${range(writing.startS, writing.endS)}`
  return writing.startS > 0 ? `at ${place(writing.startS)}` : 'on the whole sound'
}
