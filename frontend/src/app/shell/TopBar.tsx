import { useLocation } from '@tanstack/react-router'

import { Count } from '@/ui/Count'
import { Icon } from '@/ui/Icon'

import type { ShellData } from '../session'
import { StatusSlot } from '../toast'
import { Mark } from './Mark'
import { ProjectSwitcher } from './ProjectSwitcher'
import { type Screen, screenOf } from './screens'
import classes from './Shell.module.css'
import { ShellLink } from './ShellLink'
import { WhoMenu } from './WhoMenu'

interface TopBarProps {
  data: ShellData
  screens: Screen[]
  findKeys: string
  onFind: () => void
  onKeys: () => void
}

export function TopBar({ data, screens, findKeys, onFind, onKeys }: TopBarProps) {
  const home = screens[0]?.path ?? '/'
  const here = screenOf(screens, useLocation().pathname)
  return (
    <header className={classes.bar}>
      <ShellLink path={home} className={classes.mark} aria-label={`Soundlist, ${screens[0]?.label ?? 'home'}`}>
        <Mark />
      </ShellLink>
      {data.person && <ProjectSwitcher data={data} />}
      {screens.length > 0 && (
        <nav className={classes.tabs} aria-label="Screens">
          {screens.map(({ label, path, icon, count }) => (
            <ShellLink key={path} path={path} current={path === here?.path}>
              <Icon name={icon} size={18} />
              <span>{label}</span>
              {count ? <Count of={count} what="waiting" /> : null}
            </ShellLink>
          ))}
        </nav>
      )}
      <StatusSlot />
      <button type="button" className={classes.find} aria-keyshortcuts="Control+K Meta+K" onClick={onFind}>
        <Icon name="search" />
        <span className={classes.findWords}>Search or do</span>
        <kbd className={classes.findKeys} aria-hidden="true">
          {findKeys}
        </kbd>
      </button>
      {data.person && (
        <ShellLink
          path="/notices"
          className={classes.bell}
          aria-label={data.unread ? `Notices, ${data.unread} unread` : 'Notices'}
        >
          <Icon name="bell" size={18} />
          {data.unread && <Count of={data.unread} />}
        </ShellLink>
      )}
      <WhoMenu data={data} onKeys={onKeys} />
    </header>
  )
}
