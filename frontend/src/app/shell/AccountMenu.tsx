import { type MantineColorScheme, Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'

import { Key } from '@/ui/Key'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import type { ShellData } from '../session'
import { areasOf } from './areas'
import { helpFor } from './help'
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
  const { person, switcher, signOut } = data
  const pages = areasOf(data).find(({ id }) => id === 'you')?.pages ?? []
  return (
    <OpenedMenu button={button} position="bottom-end" width={232}>
      {person && (
        <Menu.Label>{person.name === person.role ? person.role : `${person.name}, ${person.role}`}</Menu.Label>
      )}
      {pages.map(({ label, path }) => (
        <Menu.Item key={path} onClick={() => go(path)}>
          {label}
        </Menu.Item>
      ))}
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
      <Menu.Item component="a" href={helpFor(router.state.location.pathname)} target="_blank">
        Help on this page
      </Menu.Item>
      <Menu.Item rightSection={<Key keys="?" />} onClick={onKeys}>
        Keyboard shortcuts
      </Menu.Item>
      {person && (
        <>
          <Menu.Divider />
          <Menu.Item onClick={signOut}>Sign out</Menu.Item>
        </>
      )}
      {!person && <Menu.Item onClick={() => go('/sign-in')}>Sign in</Menu.Item>}
    </OpenedMenu>
  )
}
