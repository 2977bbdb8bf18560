import { Menu } from '@mantine/core'
import { Fragment, type ReactNode } from 'react'

import { Key } from '@/ui/Key'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import type { MoreGroup, MoreItem } from './more'

/** Everything of the room that is not in sight: ways of hearing, rarer verdicts, and what is done to the cue. */
export function MoreMenu({ button, groups }: MenuProps & { groups: readonly MoreGroup[] }) {
  return (
    <OpenedMenu button={button} position="bottom-end" width={310}>
      {groups.map((group, index) => (
        <Fragment key={group.title ?? index}>
          {index > 0 && !group.isFolded && <Menu.Divider />}
          {group.isFolded ? (
            <Menu.Sub>
              <Menu.Sub.Target>
                <Menu.Sub.Item>{group.title}</Menu.Sub.Item>
              </Menu.Sub.Target>
              <Menu.Sub.Dropdown>
                <Lines group={group} />
              </Menu.Sub.Dropdown>
            </Menu.Sub>
          ) : (
            <>
              {group.title && <Menu.Label>{group.title}</Menu.Label>}
              <Lines group={group} />
            </>
          )}
        </Fragment>
      ))}
    </OpenedMenu>
  )
}

function Lines({ group: { items, isChoice } }: { group: MoreGroup }): ReactNode {
  return items.map((item) => <Line key={item.label} item={item} isChoice={isChoice === true} />)
}

function Line({ item, isChoice }: { item: MoreItem; isChoice: boolean }) {
  const { label, note, keys, checked, disabled, run } = item
  const end = keys ? <Key keys={keys} /> : note && <span className="small dim">{note}</span>
  if (isChoice) {
    return (
      <Menu.RadioItem value={label} checked={checked === true} onChange={run} rightSection={end}>
        {label}
      </Menu.RadioItem>
    )
  }
  if (checked !== undefined) {
    return (
      <Menu.CheckboxItem checked={checked} onChange={run} rightSection={end}>
        {label}
      </Menu.CheckboxItem>
    )
  }
  return (
    <Menu.Item rightSection={end} disabled={disabled} onClick={run}>
      {label}
    </Menu.Item>
  )
}
