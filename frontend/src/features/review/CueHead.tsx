import type { CueReview } from '@/verdicts/api'
import { STATE_OF_TAKE } from '@/verdicts/stateOfTake'
import { asked } from '@/verdicts/words'
import { WordText } from '@/references'
import { Button } from '@/ui/Button'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'
import { VisionLine } from '@/vision'

import classes from './Review.module.css'

interface CueHeadProps {
  projectId: string
  review: CueReview
  waitingHere: boolean
  /** How many wait in the queue, which a narrow page opens from here. */
  queued: number | string
  onQueue: () => void
}

/** Which cue it is, and what was asked for. */
export function CueHead({ projectId, review, waitingHere, queued, onQueue }: CueHeadProps) {
  const { cue } = review
  const description = cue.description || cue.use
  return (
    <header className={`flex-none narrow-p-3 ${classes.cue}`}>
      <div className={`row wrap ${classes.cueName}`}>
        <h1>{cue.name}</h1>
        <StatusBadge kind={headState(review, waitingHere)} pill />
        <span className="small dim mono">{cue.label}</span>
        <span className={`end ${classes.queueButton}`}>
          <Button icon="headphones" onClick={onQueue} aria-controls="queue">
            {queued} waiting
          </Button>
        </span>
      </div>
      <div className="mid">
        <WordText projectId={projectId} text={description} /> <span className="dim">{asked(cue)}</span>
      </div>
      <VisionLine projectId={projectId} />
    </header>
  )
}

function headState({ cue, accepted, takes }: CueReview, waiting: boolean): StateKind {
  if (cue.state === 'cut') return 'cut'
  if (waiting) return 'to_review'
  if (accepted) return 'accepted'
  const newest = takes[0]
  return newest ? STATE_OF_TAKE[newest.state] : 'to_make'
}
