import { useSyncExternalStore } from 'react'

import { outbox } from '@/api'
import { offlineOutbox } from '@/api/offlineOutbox'
import { Button } from '@/ui/Button'
import { ErrorBanner } from '@/ui/ErrorBanner'

import classes from './RefusedWrites.module.css'

/** What the server refused after the person had gone on; each stays until it is dismissed. */
export function RefusedWrites() {
  const { refused } = useSyncExternalStore(outbox.subscribe, outbox.getState)
  return (
    <section aria-label="Not saved" className={`grid gap-2 ${classes.refused}`}>
      {refused.map(({ place, what, why }) => (
        <ErrorBanner
          key={place}
          detail={`Not saved: ${what}. ${why.charAt(0).toUpperCase()}${why.slice(1)}.`}
          action={<Button onClick={() => offlineOutbox.forgetRefused(place)}>Dismiss</Button>}
        />
      ))}
    </section>
  )
}
