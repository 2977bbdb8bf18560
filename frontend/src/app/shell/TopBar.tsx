import { useEffect, useRef } from 'react'

import { Count } from '@/ui/Count'
import { Icon } from '@/ui/Icon'
import { LazyMenu } from '@/ui/LazyMenu'

import type { ShellData } from '../session'
import { StatusSlot } from '../toast'
import { type Area, homeOf } from './areas'
import { Mark } from './Mark'
import { ProjectSwitcher } from './ProjectSwitcher'
import classes from './Shell.module.css'
import { ShellLink } from './ShellLink'
import { AccountMenuTrigger } from './AccountMenuTrigger'

const loadMore = () => import('./MoreMenu').then(({ MoreMenu }) => MoreMenu)

interface TopBarProps {
  data: ShellData
  areas: readonly Area[]
  pathname: string
  findKeys: string
  onFind: () => void
  onKeys: () => void
}

/** Two rows: where one is, and below it the pages of that area with the place for what goes on. */
export function TopBar({ data, areas, pathname, findKeys, onFind, onKeys }: TopBarProps) {
  const inBar = areas.filter(({ isInMenu }) => !isInMenu)
  const under = inBar.filter(({ onPhone }) => onPhone === undefined)
  const home = homeOf(pathname, data)
  const area = areas.find(({ id }) => id === home?.area)
  const pages = useRef<HTMLElement>(null)
  useEffect(() => {
    pages.current?.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest', inline: 'nearest' })
  }, [area?.id, home?.label])
  return (
    <header className={`sticky ${classes.head}`}>
      <div className={`items-center gap-4 bg-surface border-b ${classes.bar}`}>
        <ShellLink
          path={inBar[0]?.path ?? '/'}
          className={`flex items-center gap-10px ${classes.mark}`}
          aria-label={`Soundlist, ${inBar[0]?.label ?? 'home'}`}
        >
          <Mark />
        </ShellLink>
        {data.person && <ProjectSwitcher data={data} />}
        {inBar.length > 0 && (
          <nav className={`flex gap-2px ${classes.tabs}`} aria-label="Areas">
            {inBar.map(({ id, label, onPhone, path, icon, count }) => (
              <ShellLink
                key={id}
                path={path}
                current={id === area?.id}
                className={onPhone === undefined ? 'wide-only' : undefined}
              >
                <Icon name={icon} size={18} />
                {onPhone === undefined || onPhone === label ? (
                  <span>{label}</span>
                ) : (
                  <>
                    <span className="wide-only">{label}</span>
                    <span className="narrow-only">{onPhone}</span>
                  </>
                )}
                {count ? <Count of={count} what="waiting" /> : null}
              </ShellLink>
            ))}
            {under.length > 0 && (
              <span className={classes.more}>
                <LazyMenu
                  button={
                    <button type="button" aria-current={under.some(({ id }) => id === area?.id) || undefined}>
                      <Icon name="more" size={18} />
                      More
                    </button>
                  }
                  load={loadMore}
                  given={{ areas: under }}
                />
              </span>
            )}
          </nav>
        )}
        <button type="button" className={classes.find} aria-keyshortcuts="Control+K Meta+K" onClick={onFind}>
          <Icon name="search" />
          <span className={classes.findWords}>Search or do</span>
          <kbd className={`end mid rounded-s ${classes.findKeys}`} aria-hidden="true">
            {findKeys}
          </kbd>
        </button>
        {data.person && (
          <ShellLink
            path="/notices"
            className={`flex items-center ${classes.bell}`}
            aria-label={data.unread ? `Notices, ${data.unread} unread` : 'Notices'}
          >
            <Icon name="bell" size={18} />
            {data.unread && <Count of={data.unread} />}
          </ShellLink>
        )}
        <AccountMenuTrigger data={data} onKeys={onKeys} />
      </div>
      <div className={`flex items-center gap-3 bg-surface border-b ${classes.sub}`}>
        {area && (
          <nav ref={pages} className={`flex gap-2px ${classes.pages}`} aria-label={`Pages of ${area.label}`}>
            {area.pages.map(({ label, path, count }) => (
              <ShellLink key={path} path={path} current={label === home?.label}>
                {label}
                {count ? <Count of={count} what="waiting" /> : null}
              </ShellLink>
            ))}
          </nav>
        )}
        <StatusSlot />
      </div>
    </header>
  )
}
