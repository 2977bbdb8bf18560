import { Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'
import { Fragment } from 'react'

import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import type { Area } from './areas'

interface MoreMenuProps extends MenuProps {
  areas: readonly Area[]
}

/** On a phone: the areas for which its bar has no room, page by page. */
export function MoreMenu({ areas, button }: MoreMenuProps) {
  const router = useRouter()
  return (
    <OpenedMenu button={button} position="top-end" width={232}>
      {areas.map(({ id, label: area, pages }) => (
        <Fragment key={id}>
          <Menu.Label>{area}</Menu.Label>
          {pages.map(({ label, path }) => (
            <Menu.Item key={path} onClick={() => void router.navigate({ href: path })}>
              {label}
            </Menu.Item>
          ))}
        </Fragment>
      ))}
    </OpenedMenu>
  )
}
