import type { IconName } from '@/ui/Icon'

import type { ShellData } from '../session'

export interface Screen {
  label: string
  path: string
  icon: IconName
  /** The letter after `g`. */
  letter: string
  /** What waits there: "99+" where not all was counted. */
  count?: number | string
}

/** The screen that a page belongs to: the one whose address goes farthest towards the page's. */
export function screenOf(screens: readonly Screen[], pathname: string): Screen | undefined {
  const under = screens.filter(({ path }) => pathname === path || pathname.startsWith(`${path}/`))
  return under.toSorted((a, b) => b.path.length - a.path.length)[0]
}

/** The tabs of the person's role, in their order. */
export function screensOf({ person, side, project, isParty, counts }: ShellData): Screen[] {
  if (person === null) return []
  const inProject: Screen[] = project
    ? [{ label: 'Sound list', path: `/projects/${project.id}/sound-list`, icon: 'lines', letter: 'l' }]
    : []
  const contractTab: Screen[] =
    project && isParty
      ? [{ label: 'Contract', path: `/projects/${project.id}/contracts`, icon: 'file', letter: 'c' }]
      : []
  const projectTab: Screen = project
    ? { label: 'Project', path: `/projects/${project.id}`, icon: 'sliders', letter: 'p' }
    : { label: 'Projects', path: '/projects', icon: 'sliders', letter: 'p' }
  if (side === 'designer') {
    const path = project ? `/projects/${project.id}/desk` : '/desk'
    return [
      { label: 'Desk', path, icon: 'tray', letter: 'd', count: counts.desk },
      ...inProject,
      ...contractTab,
      projectTab,
    ]
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
    ...contractTab,
    projectTab,
  ]
}
