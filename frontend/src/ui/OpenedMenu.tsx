import { Menu } from '@mantine/core'
import { type ReactNode, useEffect, useRef, useState } from 'react'

import type { MenuProps } from './LazyMenu'

interface OpenedMenuProps extends MenuProps {
  position: 'bottom-start' | 'bottom-end' | 'top-end'
  width?: number
  children: ReactNode
}

/** The menu of a LazyMenu. It was loaded since someone asked for it, so it opens by itself. */
export function OpenedMenu({ button, position, width, children }: OpenedMenuProps) {
  const [isOpen, setOpen] = useState(false)
  const bar = useRef<HTMLSpanElement>(null)
  useEffect(() => setOpen(true), [])
  useEffect(() => {
    // Before the menu opens and after it closes the button has the focus, unless a field that an item opened took it:
    // Mantine's own `returnFocus` would take it from that field, and what is typed there would be taken for shortcuts.
    if (!isOpen && hasNoFocus()) bar.current?.querySelector('button')?.focus()
  }, [isOpen])
  return (
    <span ref={bar} style={{ display: 'contents' }}>
      <Menu
        opened={isOpen}
        onChange={setOpen}
        position={position}
        width={width}
        transitionProps={{ duration: 0 }}
        returnFocus={false}
      >
        <Menu.Target>{button}</Menu.Target>
        <Menu.Dropdown>{children}</Menu.Dropdown>
      </Menu>
    </span>
  )
}

const hasNoFocus = () => document.activeElement === null || document.activeElement === document.body
