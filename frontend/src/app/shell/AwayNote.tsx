import { useSyncExternalStore } from 'react'

import { connection } from '@/api'

import classes from './Shell.module.css'

/** Says quietly that the server does not answer; pages keep what they show. */
export function AwayNote() {
  const isAway = useSyncExternalStore(connection.subscribe, connection.isAway)
  return (
    <div aria-live="polite" className={classes.away} data-away={isAway || undefined}>
      {isAway && 'Can’t reach Soundlist. Retrying…'}
    </div>
  )
}
