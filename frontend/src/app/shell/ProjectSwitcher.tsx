import { Icon } from '@/ui/Icon'
import { LazyMenu } from '@/ui/LazyMenu'

import type { ShellData } from '../session'
import classes from './Shell.module.css'

const load = () => import('./ProjectMenu').then(({ ProjectMenu }) => ProjectMenu)

export function ProjectSwitcher({ data }: { data: ShellData }) {
  const button = (
    <button type="button" className={classes.project}>
      <span className="cut-text">{data.project?.name ?? 'Projects'}</span>
      <Icon name="chevron" />
    </button>
  )
  return <LazyMenu button={button} load={load} given={{ data }} />
}
