import { plural } from '@/ui/format'

import type { Brief, Question } from './api'

/** A sentence of the server: a capital first, an end. */
export function refused(text: string): string {
  const begun = text.charAt(0).toUpperCase() + text.slice(1)
  return /[.?!]$/.test(begun) ? begun : `${begun}.`
}

export const questionsOf = (brief: Brief): Question[] =>
  brief.topics.flatMap(({ questions }) => questions).filter(({ applies }) => applies)

/** "5 open, 4 of them named in the contract" */
export function openWords({ open, open_required: needed }: Brief): string {
  if (open.length === 0) return 'all answered'
  if (open.length === 1 && needed.length === 1) return '1 open, named in the contract'
  return needed.length === 0
    ? `${open.length} open`
    : `${open.length} open, ${needed.length} of them named in the contract`
}

/** How many names on the list fit the naming rule. */
export function fitInWords(fitting: number, count: number): string {
  if (fitting < count) return `${fitting} of ${plural(count, 'name')} on the list ${fitting === 1 ? 'fits' : 'fit'}.`
  return count === 1 ? 'The one name on the list fits.' : `All ${plural(count, 'name')} on the list fit.`
}
