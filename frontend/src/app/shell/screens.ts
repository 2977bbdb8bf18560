import type { IconName } from '@/ui/Icon'

import type { ShellData } from '../session'

export interface Screen {
  label: string
  path: string
  icon: IconName
  /** The letter after `g`. */
  letter: string
  exact?: boolean
  count?: number
}

/** The tabs of the person's role, in their order. */
export function screensOf({ person, side, project, counts }: ShellData): Screen[] {
  if (person === null) return []
  const inProject: Screen[] = project
    ? [{ label: 'Sound list', path: `/projects/${project.id}/sound-list`, icon: 'lines', letter: 'l' }]
    : []
  const projectTab: Screen = project
    ? { label: 'Project', path: `/projects/${project.id}`, icon: 'sliders', letter: 'p', exact: true }
    : { label: 'Projects', path: '/projects', icon: 'sliders', letter: 'p' }
  if (side === 'designer') {
    const path = project ? `/projects/${project.id}/desk` : '/desk'
    return [{ label: 'Desk', path, icon: 'tray', letter: 'd', count: counts.desk }, ...inProject, projectTab]
  }
  const review: Screen[] = project
    ? [
        {
          label: 'Review',
          path: `/projects/${project.id}/review`,
          icon: 'headphones',
          letter: 'r',
          count: counts.review,
        },
      ]
    : []
  return [
    {
      label: 'Today',
      path: project ? `/projects/${project.id}/today` : '/today',
      icon: 'sun',
      letter: 't',
      count: counts.today,
    },
    ...inProject,
    ...review,
    projectTab,
  ]
}
