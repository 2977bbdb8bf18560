import { StatusBadge } from '@/ui/StatusBadge'

import type { VoiceLine } from './api'
import { LINE_STATES } from './words'

/** What a line has come to, as icon and words. */
export function LineState({ state }: { state: VoiceLine['state'] }) {
  const { kind, word } = LINE_STATES[state]
  return <StatusBadge kind={kind}>{word}</StatusBadge>
}
