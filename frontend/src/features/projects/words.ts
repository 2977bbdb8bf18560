import { ApiProblem } from '@/api'
import { plural } from '@/ui/format'
import { sentence } from '@/ui/sentence'

import type { Project } from './api'
import type { EngagementKind } from './people/api'

/** Figures with the minus that they are read with. */
export const trueMinus = (text: string): string => text.replace(/(^|[\s(])-(?=\d|∞|inf)/g, '$1−')

/** What stands against one field, in a sentence. */
export function against(error: unknown, field: string): string | undefined {
  const problem = error instanceof ApiProblem ? error.of(field) : undefined
  return problem && sentence(problem.message)
}

export const KIND_WORDS: Record<EngagementKind, string> = {
  advisory: 'advisory',
  contract: 'contractor',
  'in-house': 'in-house',
}

export const KIND_MEANINGS: Record<EngagementKind, string> = {
  advisory: 'advises, unpaid',
  contract: 'paid by contract',
  'in-house': 'on the studio’s payroll',
}

export const KINDS = Object.keys(KIND_WORDS) as EngagementKind[]

/** Who may change the spec and invite: a producer, a liaison or the approver. */
export const canActForStudio = ({ mine }: Project): boolean => mine.is_producer || mine.is_liaison || mine.is_approver

/** The lines of a text that say something. */
export const linesOf = (text: string): string[] =>
  text
    .split('\n')
    .map((line) => line.trim())
    .filter(Boolean)

/** "A", "A and B", "A, B and C". */
export function listed(words: readonly string[], joint = 'and'): string {
  return words.length < 2 ? (words[0] ?? '') : `${words.slice(0, -1).join(', ')} ${joint} ${words.at(-1)}`
}

/** A project's prefix as it would be shortened by hand: initials of several words, the beginning of one. */
export function proposedPrefix(name: string): string {
  const plain = name
    .normalize('NFD')
    .toUpperCase()
    .replace(/[^A-Z0-9\s_-]/g, '')
  const words = plain.split(/[\s_-]+/).filter(Boolean)
  const letters = words.length > 1 ? words.map((word) => word.charAt(0)).join('') : (words[0] ?? '').slice(0, 3)
  return letters.replace(/^[0-9]+/, '').slice(0, 8)
}

/** "+ 1 other team member". */
export const otherMembers = (count: number): string => `+ ${plural(count, 'other team member')}`
