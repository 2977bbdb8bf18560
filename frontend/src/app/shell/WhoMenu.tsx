import { type MantineColorScheme, Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'

import { Face } from '@/ui/Face'
import { Icon } from '@/ui/Icon'
import { Key } from '@/ui/Key'

import type { ShellData } from '../session'
import { useScheme } from './scheme'
import classes from './Shell.module.css'

const SCHEMES = [
  { value: 'auto', label: 'System' },
  { value: 'light', label: 'Light' },
  { value: 'dark', label: 'Dark' },
] as const

/** Who one is here, and what belongs to the person rather than the work: colours, keys, account. */
export function WhoMenu({ data, onKeys }: { data: ShellData; onKeys: () => void }) {
  const router = useRouter()
  const scheme = useScheme()
  const go = (path: string) => void router.navigate({ href: path })
  const { person, side, operates, switcher, signOut } = data
  return (
    <Menu position="bottom-end" width={232} transitionProps={{ duration: 0 }} closeOnItemClick>
      <Menu.Target>
        <button type="button" className={classes.who}>
          {person ? <Face name={person.role} filled /> : <Icon name="sliders" />}
          <span className={classes.whoWords} aria-hidden="true">
            {person?.role ?? 'Settings'}
          </span>
          <span className="visually-hidden">{person ? `${person.role}: account and settings` : 'Settings'}</span>
          <span className={classes.whoChevron}>
            <Icon name="chevron" />
          </span>
        </button>
      </Menu.Target>
      <Menu.Dropdown>
        {person && (
          <Menu.Label>{person.name === person.role ? person.role : `${person.name}, ${person.role}`}</Menu.Label>
        )}
        {switcher}
        <Menu.Label>Theme</Menu.Label>
        <Menu.RadioGroup value={scheme.chosen} onChange={(value) => scheme.set(value as MantineColorScheme)}>
          {SCHEMES.map(({ value, label }) => (
            <Menu.RadioItem key={value} value={value}>
              {label}
            </Menu.RadioItem>
          ))}
        </Menu.RadioGroup>
        <Menu.Divider />
        <Menu.Item rightSection={<Key keys="?" />} onClick={onKeys}>
          Keyboard shortcuts
        </Menu.Item>
        {person && (
          <>
            {side === 'studio' && <Menu.Item onClick={() => go('/studio')}>Studio, people and emails</Menu.Item>}
            {operates && <Menu.Item onClick={() => go('/operations')}>Jobs and storage</Menu.Item>}
            <Menu.Item onClick={() => go('/account')}>Account</Menu.Item>
            <Menu.Divider />
            <Menu.Item onClick={signOut}>Sign out</Menu.Item>
          </>
        )}
        {!person && <Menu.Item onClick={() => go('/sign-in')}>Sign in</Menu.Item>}
      </Menu.Dropdown>
    </Menu>
  )
}
