import { Avatar } from '@/ui/Avatar'
import { Icon } from '@/ui/Icon'
import { LazyMenu } from '@/ui/LazyMenu'

import type { ShellData } from '../session'
import classes from './Shell.module.css'

const load = () => import('./AccountMenu').then(({ AccountMenu }) => AccountMenu)

/** Who one is here, and what belongs to the person rather than the work: colours, keys, account. */
export function AccountMenuTrigger({ data, onKeys }: { data: ShellData; onKeys: () => void }) {
  const { person } = data
  const button = (
    <button type="button" className={classes.who}>
      {person ? <Avatar name={person.name} picture={person.picture} filled /> : <Icon name="sliders" />}
      <span className={classes.whoWords} aria-hidden="true">
        {person?.name ?? 'Settings'}
      </span>
      <span className="visually-hidden">{person ? `${person.name}: account and settings` : 'Settings'}</span>
      <span className={`flex ${classes.whoChevron}`}>
        <Icon name="chevron" />
      </span>
    </button>
  )
  return <LazyMenu button={button} load={load} given={{ data, onKeys }} />
}
