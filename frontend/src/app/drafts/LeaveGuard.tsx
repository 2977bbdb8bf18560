import { useBlocker, useRouter } from '@tanstack/react-router'

import { LazyDialog } from '../LazyDialog'
import { discardDrafts, isAnythingTyped, keepDrafts } from './store'

const load = () => import('./LeaveDialog').then(({ LeaveDialog }) => LeaveDialog)

/** Asks before a page is left on which something was typed and not sent. Stepping through a queue is not leaving it. */
export function LeaveGuard() {
  const router = useRouter()
  const leaving = useBlocker({
    shouldBlockFn: ({ current, next }) => {
      const route = router.routesById[current.routeId]
      const steps = current.routeId === next.routeId && route.options.staticData?.keepsFocus === true
      return current.pathname !== next.pathname && !steps && isAnythingTyped()
    },
    enableBeforeUnload: false, // what the browser cannot keep asks by itself
    withResolver: true,
  })
  const leave = (before: () => void) => () => {
    before()
    leaving.proceed?.()
  }
  return (
    <LazyDialog
      load={load}
      opened={leaving.status === 'blocked'}
      onClose={() => leaving.reset?.()}
      given={{ onLeave: leave(keepDrafts), onDiscard: leave(discardDrafts) }}
    />
  )
}
