import { Menu } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'

import { Icon } from '@/ui/Icon'
import type { MenuProps } from '@/ui/LazyMenu'
import { OpenedMenu } from '@/ui/OpenedMenu'

import type { ShellData } from '../session'
import { areasOf } from './areas'

interface ProjectMenuProps extends MenuProps {
  data: ShellData
}

export function ProjectMenu({ data, button }: ProjectMenuProps) {
  const { project, projects } = data
  const pages = areasOf(data).find(({ id }) => id === 'projects')?.pages ?? []
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
      {pages.map(({ label, path }) => (
        <Menu.Item key={path} onClick={() => go(path)}>
          {label}
        </Menu.Item>
      ))}
    </OpenedMenu>
  )
}
