import { Menu } from '@mantine/core'
import { type ReactNode, useEffect, useRef, useState } from 'react'

import type { MenuProps } from './LazyMenu'

interface OpenedMenuProps extends MenuProps {
  position: 'bottom-start' | 'bottom-end'
  width?: number
  children: ReactNode
}

/** The menu of a LazyMenu. It was loaded since someone asked for it, so it opens by itself. */
export function OpenedMenu({ button, position, width, children }: OpenedMenuProps) {
  const [isOpen, setOpen] = useState(false)
  const bar = useRef<HTMLSpanElement>(null)
  useEffect(() => {
    // The focus goes back here when the menu closes.
    bar.current?.querySelector('button')?.focus()
    setOpen(true)
  }, [])
  return (
    <span ref={bar} style={{ display: 'contents' }}>
      <Menu opened={isOpen} onChange={setOpen} position={position} width={width} transitionProps={{ duration: 0 }}>
        <Menu.Target>{button}</Menu.Target>
        <Menu.Dropdown>{children}</Menu.Dropdown>
      </Menu>
    </span>
  )
}
