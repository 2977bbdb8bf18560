import { useSyncExternalStore } from 'react'

import { connection, laterWrites } from '@/api'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Shell.module.css'

/** Says quietly that the server does not answer, and what waits to be sent; then what of that was refused. */
export function AwayNote() {
  const isAway = useSyncExternalStore(connection.subscribe, connection.isAway)
  const { waiting, refused } = useSyncExternalStore(laterWrites.subscribe, laterWrites.getState)
  return (
    <>
      <div aria-live="polite" className={classes.away} data-away={isAway || waiting > 0 || undefined}>
        {isAway && <span>Can’t reach Soundlist. Retrying…</span>}
        {waiting > 0 && <span> {waitingWords(waiting, isAway)}</span>}
      </div>
      {refused.length > 0 && (
        <section aria-label="Not saved" className={classes.unsaved}>
          {refused.map(({ place, what, why }) => (
            <ProblemNote
              key={place}
              detail={`Not saved: ${what}. ${why.charAt(0).toUpperCase()}${why.slice(1)}.`}
              action={<Button onClick={() => laterWrites.forgetRefused(place)}>Dismiss</Button>}
            />
          ))}
        </section>
      )}
    </>
  )
}

const waitingWords = (count: number, isAway: boolean): string =>
  isAway
    ? `${plural(count, 'verdict or comment', 'verdicts and comments')} kept in this browser until it is back.`
    : `Sending ${plural(count, 'verdict or comment', 'verdicts and comments')}…`
