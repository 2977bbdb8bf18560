import type { ReactNode } from 'react'

import { useLazy } from '@/ui/useLazy'

import type { PanelProps } from './useSetPlaybackMode'

const loadPanel = () => import('./SetPlaybackPanel').then(({ OpenedPanel }) => OpenedPanel)

/** The panel itself, once it is opened. */
export function SetPlaybackPanel(props: PanelProps): ReactNode {
  const Panel = useLazy(loadPanel, props.isOpen, () => props.setOpen(false))
  return props.isOpen && Panel !== null ? <Panel {...props} /> : null
}
