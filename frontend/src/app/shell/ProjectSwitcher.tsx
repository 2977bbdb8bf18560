import { Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'

import { Icon } from '@/ui/Icon'

import type { ShellData } from '../session'
import classes from './Shell.module.css'

export function ProjectSwitcher({ data: { project, projects, side } }: { data: ShellData }) {
  const router = useRouter()
  const go = (path: string) => void router.navigate({ href: path })
  return (
    <Menu position="bottom-start" width={260} transitionProps={{ duration: 0 }}>
      <Menu.Target>
        <button type="button" className={classes.project}>
          <span className="cut-text">{project?.name ?? 'Projects'}</span>
          <Icon name="chevron" />
        </button>
      </Menu.Target>
      <Menu.Dropdown>
        {projects.map(({ id, name }) => (
          <Menu.Item
            key={id}
            onClick={() => go(`/projects/${id}`)}
            aria-current={id === project?.id || undefined}
            rightSection={id === project?.id ? <Icon name="tick" /> : undefined}
          >
            {name}
          </Menu.Item>
        ))}
        {projects.length > 0 && <Menu.Divider />}
        <Menu.Item onClick={() => go('/projects')}>All projects</Menu.Item>
        {side === 'studio' && (
          <Menu.Item leftSection={<Icon name="plus" />} onClick={() => go('/projects/new')}>
            New project
          </Menu.Item>
        )}
      </Menu.Dropdown>
    </Menu>
  )
}
