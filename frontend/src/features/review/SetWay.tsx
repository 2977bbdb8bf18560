import type { ReactNode } from 'react'

import { HotkeyButton } from '@/app/keys'
import type { SetWay } from '@/audio'
import { useLazy } from '@/ui/useLazy'

import type { ChosenWay, PanelProps } from './useSetWay'

/** Opens the panel that says how a set is played, and names what is chosen. */
export function SetWayButton({ way, isOpen, setOpen }: ChosenWay) {
  return (
    <HotkeyButton
      keys="shift+h"
      keyLabel="How the set is played: rate, pitch, level"
      keyGroup="Review"
      icon="sliders"
      aria-expanded={isOpen}
      aria-controls="set-way"
      onPress={() => setOpen(!isOpen)}
    >
      {rateWords(way)}
    </HotkeyButton>
  )
}

function rateWords({ intervalS }: SetWay): string {
  if (intervalS === null) return 'One after another'
  return intervalS >= 0.25 ? `${Math.round(1 / intervalS)} a second` : `${Math.round(60 / intervalS)} a minute`
}

const loadPanel = () => import('./SetWayPanel').then(({ OpenedPanel }) => OpenedPanel)

/** The panel itself, once it is opened. */
export function SetWayPanel(props: PanelProps): ReactNode {
  const Panel = useLazy(loadPanel, props.isOpen, () => props.setOpen(false))
  return props.isOpen && Panel !== null ? <Panel {...props} /> : null
}
