import { lazy, type ReactNode, Suspense } from 'react'

import { Icon, type IconName } from './Icon'
import classes from './StatusBadge.module.css'

const StateReason = lazy(async () => ({ default: (await import('./StateReason')).StateReason }))

export type Tone = 'ok' | 'bad' | 'warn' | 'change' | 'review' | 'idle'

interface StatusStyle {
  word: string
  icon: IconName
  tone: Tone
  /** Resting states keep a coloured icon and a quiet word, so that what needs someone stands out. */
  resting?: true
}

/** Every state there is, of a cue, a take, a file on its way or a build. */
export const STATES = {
  to_make: { word: 'To do', icon: 'ring', tone: 'idle', resting: true },
  checking: { word: 'Checking', icon: 'turning', tone: 'idle', resting: true },
  to_review: { word: 'To review', icon: 'headphones', tone: 'review' },
  returned: { word: 'Returned', icon: 'back', tone: 'bad' },
  fixable: { word: 'Fixable', icon: 'spanner', tone: 'warn' },
  refused: { word: 'Refused', icon: 'back', tone: 'bad' },
  not_sent: { word: 'Not uploaded', icon: 'back', tone: 'bad' },
  question: { word: 'Question', icon: 'question', tone: 'warn' },
  unmatched: { word: 'Unmatched', icon: 'question', tone: 'warn' },
  warning: { word: 'Warning', icon: 'triangle', tone: 'warn' },
  change_requested: { word: 'Change requested', icon: 'pencil', tone: 'change' },
  approved: { word: 'Approved', icon: 'tick', tone: 'ok', resting: true },
  accepted: { word: 'Accepted', icon: 'tick', tone: 'ok', resting: true },
  waived: { word: 'Waived', icon: 'spanner', tone: 'warn' },
  set_aside: { word: 'Set aside', icon: 'turn', tone: 'idle', resting: true },
  placeholder: { word: 'Placeholder', icon: 'dashedSquare', tone: 'warn' },
  cut: { word: 'Cut', icon: 'struckRing', tone: 'idle', resting: true },
  waiting: { word: 'Waiting', icon: 'ring', tone: 'idle', resting: true },
  sending: { word: 'Uploading', icon: 'upload', tone: 'idle' },
  line_lost: { word: 'Reconnecting', icon: 'pause', tone: 'warn' },
  paused: { word: 'Paused', icon: 'pause', tone: 'idle' },
  conforming: { word: 'Conforming', icon: 'tick', tone: 'ok' },
  already_here: { word: 'Already here', icon: 'tick', tone: 'ok', resting: true },
  unjudged: { word: 'Check failed', icon: 'triangle', tone: 'warn' },
  passed: { word: 'Passed', icon: 'tick', tone: 'ok' },
  late: { word: 'Late', icon: 'clock', tone: 'bad' },
} as const satisfies Record<string, StatusStyle>

export type StateKind = keyof typeof STATES

interface StateProps {
  kind: StateKind
  /** Other words, as "5 of 8 accepted". */
  children?: ReactNode
  /** Tinted, for heads. */
  pill?: boolean
  strong?: boolean
  /** Why, on hover and focus: the reason of a waiver. */
  reason?: string
}

/** Icon, word, colour: the only place where a colour says how something stands. */
export function StatusBadge({ kind, children, pill = false, strong = false, reason }: StateProps) {
  const { word, icon, tone, ...face }: StatusStyle = STATES[kind]
  const className = [
    classes.state,
    `tone-${tone}`,
    pill ? classes.pill : face.resting ? classes.resting : '',
    strong ? 'strong' : '',
  ]
    .filter(Boolean)
    .join(' ')
  const inside = (
    <>
      <Icon name={icon} />
      <span>{children ?? word}</span>
    </>
  )
  if (reason === undefined) return <span className={className}>{inside}</span>
  return (
    <Suspense fallback={<span className={className}>{inside}</span>}>
      <StateReason className={`${className} ${classes.asking}`} reason={reason}>
        {inside}
      </StateReason>
    </Suspense>
  )
}
