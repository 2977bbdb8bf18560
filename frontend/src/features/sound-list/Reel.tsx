import { ButtonLink, Button } from '@/ui/Button'
import { length } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'

import { problemIn, type Reel as Made, useReel } from './api'
import classes from './Cue.module.css'

const SLATES = {
  spoken: 'Its number is said before each.',
  beeped: 'As many beeps as its number before each.',
  none: '',
} as const satisfies Record<Made['slates'], string>

/** All versions of a cue in a row, made when asked for; to be listened to, never for what ships. */
export function Reel({ cueId, cueName }: { cueId: string; cueName: string }) {
  const { ask, reel, error } = useReel(cueId)
  const problem = problemIn(error)
  const making = ask.isPending || reel?.state === 'making'
  return (
    <div className={classes.inside}>
      <div className="row wrap">
        <Button icon="headphones" disabled={making} onClick={() => ask.mutate()}>
          Hear all versions in a row
        </Button>
        {reel?.file_url && (
          <ButtonLink href={reel.file_url} download={reel.file_name} icon="download">
            Download the reel
          </ButtonLink>
        )}
      </div>
      <p className="small dim" role="status">
        {making && 'Putting them in a row …'}
        {reel?.file_url &&
          !making &&
          `${reel.takes.length === 1 ? 'One version' : `${reel.takes.length} versions`}, ${length(reel.duration_s ?? 0)}. ${SLATES[reel.slates]} To listen to only: a reel is in no pack.`}
      </p>
      {reel?.file_url && !making && (
        // eslint-disable-next-line jsx-a11y/media-has-caption -- all that is said in it are numbers, which are on the page
        <audio
          key={reel.id}
          className={classes.reel}
          src={reel.file_url}
          controls
          autoPlay
          aria-label={`All versions of ${cueName} in a row`}
        />
      )}
      {reel?.refusal && <ProblemNote detail={reel.refusal} />}
      {problem && <ProblemNote detail={problem.detail} fix={problem.fix} />}
    </div>
  )
}
