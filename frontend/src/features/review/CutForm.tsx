import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { SendField } from '@/verdicts/SendField'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { useCut } from './api'
import classes from './Review.module.css'

interface CutFormProps {
  cueId: string
  name: string
  projectId: string
  onClose: () => void
  onCut: () => void
}

/** Asks why the game no longer needs a cue, before it is cut. */
export function CutForm({ cueId, name, projectId, onClose, onCut }: CutFormProps) {
  const [reason, setReason, draft] = useDraft(`cut:${cueId}`, '')
  const cut = useCut(projectId, cueId)
  const field = useFocusOnMount<HTMLTextAreaElement>()
  const submit = () => {
    const trimmed = reason.trim()
    if (trimmed === '' || cut.isPending) return
    cut.mutate(trimmed, {
      onSuccess: () => {
        draft.discard()
        showToast(`${name} cut. Its versions are kept.`)
        onCut()
      },
    })
  }
  return (
    <form
      className="grid gap-2 border-t mt-3 pt-3"
      onSubmit={(event) => {
        event.preventDefault()
        submit()
      }}
    >
      <p className="small mid">Cut {name}? It stays in the list with the reason and its versions.</p>
      <div className="row">
        <SendField
          ref={field}
          className={`line-field ${classes.field}`}
          aria-label={`Why cut ${name}?`}
          placeholder="Reason"
          value={reason}
          onText={setReason}
          onSend={submit}
          onLeave={onClose}
        />
        <Button onClick={onClose}>Cancel</Button>
        <Button type="submit" icon="struckRing" disabled={cut.isPending || reason.trim() === ''}>
          Cut {name}
        </Button>
      </div>
      <DraftNote draft={draft} />
      <Refusal error={cut.error} />
    </form>
  )
}
