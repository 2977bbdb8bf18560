import { type ButtonHTMLAttributes, cloneElement, type ComponentType, type ReactElement, useState } from 'react'

import { useLazy } from './useLazy'

type ButtonElement = ReactElement<ButtonHTMLAttributes<HTMLButtonElement>>

export interface MenuProps {
  /** What opens the menu, and has the focus again once it closes. */
  button: ButtonElement
}

interface LazyMenuProps<Given> extends MenuProps {
  load: () => Promise<ComponentType<Given & MenuProps>>
  /** What the menu is given besides its button. */
  given: Given
}

/** A button whose menu is loaded when someone reaches for it, and opens once it is here. */
export function LazyMenu<Given extends object>({ button, load, given }: LazyMenuProps<Given>) {
  const [isWanted, setWanted] = useState(false)
  const Menu = useLazy(load, isWanted, () => setWanted(false))
  if (Menu !== null) return <Menu {...given} button={button} />
  const reachFor = () => void load().catch(() => undefined)
  return cloneElement(button, {
    'aria-haspopup': 'menu',
    'aria-expanded': false,
    onPointerEnter: reachFor,
    onFocus: reachFor,
    onClick: () => setWanted(true),
  })
}
