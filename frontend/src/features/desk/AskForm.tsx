import { Textarea } from '@mantine/core'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Field, Submit } from '@/ui/Form'
import { useFocusOnMount } from '@/ui/useFocusOnMount'
import { useLazy } from '@/ui/useLazy'

import { useAsk } from './api'

const loadCueSelect = () => import('./CueSelect').then(({ CueSelect }) => CueSelect)

interface AskFormProps {
  projectId: string
  /** The cue that the question is about unless another is chosen. */
  cueId: string | null
  onDone: () => void
}

/** A question about a cue, to the studio. */
export function AskForm({ projectId, cueId, onDone }: AskFormProps) {
  const CueSelect = useLazy(loadCueSelect, true, onDone)
  const ask = useAsk(projectId)
  const textField = useFocusOnMount<HTMLTextAreaElement>(cueId !== null)
  return (
    <DraftForm
      draftKey={`ask:${projectId}:${cueId ?? ''}`}
      className="grid gap-3 border-b p-3-inset"
      initialValues={{ cue: cueId, text: '' }}
      mutation={ask}
      checks={({ cue, text }) => ({
        cue: cue === null && 'Choose a cue.',
        text: text.trim() === '' && 'Write your question.',
      })}
      onSubmit={({ cue, text }, onSent) =>
        ask.mutate(
          { cueId: cue ?? '', text: text.trim() },
          {
            onSuccess: ({ cue_name }) => {
              onSent()
              showToast(`Question about ${cue_name} sent. You get the answer here and by email.`)
              onDone()
            },
          },
        )
      }
    >
      {CueSelect && <Field as={CueSelect} name="cue" projectId={projectId} hasFocus={cueId === null} />}
      <Field
        as={Textarea}
        name="text"
        label="Question"
        rows={3}
        maxLength={2000}
        ref={textField}
        onKeyDown={(event) => {
          if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) event.currentTarget.form?.requestSubmit()
          if (event.key === 'Escape') onDone()
        }}
      />
      <Submit className="flex justify-end gap-2" onCancel={onDone}>
        Send question
      </Submit>
    </DraftForm>
  )
}
