import { Outlet } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { useHotkeys } from '../keys'
import { LazyDialog } from '../LazyDialog'
import { NOBODY } from '../session'
import { StatusSlot } from '../toast'
import { loadKeysSheet } from './overlays'
import { Main } from './Main'
import { Mark } from './Mark'
import classes from './Shell.module.css'
import { ShellLink } from './ShellLink'
import { AccountMenuTrigger } from './AccountMenuTrigger'

/** The frame of the pages before an account, and of what went wrong before anyone was known. */
export function GuestFrame({ children = <Outlet /> }: { children?: ReactNode }) {
  const [showingKeys, setShowingKeys] = useState(false)
  useHotkeys([{ keys: '?', label: 'Keyboard shortcuts', group: 'Everywhere', run: () => setShowingKeys(true) }])
  return (
    <>
      <header className={`sticky ${classes.head} items-center gap-4 bg-surface border-b ${classes.bar}`}>
        <ShellLink path="/" className={`flex items-center gap-10px ${classes.mark}`} aria-label="Soundlist home">
          <Mark />
          <span className="strong">Soundlist</span>
        </ShellLink>
        <StatusSlot />
        <span className="end">
          <AccountMenuTrigger data={NOBODY} onKeys={() => setShowingKeys(true)} />
        </span>
      </header>
      <Main>{children}</Main>
      <LazyDialog load={loadKeysSheet} opened={showingKeys} onClose={() => setShowingKeys(false)} given={{}} />
    </>
  )
}
