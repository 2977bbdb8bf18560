import { Menu } from '@mantine/core'

import type { ReviewTake } from '@/judging/api'
import { shortDay } from '@/ui/format'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'
import { State } from '@/ui/State'

import { STATE_OF_TAKE } from './stateOfTake'

export function MoreMenu({ button, onCut }: MenuProps & { onCut: () => void }) {
  return (
    <OpenedMenu button={button} position="bottom-end">
      <Menu.Item onClick={onCut}>Cut this cue</Menu.Item>
    </OpenedMenu>
  )
}

interface VersionsMenuProps extends MenuProps {
  title: string
  /** The newest first. */
  versions: readonly ReviewTake[]
  hand: ReviewTake | undefined
  onTake: (take: ReviewTake) => void
}

export function VersionsMenu({ button, title, versions, hand, onTake }: VersionsMenuProps) {
  return (
    <OpenedMenu button={button} position="bottom-end">
      <Menu.Label>{title}</Menu.Label>
      {versions.map((take) => (
        <Menu.Item key={take.id} rightSection={<State kind={STATE_OF_TAKE[take.state]} />} onClick={() => onTake(take)}>
          Version {take.number}, {shortDay(take.received_at)}
          {take.id === hand?.id && ', selected'}{' '}
        </Menu.Item>
      ))}
    </OpenedMenu>
  )
}
