import type { ReactNode } from 'react'

import { useIsLoading } from '../toast'
import classes from './Shell.module.css'

/** The middle of every frame. A page that has nothing to show yet shows that it waits. */
export function Main({ children }: { children: ReactNode }) {
  const isLoading = useIsLoading()
  return (
    <main id="main" tabIndex={-1} className={classes.main} data-waiting={isLoading || undefined}>
      {children}
    </main>
  )
}
