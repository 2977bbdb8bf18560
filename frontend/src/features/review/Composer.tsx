import { type Dispatch, type SetStateAction, useLayoutEffect, useRef } from 'react'

import { DraftNote, keepDraft, keptDraft } from '@/app/drafts'
import type { CueReview, ReviewTake } from '@/judging/api'
import { Mentions } from '@/judging/Mentions'
import { capital } from '@/judging/words'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { place, range } from '@/ui/format'
import { Key } from '@/ui/Key'

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
  writing: Writing | null
  onWrite: () => void
  onWriting: Dispatch<SetStateAction<Writing | null>>
  comment: ReturnType<typeof useComment>
}

/** Where a comment is written: closed until asked for, and kept as a draft. */
export function Composer({ review, hand, writing, onWrite, onWriting, comment }: ComposerProps) {
  const field = useRef<HTMLTextAreaElement>(null)
  const opened = writing !== null
  // Before the next key: continued typing must not decide anything.
  useLayoutEffect(() => {
    if (!opened) return
    field.current?.focus()
    field.current?.setSelectionRange(field.current.value.length, field.current.value.length)
  }, [opened])
  const text = writing?.text ?? ''
  const draftKey = `comment:${review.cue.id}`
  const where = whereWords(writing)
  const send = () => {
    if (writing === null || text.trim() === '' || comment.isPending) return
    const isPoint = writing.startS > 0 || writing.endS !== undefined
    const said = {
      takeId: hand.id,
      text: text.trim(),
      startS: isPoint ? writing.startS : undefined,
      endS: writing.endS,
    }
    // The next cue may be open by the time it is sent.
    comment.mutateAsync(said).then(
      () => {
        keepDraft(draftKey, null)
        onWriting((now) => (now === writing ? null : now))
      },
      () => field.current?.focus(),
    )
    field.current?.blur() // the next key is a single-key shortcut again
  }
  return (
    <div className={classes.composer}>
      <textarea
        ref={field}
        aria-label={`Comment ${where}`}
        placeholder={opened ? `Comment ${where}` : 'Write a comment'}
        rows={opened ? 3 : 1}
        maxLength={10_000}
        value={text}
        onFocus={() => {
          if (!opened) onWrite()
        }}
        onChange={(event) => writing && onWriting({ ...writing, text: event.currentTarget.value })}
        onKeyDown={(event) => {
          if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
            event.preventDefault()
            send()
          } else if (event.key === 'Escape') {
            event.stopPropagation()
            field.current?.blur()
            onWriting(null)
          }
        }}
      />
      {writing && (
        <Mentions takeId={hand.id} field={field} text={text} onText={(next) => onWriting({ ...writing, text: next })} />
      )}
      <p className="row between">
        <span className="small dim">
          {opened ? (
            capital(where)
          ) : (
            <>
              <Key keys="c" /> {keptDraft(draftKey) === null ? 'comment at the playhead' : 'open your draft'}
            </>
          )}
        </span>
        {opened && (
          <Button keys="mod+Enter" disabled={comment.isPending || text.trim() === ''} onClick={send}>
            Send
          </Button>
        )}
      </p>
      <DraftNote
        draft={{
          isRestored: writing?.isRestored === true,
          discard: () => {
            keepDraft(draftKey, null)
            if (writing) onWriting({ ...writing, text: '', isRestored: false })
          },
        }}
      />
      <Refusal error={comment.error} />
    </div>
  )
}

function whereWords(writing: Writing | null): string {
  if (writing?.endS !== undefined) return `at ${range(writing.startS, writing.endS)}`
  return writing && writing.startS > 0 ? `at ${place(writing.startS)}` : 'on the whole sound'
}
