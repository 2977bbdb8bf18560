import type { Me, MyProject } from '@/api/me'

import type { Role } from './api'

export const ROLE_WORDS: Record<Role, string> = {
  producer: 'Producer',
  liaison: 'Audio lead',
  reviewer: 'Reviewer',
  implementer: 'Implementer',
}

/** What each role does, for those who choose one. */
export const ROLE_MEANINGS: Record<Role, string> = {
  producer: 'manages projects, money and people',
  liaison: 'answers designers for the team; can be the approver',
  reviewer: 'listens, comments, ticks checklists, has files checked again, makes packs; decides nothing',
  implementer: 'puts approved sounds into the game',
}

export const ROLES = Object.keys(ROLE_WORDS) as Role[]

/** The roles with which a member may act for the studio in a project, and approve. */
export const LEAD_ROLES: readonly Role[] = ['producer', 'liaison']

/** The word for a person's role in a project, or without one. */
export function partWord(me: Me, project: MyProject | undefined): string {
  if (project?.part === 'designer') return 'Sound designer'
  if (project?.is_approver) return 'Approver'
  const roles = (me.studios.find(({ id }) => id === project?.studio_id) ?? me.studios[0])?.roles ?? []
  const first = ROLES.find((role) => roles.includes(role))
  return first ? ROLE_WORDS[first] : 'Sound designer'
}

export type DemoPart = 'producer' | 'approver' | 'designer'

/** Whom the visitor of the demo plays: its three people differ by what they are in its project. */
export function demoPartOf(me: Me): DemoPart {
  if (me.studios.length === 0) return 'designer'
  return me.studios.some(({ roles }) => roles.includes('producer')) ? 'producer' : 'approver'
}
