import { Menu } from '@mantine/core'

import { CONDITIONS } from '@/audio'
import { Key } from '@/ui/Key'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'
import { capital } from '@/judging/words'

import type { Conditions } from './useCondition'

type ConditionsMenuProps = MenuProps & Pick<Conditions, 'condition' | 'choose'>

/** Every way of hearing, with its figures and its key. */
export function ConditionsMenu({ button, condition, choose }: ConditionsMenuProps) {
  const line = (name: string, figures: string, key: number, isOn: boolean) => (
    <>
      <span className="strong">
        {capital(name)}
        {isOn && ', selected'}
      </span>{' '}
      <Key keys={`shift+${key}`} />
      <br />
      <span className="small dim">{figures}</span>
    </>
  )
  return (
    <OpenedMenu button={button} position="bottom-start" width={320}>
      <Menu.Label>Heard as it will be played</Menu.Label>
      <Menu.Item onClick={() => choose(null)}>{line('full range', 'as delivered', 1, condition === null)}</Menu.Item>
      {CONDITIONS.map((one, index) => (
        <Menu.Item key={one.id} onClick={() => choose(one)}>
          {line(one.name, one.figures, index + 2, one.id === condition?.id)}
        </Menu.Item>
      ))}
    </OpenedMenu>
  )
}
