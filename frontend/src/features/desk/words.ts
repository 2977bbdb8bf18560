import { ended } from '@/judging/findings'
import { spelled } from '@/judging/words'
import { figure, plural } from '@/ui/format'

import type { Desk } from './api'

/** What waits, in one sentence. */
export function deskLine(desk: Desk): string {
  const parts: string[] = []
  const { came_back: back, unmatched, to_make: toMake, checking } = desk
  if (back.length > 0) parts.push(`${spelled(back.length)} came back`)
  if (unmatched > 0) parts.push(`${spelled(unmatched)} ${unmatched === 1 ? 'file has' : 'files have'} no cue yet`)
  if (checking > 0) parts.push(`${spelled(checking)} ${checking === 1 ? 'is' : 'are'} being checked`)
  if (toMake.length > 0) parts.push(`${plural(toMake.length, 'cue')} to make`)
  if (parts.length === 0) {
    return desk.cues === 0
      ? 'The list is empty. You hear by mail when there is something to make.'
      : `Nothing waits for you: ${figure(desk.accepted)} of ${plural(desk.cues, 'cue')} accepted.`
  }
  return ended(parts.join(', '))
}
