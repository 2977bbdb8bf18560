import { type ComponentType, useCallback } from 'react'

import { useLazy } from '@/ui/useLazy'

import { useFirstInteraction } from './firstInteraction'
import { KeyScope } from './keys'

export interface OpenedProps {
  opened: boolean
  onClose: () => void
}

interface LazyDialogProps<Given> extends OpenedProps {
  load: () => Promise<ComponentType<Given & OpenedProps>>
  /** What the dialog is given besides. */
  given: Given
}

/**
 * What opens over the page, loaded at the first sign of a person rather than with the page.
 * A key pressed while it is on its way is not for the page below.
 */
export function LazyDialog<Given extends object>({ load, opened, onClose, given }: LazyDialogProps<Given>) {
  const Opened = useLazy(load, opened, onClose)
  useFirstInteraction(useCallback(() => void load().catch(() => undefined), [load]))
  if (Opened === null) return opened && <KeyScope>{null}</KeyScope>
  return <Opened {...given} opened={opened} onClose={onClose} />
}
