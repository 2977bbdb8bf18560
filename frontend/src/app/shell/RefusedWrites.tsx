import { useSyncExternalStore } from 'react'

import { later } from '@/api'
import { laterWrites } from '@/api/laterWrites'
import { Button } from '@/ui/Button'
import { ErrorBanner } from '@/ui/ErrorBanner'

import classes from './RefusedWrites.module.css'

/** What the server refused after the person had gone on; each stays until it is dismissed. */
export function RefusedWrites() {
  const { refused } = useSyncExternalStore(later.subscribe, later.getState)
  return (
    <section aria-label="Not saved" className={`grid gap-2 ${classes.refused}`}>
      {refused.map(({ place, what, why }) => (
        <ErrorBanner
          key={place}
          detail={`Not saved: ${what}. ${why.charAt(0).toUpperCase()}${why.slice(1)}.`}
          action={<Button onClick={() => laterWrites.forgetRefused(place)}>Dismiss</Button>}
        />
      ))}
    </section>
  )
}
