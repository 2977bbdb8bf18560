import { cameBack } from '@/app/desk'
import { ended } from '@/verdicts/findings'
import { spelled } from '@/verdicts/words'
import { figure, plural } from '@/ui/format'

import type { Desk } from './api'

/** What waits, in one sentence. */
export function deskLine(desk: Desk): string {
  const parts: string[] = []
  const { came_back_next: further, unmatched, to_make_cues: toMake, checking } = desk
  const back = cameBack(desk)
  if (back > 0) parts.push(`${further ? plural(back, 'cue') : spelled(back)} to fix`)
  if (unmatched > 0) parts.push(`${spelled(unmatched)} ${unmatched === 1 ? 'file has' : 'files have'} no cue yet`)
  if (checking > 0) parts.push(`${spelled(checking)} ${checking === 1 ? 'is' : 'are'} being checked`)
  if (toMake > 0) parts.push(`${plural(toMake, 'cue')} to do`)
  if (parts.length === 0) {
    return desk.cues === 0
      ? 'The sound list is empty. You get an email when there is something to do.'
      : `Nothing to do: ${figure(desk.accepted)} of ${plural(desk.cues, 'cue')} accepted.`
  }
  return ended(parts.join(', '))
}
