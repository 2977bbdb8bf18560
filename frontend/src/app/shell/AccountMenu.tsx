import { type MantineColorScheme, Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'

import { Key } from '@/ui/Key'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import type { ShellData } from '../session'
import { useScheme } from './scheme'

const SCHEMES = [
  { value: 'auto', label: 'System' },
  { value: 'light', label: 'Light' },
  { value: 'dark', label: 'Dark' },
] as const

interface AccountMenuProps extends MenuProps {
  data: ShellData
  onKeys: () => void
}

export function AccountMenu({ data, onKeys, button }: AccountMenuProps) {
  const router = useRouter()
  const scheme = useScheme()
  const go = (path: string) => void router.navigate({ href: path })
  const { person, side, operates, switcher, signOut } = data
  return (
    <OpenedMenu button={button} position="bottom-end" width={232}>
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
          {side === 'studio' && <Menu.Item onClick={() => go('/roster')}>Roster of designers</Menu.Item>}
          {side === 'designer' && <Menu.Item onClick={() => go('/work')}>Your work</Menu.Item>}
          {operates && <Menu.Item onClick={() => go('/operations')}>Jobs and storage</Menu.Item>}
          <Menu.Item onClick={() => go('/account')}>Account</Menu.Item>
          <Menu.Divider />
          <Menu.Item onClick={signOut}>Sign out</Menu.Item>
        </>
      )}
      {!person && <Menu.Item onClick={() => go('/sign-in')}>Sign in</Menu.Item>}
    </OpenedMenu>
  )
}
