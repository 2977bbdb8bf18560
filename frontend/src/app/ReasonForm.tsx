import { DraftForm } from './drafts/DraftForm'
import { Field, Submit } from '@/ui/Form'
import type { ReactNode } from 'react'

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
  mutation,
  onSend,
  children,
  className,
}: ReasonFormProps) {
  return (
    <DraftForm
      className={className}
      aria-label={label}
      draftKey={draftKey}
      initialValues={{ reason: '' }}
      mutation={mutation}
      checks={({ reason }) => ({ reason: reason.trim() === '' && 'Enter a reason.' })}
      onSubmit={({ reason }, onSent) => onSend(reason.trim(), onSent)}
    >
      <Field name="reason" label={field} description={description} maxLength={2000} />
      <Submit variant="plain">{children}</Submit>
    </DraftForm>
  )
}
