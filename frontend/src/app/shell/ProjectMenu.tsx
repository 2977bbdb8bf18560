import { Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'

import { Icon } from '@/ui/Icon'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import type { ShellData } from '../session'

interface ProjectMenuProps extends MenuProps {
  data: ShellData
}

export function ProjectMenu({ data: { project, projects, side }, button }: ProjectMenuProps) {
  const router = useRouter()
  const go = (path: string) => void router.navigate({ href: path })
  return (
    <OpenedMenu button={button} position="bottom-start" width={260}>
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
    </OpenedMenu>
  )
}
