import { Textarea } from '@mantine/core'
import { useState } from 'react'

import { ApiProblem } from '@/api'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { ended } from '@/judging/findings'
import { Button } from '@/ui/Button'
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
  const [chosen, setChosen] = useState(cueId)
  const [text, setText, draft] = useDraft(`ask:${projectId}`, '')
  const [missing, setMissing] = useState<{ cue?: string; text?: string }>({})
  const ask = useAsk(projectId)
  const textField = useFocusOnMount<HTMLTextAreaElement>(cueId !== null)
  const send = () => {
    const lacks = {
      cue: chosen === null ? 'Choose a cue.' : undefined,
      text: text.trim() === '' ? 'Write your question.' : undefined,
    }
    setMissing(lacks)
    if (chosen === null || lacks.text !== undefined || ask.isPending) return
    ask.mutate(
      { cueId: chosen, text: text.trim() },
      {
        onSuccess: ({ cue_name }) => {
          draft.discard()
          showToast(`Question about ${cue_name} sent. You get the answer here and by email.`)
          onDone()
        },
      },
    )
  }
  const refusal = ask.error instanceof ApiProblem ? ask.error : null
  return (
    <form
      className="grid gap-3 border-b p-3-inset"
      onSubmit={(event) => {
        event.preventDefault()
        send()
      }}
      noValidate
    >
      {CueSelect && (
        <CueSelect
          projectId={projectId}
          chosen={chosen}
          onChoose={setChosen}
          error={missing.cue}
          hasFocus={cueId === null}
        />
      )}
      <Textarea
        label="Question"
        rows={3}
        maxLength={2000}
        value={text}
        onChange={(event) => setText(event.currentTarget.value)}
        error={missing.text ?? (refusal ? ended(refusal.of('text')?.message ?? refusal.detail) : undefined)}
        ref={textField}
        onKeyDown={(event) => {
          if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) send()
          if (event.key === 'Escape') onDone()
        }}
      />
      <DraftNote draft={draft} />
      <div className="flex justify-end gap-2">
        <Button variant="quiet" onClick={onDone}>
          Cancel
        </Button>
        <Button type="submit" variant="primary">
          Send question
        </Button>
      </div>
    </form>
  )
}
