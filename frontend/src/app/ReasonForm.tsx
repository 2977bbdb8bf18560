import { TextInput } from '@mantine/core'
import type { ReactNode } from 'react'

import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { DraftNote, useDraft } from './drafts'

interface ReasonFormProps {
  /** What is done with the reason, for those who listen. */
  label: string
  /** The key under which what was typed is kept. */
  draftKey: string
  field: string
  description?: string
  mutation: { isPending: boolean; error: unknown }
  /** `onSent` forgets the draft. */
  onSend: (reason: string, onSent: () => void) => void
  /** The words of the button. */
  children: ReactNode
  className?: string
}

/** An act that wants a reason in one line, which the record keeps. */
export function ReasonForm({
  label,
  draftKey,
  field,
  description,
  mutation: { isPending, error },
  onSend,
  children,
  className,
}: ReasonFormProps) {
  const [text, setText, draft] = useDraft(draftKey, '')
  const reason = text.trim()
  return (
    <form
      className={className}
      aria-label={label}
      onSubmit={(event) => {
        event.preventDefault()
        if (!isPending && reason !== '') onSend(reason, draft.discard)
      }}
    >
      <TextInput
        label={field}
        description={description}
        value={text}
        maxLength={2000}
        onChange={({ currentTarget }) => setText(currentTarget.value)}
      />
      <DraftNote draft={draft} />
      <Refusal error={error} />
      <Button type="submit" disabled={reason === ''} aria-busy={isPending}>
        {children}
      </Button>
    </form>
  )
}
