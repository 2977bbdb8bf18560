import { TextInput } from '@mantine/core'
import { useState } from 'react'

import { ApiProblem } from '@/api'
import { showToast } from '@/app/toast'
import type { ReviewTake } from '@/judging/api'
import { Button } from '@/ui/Button'
import { ProblemNote } from '@/ui/ProblemNote'

import { useWaive } from './api'
import classes from './Review.module.css'

interface WaiverProps {
  take: ReviewTake
  cueId: string
  projectId: string
}

/** The approver lets a returned version through, with a reason. */
export function Waiver({ take, cueId, projectId }: WaiverProps) {
  const [reason, setReason] = useState('')
  const waive = useWaive(projectId, cueId)
  const said = reason.trim()
  const submit = () => {
    if (said === '' || waive.isPending) return
    waive.mutate(
      { takeId: take.id, reason: said },
      { onSuccess: () => showToast(`Version ${take.number} goes on; its game files are being made.`) },
    )
  }
  return (
    <form
      className={classes.waiver}
      onSubmit={(event) => {
        event.preventDefault()
        submit()
      }}
    >
      <TextInput
        label="Let it through, because"
        description="It goes to review as it is. The findings stay with it, and the game’s CI is told."
        value={reason}
        onChange={(event) => setReason(event.currentTarget.value)}
      />
      <Button type="submit" disabled={said === '' || waive.isPending}>
        Let version {take.number} through
      </Button>
      {waive.error instanceof ApiProblem && <ProblemNote detail={waive.error.detail} fix={waive.error.fix} />}
    </form>
  )
}
