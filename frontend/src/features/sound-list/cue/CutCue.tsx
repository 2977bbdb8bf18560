import { TextInput } from '@mantine/core'
import { useEffect, useRef, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { type Cue, useCut } from '../api'
import classes from './Panel.module.css'

interface CutCueProps {
  cue: Cue
  projectId: string
  onClose: () => void
}

/** Cut a cue that the game no longer needs. It asks why, in place, since a cut stays. */
export function CutCue({ cue, projectId, onClose }: CutCueProps) {
  const [reason, setReason, draft] = useDraft(`cut:${cue.id}`, '')
  const [missing, setMissing] = useState(false)
  const cut = useCut(projectId, cue.id)
  const field = useRef<HTMLInputElement>(null)
  useEffect(() => field.current?.focus(), [])
  const send = () => {
    const why = reason.trim()
    setMissing(why === '')
    if (why === '' || cut.isPending) return
    cut.mutate(why, {
      onSuccess: () => {
        draft.discard()
        showToast(`${cue.label} ${cue.name} cut. It stays in the list with the reason.`)
        onClose()
      },
    })
  }
  return (
    <form
      className={`grid gap-3 narrow-p-3 ${classes.panel}`}
      aria-label={`Cut ${cue.name}`}
      onSubmit={(event) => {
        event.preventDefault()
        send()
      }}
    >
      <DraftNote draft={draft} />
      <div className={`grid items-end gap-2 grid-cols-1-auto narrow-grid-cols-1 ${classes.say}`}>
        <TextInput
          ref={field}
          label={`Why cut ${cue.name}?`}
          value={reason}
          error={missing ? 'Enter a reason. The designer reads it.' : undefined}
          onChange={(event) => setReason(event.currentTarget.value)}
        />
        <span className="row">
          <Button onClick={onClose}>Cancel</Button>
          <Button type="submit" variant="primary" disabled={cut.isPending}>
            Cut {cue.name}
          </Button>
        </span>
      </div>
      <p className="small dim">
        A cut can’t be undone: {cue.label} stays in the list with its reason and versions, and its file name can be used
        again.
      </p>
      <Refusal error={cut.error} />
    </form>
  )
}
