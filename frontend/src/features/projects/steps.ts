import { plural } from '@/ui/format'
import type { StateKind } from '@/ui/StatusBadge'

import type { Overview, Step } from './api'

export type Status = Step['status']

/** How a cue's progress is drawn, and in what order the legend names it. */
export const STATUSES: Record<Status, { kind: StateKind; word: string }> = {
  accepted: { kind: 'accepted', word: 'Accepted' },
  partly_accepted: { kind: 'approved', word: 'Partly accepted' },
  to_review: { kind: 'to_review', word: 'To review' },
  change_requested: { kind: 'change_requested', word: 'Change requested' },
  returned: { kind: 'returned', word: 'Returned' },
  unjudged: { kind: 'unjudged', word: 'Check broke' },
  question: { kind: 'question', word: 'Question' },
  placeholder: { kind: 'placeholder', word: 'Placeholder' },
  checking: { kind: 'checking', word: 'Checking' },
  to_make: { kind: 'to_make', word: 'To do' },
  cut: { kind: 'cut', word: 'Cut' },
}

export interface StepGroup {
  title: string
  steps: Step[]
  accepted: number
  wanted: number
}

/** The palette first, then the rest, each in list order; cut cues are shown and not counted. */
export function groupsOf(steps: readonly Step[]): StepGroup[] {
  const group = (title: string, palette: boolean): StepGroup => {
    const own = steps.filter((step) => step.palette === palette)
    const required = own.filter(({ status }) => status !== 'cut')
    return {
      title,
      steps: own,
      wanted: required.length,
      accepted: required.filter(({ status }) => status === 'accepted').length,
    }
  }
  const palette = group('Palette', true)
  const rest = group(palette.steps.length > 0 ? 'The rest of the list' : 'The list', false)
  return [palette, rest].filter((stepGroup) => stepGroup.steps.length > 0)
}

/** "9 accepted, 4 wait for the approver, 1 placeholder left". */
export function standInWords(counts: Overview['counts']): string {
  const { accepted = 0, to_review = 0, placeholder = 0, question = 0 } = counts
  return [
    `${accepted} accepted`,
    to_review > 0 ? `${to_review} ${to_review === 1 ? 'waits' : 'wait'} for the approver` : '',
    question > 0 ? plural(question, 'question') : '',
    placeholder > 0 ? `${plural(placeholder, 'placeholder')} left` : '',
  ]
    .filter(Boolean)
    .join(', ')
}
