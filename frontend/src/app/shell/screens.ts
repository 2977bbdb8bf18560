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
      ? [
          {
            label: 'Contract',
            path: `/projects/${project.id}/contracts`,
            icon: 'file',
            letter: 'c',
            count: counts.contract,
          },
        ]
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

interface Place {
  label: string
  path: string
  /** Other words it is found by. */
  also: string[]
}

/** Pages without a tab, and what is done there, for the palette. */
export function placesOf({ side, project, isParty }: ShellData): Place[] {
  if (project === null) return []
  const at = `/projects/${project.id}`
  const money: Place[] = isParty
    ? [{ label: 'Money, invoices and payments', path: `${at}/money`, also: ['invoice', 'pay', 'ledger', 'deposit'] }]
    : []
  const references: Place = {
    label: 'References',
    path: `${at}/references`,
    also: ['pictures', 'video', 'clips', 'files'],
  }
  const voiceLines: Place = {
    label: 'Voice lines',
    path: `${at}/voice-lines`,
    also: ['script', 'dialogue', 'localisation', 'pick-ups', 'releases'],
  }
  if (side === 'designer')
    return [
      { label: 'Brief', path: `${at}/brief`, also: ['questions', 'platforms', 'scenes'] },
      references,
      voiceLines,
      ...money,
      { label: 'Your work', path: '/work', also: ['figures', 'on time', 'first pass'] },
    ]
  return [
    { label: 'Invite a designer or an approver', path: `${at}/people`, also: ['people', 'team', 'hire', 'members'] },
    ...(isParty ? [{ label: 'Postings and bids', path: `${at}/postings`, also: ['hire', 'bid', 'award', 'job'] }] : []),
    ...(isParty ? [{ label: 'Webhooks', path: '/webhooks', also: ['slack', 'discord', 'teams', 'chat', 'api'] }] : []),
    { label: 'Roster of designers', path: '/roster', also: ['people', 'hire', 'on file', 'reel'] },
    { label: 'Import or paste cues', path: `${at}/sound-list/import`, also: ['sheet', 'csv', 'excel', 'add'] },
    { label: 'Brief', path: `${at}/brief`, also: ['questions', 'platforms', 'scenes', 'kickoff'] },
    references,
    voiceLines,
    { label: 'Guest links and playlists', path: `${at}/sharing`, also: ['share', 'guest', 'listen', 'session'] },
    { label: 'Start from a kit', path: `${at}/sound-list/kits`, also: ['starter', 'template', 'genre'] },
    { label: 'Delivery spec', path: `${at}/spec`, also: ['limits', 'loudness', 'naming', 'toml'] },
    { label: 'Game files and packs', path: `${at}/game-files`, also: ['pack', 'download', 'export', 'targets'] },
    ...money,
  ]
}
