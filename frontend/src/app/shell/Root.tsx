import { Outlet, useRouter } from '@tanstack/react-router'
import { useEffect } from 'react'

import { LeaveGuard } from '../drafts'
import classes from './Shell.module.css'

/** Move the focus to the head of the page, so that the keyboard and the voice start where the eye does. */
function focusPage(): void {
  const main = document.getElementById('main')
  const head = main?.querySelector('h1') ?? main
  if (head === null || head === undefined) return
  if (!head.hasAttribute('tabindex')) head.setAttribute('tabindex', '-1')
  head.focus({ preventScroll: true })
}

/** What stands round every page: the way past the bar, the place for what was done, the focus after a change of page. */
export function Root() {
  const router = useRouter()
  useEffect(() => {
    let before = router.state.matches.at(-1)?.routeId
    return router.subscribe('onRendered', ({ pathChanged, fromLocation }) => {
      const match = router.state.matches.at(-1)
      const stays = match?.staticData.keepsFocus === true && match.routeId === before
      before = match?.routeId
      if (pathChanged && fromLocation && !stays) focusPage()
    })
  }, [router])

  return (
    <>
      <a className={`rounded ${classes.skip}`} href="#main">
        Skip to content
      </a>
      <Outlet />
      <LeaveGuard />
    </>
  )
}
