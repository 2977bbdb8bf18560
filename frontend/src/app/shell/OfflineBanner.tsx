import { lazy, Suspense, useSyncExternalStore } from 'react'

import { connection, outbox } from '@/api'

import { keptWords } from './kept'
import classes from './Shell.module.css'

const RefusedWrites = lazy(async () => ({ default: (await import('./RefusedWrites')).RefusedWrites }))

/** Says quietly that the server does not answer, and what waits to be sent; then what of that was refused. */
export function OfflineBanner() {
  const isUnreachable = useSyncExternalStore(connection.subscribe, connection.isUnreachable)
  const { waiting, refused } = useSyncExternalStore(outbox.subscribe, outbox.getState)
  const kept = keptWords(waiting)
  return (
    <>
      <div aria-live="polite" className={classes.away} data-away={isUnreachable || waiting.length > 0 || undefined}>
        {isUnreachable && <span>Can’t reach Soundlist. Retrying…</span>}
        {waiting.length > 0 && (isUnreachable ? ` ${kept} kept in this browser until it is back.` : `Sending ${kept}…`)}
      </div>
      {refused.length > 0 && (
        <Suspense fallback={null}>
          <RefusedWrites />
        </Suspense>
      )}
    </>
  )
}
