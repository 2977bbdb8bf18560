import type { IconName } from '@/ui/Icon'

import type { ShellData } from '../session'

type AreaId =
  'today' | 'deliveries' | 'sounds' | 'review' | 'game' | 'people' | 'money' | 'settings' | 'projects' | 'you'

interface AreaHead {
  label: string
  icon: IconName
  /** The letter after `g`. */
  letter: string
  /** In the bar at the foot of a phone, by this word; the others are under More. */
  onPhone?: string
  /** The areas of the project menu and of the name menu stand in no bar. */
  isInMenu?: true
}

/** The areas in the order of the bar. */
const AREAS: Record<AreaId, AreaHead> = {
  today: { label: 'Today', icon: 'sun', letter: 't', onPhone: 'Today' },
  deliveries: { label: 'Deliveries', icon: 'tray', letter: 'd', onPhone: 'Deliveries' },
  sounds: { label: 'Sounds', icon: 'lines', letter: 's', onPhone: 'Sounds' },
  review: { label: 'Review', icon: 'headphones', letter: 'r', onPhone: 'Review' },
  game: { label: 'Game', icon: 'game', letter: 'g' },
  people: { label: 'People', icon: 'people', letter: 'p' },
  money: { label: 'Contract & money', icon: 'file', letter: 'c', onPhone: 'Money' },
  settings: { label: 'Settings', icon: 'sliders', letter: 'e' },
  projects: { label: 'Projects', icon: 'box', letter: '', isInMenu: true },
  you: { label: 'You', icon: 'people', letter: '', isInMenu: true },
}

/** Who sees a page. */
type Sees = (viewer: ShellData) => boolean
const isTeam: Sees = ({ side }) => side === 'studio'
const isDesigner: Sees = ({ side }) => side === 'designer'
const isImplementer: Sees = (viewer) => isTeam(viewer) && viewer.isImplementer
const judges: Sees = (viewer) => isTeam(viewer) && !viewer.isImplementer
const isParty: Sees = (viewer) => viewer.speaks && viewer.hasContracts
const leads: Sees = (viewer) => isTeam(viewer) && viewer.speaks
const hires: Sees = (viewer) => judges(viewer) && viewer.hasContracts
const isProducer: Sees = (viewer) => viewer.isProducer
const isAnyone: Sees = () => true

interface PageHome {
  area: AreaId
  label: string
  /** The entry leads to the first; `P` is the open project. All that lies below an address belongs to it too. */
  routes: readonly [string, ...string[]]
  sees: Sees
  /** Other words by which the palette finds it. */
  also?: readonly string[]
}

/** Every page of the shell: its area, its entry in the second row, and who sees it. Each route has one home for each role. */
export const HOMES: readonly PageHome[] = [
  { area: 'today', label: 'Tasks', routes: ['P/game-tasks'], sees: isImplementer },
  { area: 'today', label: 'For you', routes: ['P/today'], sees: isTeam },
  { area: 'today', label: 'For you', routes: ['/today', '/'], sees: isTeam },
  { area: 'today', label: 'Overview', routes: ['P'], sees: isTeam, also: ['project'] },
  { area: 'today', label: 'Progress', routes: ['P/progress'], sees: isTeam, also: ['steps', 'pace', 'palette'] },
  { area: 'today', label: 'Activity', routes: ['P/activity'], sees: isTeam, also: ['lately', 'what happened'] },

  { area: 'deliveries', label: 'To do', routes: ['P/desk', '/desk', 'P/today', '/today', '/'], sees: isDesigner },
  { area: 'deliveries', label: 'Overview', routes: ['P'], sees: isDesigner, also: ['project'] },
  { area: 'deliveries', label: 'Progress', routes: ['P/progress'], sees: isDesigner, also: ['steps', 'pace'] },
  { area: 'deliveries', label: 'Activity', routes: ['P/activity'], sees: isDesigner, also: ['lately'] },
  {
    area: 'deliveries',
    label: 'History',
    routes: ['P/deliveries', '/deliveries'],
    sees: isDesigner,
    also: ['uploads', 'versions'],
  },

  {
    area: 'sounds',
    label: 'List',
    routes: ['P/sound-list'],
    sees: isAnyone,
    also: ['cues', 'sheet', 'csv', 'excel', 'import'],
  },
  {
    area: 'sounds',
    label: 'Brief',
    routes: ['P/brief'],
    sees: isAnyone,
    also: ['questions', 'platforms', 'scenes', 'kickoff'],
  },
  {
    area: 'sounds',
    label: 'References',
    routes: ['P/references'],
    sees: isAnyone,
    also: ['pictures', 'video', 'clips', 'files', 'spotting'],
  },
  {
    area: 'sounds',
    label: 'Voice lines',
    routes: ['P/voice-lines'],
    sees: isAnyone,
    also: ['script', 'dialogue', 'localisation', 'pick-ups', 'releases'],
  },
  { area: 'sounds', label: 'Versions', routes: ['P/deliveries', '/deliveries', '/takes'], sees: isImplementer },

  { area: 'review', label: 'Queue', routes: ['P/review', '/takes'], sees: judges, also: ['verdict', 'approve'] },
  { area: 'review', label: 'Verdicts', routes: ['P/reasons', 'P/review', '/takes'], sees: isDesigner, also: ['why'] },
  {
    area: 'review',
    label: 'Playlists',
    routes: ['P/sharing', 'P/playlists'],
    sees: (viewer) => judges(viewer) || isDesigner(viewer),
    also: ['share', 'guest', 'links', 'listen', 'session'],
  },
  { area: 'review', label: 'Deliveries', routes: ['P/deliveries', '/deliveries'], sees: judges, also: ['uploads'] },

  {
    area: 'game',
    label: 'Packs',
    routes: ['P/packs', 'P/game-files'],
    sees: isTeam,
    also: ['pack', 'game files', 'download', 'export', 'targets', 'memory', 'seal'],
  },
  {
    area: 'game',
    label: 'Builds',
    routes: ['P/builds', 'P/drift', 'P/libraries'],
    sees: isTeam,
    also: ['CI', 'drift'],
  },
  { area: 'game', label: 'Placeholders', routes: ['P/placeholders'], sees: isTeam, also: ['stand-in'] },
  { area: 'game', label: 'In-game listening', routes: ['P/listening', 'P/recording'], sees: isTeam },
  { area: 'game', label: 'Tasks', routes: ['P/game-tasks'], sees: judges },
  {
    area: 'review',
    label: 'In-game listening',
    routes: ['P/listening', 'P/recording', 'P/game-tasks', 'P/libraries', 'P/drift'],
    sees: isDesigner,
  },

  {
    area: 'people',
    label: 'Team',
    routes: ['P/people', 'P/hours', 'P/credits'],
    sees: judges,
    also: ['invite', 'designer', 'members', 'hours', 'credits'],
  },
  { area: 'people', label: 'Roster', routes: ['/roster'], sees: hires, also: ['hire', 'on file', 'reel'] },
  {
    area: 'people',
    label: 'Postings',
    routes: ['P/postings'],
    sees: (viewer) => leads(viewer) && hires(viewer),
    also: ['hire', 'bid', 'award', 'job'],
  },

  {
    area: 'money',
    label: 'Contracts',
    routes: ['P/contracts'],
    sees: isParty,
    also: ['redlines', 'sign', 'terminate', 'plan', 'nda'],
  },
  {
    area: 'money',
    label: 'Invoices',
    routes: ['P/money', 'P/milestones'],
    sees: isParty,
    also: ['money', 'pay', 'ledger', 'deposit', 'milestones'],
  },

  {
    area: 'money',
    label: 'Credits',
    routes: ['P/credits'],
    sees: (viewer) => isDesigner(viewer) && viewer.hasContracts,
    also: ['name in the credits'],
  },
  {
    area: 'deliveries',
    label: 'Credits',
    routes: ['P/credits'],
    sees: (viewer) => isDesigner(viewer) && !viewer.hasContracts,
    also: ['name in the credits'],
  },

  { area: 'settings', label: 'Delivery spec', routes: ['P/spec'], sees: leads, also: ['limits', 'loudness', 'toml'] },
  {
    area: 'settings',
    label: 'Delivery spec',
    routes: ['P/spec/versions', 'P/spec'],
    sees: (viewer) => !leads(viewer),
    also: ['limits', 'loudness', 'naming'],
  },
  { area: 'settings', label: 'Approvers', routes: ['P/approvers'], sees: judges, also: ['deputies', 'categories'] },
  { area: 'settings', label: 'Approval rules', routes: ['P/approval'], sees: judges, also: ['checklists', 'hearing'] },
  { area: 'settings', label: 'Reasons', routes: ['P/reasons'], sees: isTeam, also: ['why', 'verdicts'] },
  { area: 'settings', label: 'Notifications', routes: ['/account/notifications'], sees: isAnyone, also: ['emails'] },
  { area: 'settings', label: 'Tokens', routes: ['P/tokens'], sees: isProducer, also: ['CI', 'key'] },
  { area: 'settings', label: 'Tokens', routes: ['/account/tokens'], sees: isDesigner, also: ['desk', 'key'] },
  {
    area: 'settings',
    label: 'Webhooks',
    routes: ['/webhooks'],
    sees: isProducer,
    also: ['slack', 'discord', 'teams', 'chat', 'api'],
  },
  {
    area: 'settings',
    label: 'Project',
    routes: ['P/settings'],
    sees: isProducer,
    also: ['name', 'prefix', 'archive', 'erase'],
  },

  { area: 'projects', label: 'All projects', routes: ['/projects'], sees: isAnyone },
  { area: 'projects', label: 'New project', routes: ['/projects/new'], sees: isTeam },

  {
    area: 'you',
    label: 'Account',
    routes: ['/account', '/erase', '/verify-address'],
    sees: isAnyone,
    also: ['password'],
  },
  { area: 'you', label: 'Notices', routes: ['/notices'], sees: isAnyone, also: ['news', 'mentions', 'unread'] },
  {
    area: 'you',
    label: 'My work',
    routes: ['/work', '/postings'],
    sees: isDesigner,
    also: ['figures', 'on time', 'bids', 'first pass'],
  },
  { area: 'you', label: 'Studio', routes: ['/studio'], sees: isTeam, also: ['people', 'calendar', 'emails', 'quotas'] },
  { area: 'you', label: 'Operations', routes: ['/operations'], sees: ({ operates }) => operates, also: ['jobs'] },
]

export interface Page {
  label: string
  path: string
  also: readonly string[]
  count?: number | string
}

export interface Area extends AreaHead {
  id: AreaId
  /** Where its entry leads: its first page. */
  path: string
  count?: number | string
  pages: readonly Page[]
}

/** Return an address of the table as it is in the open project, or undefined where none is open. */
function addressOf(route: string, projectId: string | undefined): string | undefined {
  if (!/^P(\/|$)/.test(route)) return route
  return projectId === undefined ? undefined : `/projects/${projectId}${route.slice(1)}`
}

/** Return the areas that a person has, each with the pages that they see. */
export function areasOf(viewer: ShellData): Area[] {
  const { person, project, counts } = viewer
  if (person === null) return []
  const waiting: Partial<Record<AreaId, number | string>> = {
    today: counts.today,
    deliveries: counts.desk,
    review: counts.review,
    money: counts.contract,
  }
  return (Object.keys(AREAS) as AreaId[]).flatMap((id) => {
    const pages: Page[] = []
    for (const { area, label, routes, sees, also = [] } of HOMES) {
      const path = addressOf(routes[0], project?.id)
      const isDrawn = area === id && path !== undefined && !pages.some((page) => page.label === label)
      if (isDrawn && sees(viewer)) pages.push({ label, path, also })
    }
    const [first, ...others] = pages
    if (first === undefined) return []
    const count = waiting[id] || undefined
    return [{ ...AREAS[id], id, path: first.path, count, pages: [{ ...first, count }, ...others] }]
  })
}

export interface Home {
  area: AreaId
  label: string
}

/** Return the area and the page that an address belongs to: those whose address goes farthest towards it. */
export function homeOf(pathname: string, viewer: ShellData): Home | undefined {
  let best: (Home & { length: number }) | undefined
  for (const { area, label, routes, sees } of HOMES) {
    if (!sees(viewer)) continue
    for (const route of routes) {
      const address = addressOf(route, viewer.project?.id)
      if (address === undefined) continue
      const isAt = pathname === address || (address !== '/' && pathname.startsWith(`${address}/`))
      if (isAt && address.length > (best?.length ?? 0)) best = { area, label, length: address.length }
    }
  }
  return best && { area: best.area, label: best.label }
}
