import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import type { ReviewTake } from '@/verdicts/api'
import { Field, Submit } from '@/ui/Form'

import { useWaive } from './api'
import classes from './Side.module.css'

interface WaiverProps {
  take: ReviewTake
  cueId: string
  projectId: string
}

/** The approver lets a returned version through, with a reason. */
export function Waiver({ take, cueId, projectId }: WaiverProps) {
  const waive = useWaive(projectId, cueId)
  return (
    <DraftForm
      draftKey={`waiver:${take.id}`}
      className={`grid gap-2 ${classes.waiver}`}
      initialValues={{ reason: '' }}
      mutation={waive}
      onSubmit={({ reason }, onSent) =>
        waive.mutate(
          { takeId: take.id, reason: reason.trim() },
          {
            onSuccess: () => {
              onSent()
              showToast(`Version ${take.number} waived. Its game files are being rendered.`)
            },
          },
        )
      }
    >
      <Field
        name="reason"
        label="Waive the findings: reason"
        description="It goes to review unchanged. The findings are kept, and the game’s CI accepts the file."
      />
      <Submit variant="plain">Waive version {take.number}</Submit>
    </DraftForm>
  )
}
