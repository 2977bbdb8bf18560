import { TextInput } from '@mantine/core'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import type { ReviewTake } from '@/judging/api'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { useWaive } from './api'
import classes from './Side.module.css'

interface WaiverProps {
  take: ReviewTake
  cueId: string
  projectId: string
}

/** The approver lets a returned version through, with a reason. */
export function Waiver({ take, cueId, projectId }: WaiverProps) {
  const [reason, setReason, draft] = useDraft(`waiver:${take.id}`, '')
  const waive = useWaive(projectId, cueId)
  const trimmed = reason.trim()
  const submit = () => {
    if (trimmed === '' || waive.isPending) return
    waive.mutate(
      { takeId: take.id, reason: trimmed },
      {
        onSuccess: () => {
          draft.discard()
          showToast(`Version ${take.number} waived. Its game files are being rendered.`)
        },
      },
    )
  }
  return (
    <form
      className={`grid gap-2 ${classes.waiver}`}
      onSubmit={(event) => {
        event.preventDefault()
        submit()
      }}
    >
      <TextInput
        label="Waive the findings: reason"
        description="It goes to review unchanged. The findings are kept, and the game’s CI accepts the file."
        value={reason}
        onChange={(event) => setReason(event.currentTarget.value)}
      />
      <Button type="submit" disabled={trimmed === '' || waive.isPending}>
        Waive version {take.number}
      </Button>
      <DraftNote draft={draft} />
      <Refusal error={waive.error} />
    </form>
  )
}
