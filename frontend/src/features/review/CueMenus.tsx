import { Menu } from '@mantine/core'
import { useNavigate } from '@tanstack/react-router'

import type { ReviewTake } from '@/judging/api'
import { STATE_OF_TAKE } from '@/judging/stateOfTake'
import { shortDay } from '@/ui/format'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'
import { State } from '@/ui/State'

interface MoreMenuProps extends MenuProps {
  projectId: string
  cueId: string
  onCut: () => void
}

export function MoreMenu({ button, projectId, cueId, onCut }: MoreMenuProps) {
  const navigate = useNavigate()
  const share = () =>
    void navigate({ to: '/projects/$projectId/sharing', params: { projectId }, search: { cue: cueId } })
  return (
    <OpenedMenu button={button} position="bottom-end">
      <Menu.Item onClick={share}>Share with guests</Menu.Item>
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
