import type { Project } from '../api'
import type { Member } from './api'

/** The members who can be an approver or a deputy: audio leads of the project, and producers. */
export const candidatesOf = ({ liaisons }: Project, members: readonly Member[]): Member[] =>
  members.filter(({ person, roles }) => liaisons.some(({ id }) => id === person.id) || roles.includes('producer'))
