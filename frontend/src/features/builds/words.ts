import { figure } from '@/ui/format'
import type { IconName } from '@/ui/Icon'
import type { StateKind } from '@/ui/StatusBadge'

import type { AuditedSound, AuditSummary, GameTask, HeardAs } from './api'

/** "+6.0 dB", "−0.5 dB", "+0.0 dB". */
export const signed = (db: number): string => `${db < 0 && figure(db, 1).startsWith('−') ? '' : '+'}${figure(db, 1)} dB`

const STATUS_WORDS: Record<AuditedSound['status'], string> = {
  same: 'As approved',
  gain: 'Another level',
  trimmed: 'Cut or padded',
  resampled: 'Another sample rate',
  're-encoded': 'Encoded again',
  changed: 'Another sound',
  missing: 'Missing in the build',
  unknown: 'Not approved',
  placeholder: 'Placeholder',
  duplicate: 'Duplicate',
  converted: 'Converted badly',
  unapproved: 'Not approved, and played',
  unused: 'Not used by the game',
  depends: 'Depends on the game',
}

/** What happened to a sound, in words: "Louder", "Quieter", "Missing in the build"; "as approved" only where it is sure. */
export function describeChange({
  status,
  played_status,
  gain_db,
  depends = [],
}: Pick<AuditedSound, 'status' | 'played_status' | 'gain_db'> & { depends?: readonly string[] }): string {
  const also = played_status !== 'same' && played_status !== status && status !== 'same' ? played_status : null
  const moved = gain_db !== null && Math.abs(gain_db) >= 0.1 ? (gain_db > 0 ? 'Louder' : 'Quieter') : null
  const first = status === 'gain' && moved ? moved : STATUS_WORDS[status]
  const second = also === null ? null : also === 'gain' && moved ? moved : STATUS_WORDS[also]
  const words = [first, second?.toLowerCase()].filter(Boolean).join(', ')
  return status === 'depends' && depends.length > 0 ? `Depends on ${depends.join(', ')}` : words
}

const FACES: Record<AuditedSound['status'], StateKind> = {
  same: 'passed',
  gain: 'refused',
  trimmed: 'warning',
  resampled: 'warning',
  're-encoded': 'warning',
  changed: 'refused',
  missing: 'refused',
  unknown: 'unmatched',
  placeholder: 'placeholder',
  duplicate: 'warning',
  converted: 'warning',
  unapproved: 'unmatched',
  unused: 'warning',
  depends: 'waiting',
}
export const faceOf = ({ status, accepted }: Pick<AuditedSound, 'status'> & { accepted?: unknown }): StateKind =>
  accepted ? 'waived' : FACES[status]

export type Outcome = 'passed' | 'warned' | 'refused'
export const outcomeOf = ({ drifted, new_drifts }: AuditSummary): Outcome =>
  new_drifts > 0 ? 'refused' : drifted > 0 ? 'warned' : 'passed'
export const OUTCOME_STATES: Record<Outcome, StateKind> = { passed: 'passed', warned: 'warning', refused: 'refused' }

/** "As approved", "4 drifted", "4 drifted, 2 new". */
export function auditInWords({ drifted, new_drifts }: AuditSummary): string {
  if (drifted === 0) return 'As approved'
  return `${figure(drifted)} drifted${new_drifts > 0 ? `, ${figure(new_drifts)} new` : ''}`
}

/** Whether the new level can be heard here: a gain is applied to the approved sound, another file is not on the server. */
export const isAudibleHere = ({ gain_db, status }: AuditedSound): boolean =>
  gain_db !== null && Math.abs(gain_db) >= 0.1 && !['changed', 'missing', 'unknown', 'unapproved'].includes(status)

/** What cannot be heard here, in words; null where everything can. */
export function unheardOf({ status, gain_db }: AuditedSound): string | null {
  if (['missing', 'unknown', 'unapproved'].includes(status)) return null
  if (status === 'gain' || status === 'same' || status === 'depends') return null
  const level = gain_db === null ? '' : ' Its level is applied to the approved sound.'
  return `The build’s own file is not on the server, so what was changed in it cannot be heard here.${level}`
}

export interface Saying {
  said: HeardAs
  word: string
  keys: string
  icon: IconName
}

export const SAYINGS: readonly Saying[] = [
  { said: 'too-loud', word: 'Too loud', keys: '1', icon: 'level' },
  { said: 'too-soft', word: 'Too quiet', keys: '2', icon: 'lines' },
  { said: 'too-long', word: 'Too long', keys: '3', icon: 'right' },
  { said: 'too-short', word: 'Too short', keys: '4', icon: 'clock' },
  { said: 'wrong', word: 'Wrong', keys: '5', icon: 'cross' },
  { said: 'missing', word: 'Missing', keys: '6', icon: 'dashedSquare' },
  { said: 'good', word: 'Good', keys: '7', icon: 'tick' },
]

export const SAID_WORDS: Record<HeardAs, string> = {
  ...(Object.fromEntries(SAYINGS.map(({ said, word }) => [said, word])) as Record<HeardAs, string>),
  'not-reached': 'Not reached',
}

export const TASK_WORDS: Record<GameTask['kind'], string> = {
  'too-loud': 'Too loud',
  'too-soft': 'Too quiet',
  'too-long': 'Too long',
  'too-short': 'Too short',
  wrong: 'Wrong',
  missing: 'Missing',
  drift: 'Not as approved',
}
export const ROLE_WORDS: Record<GameTask['role'], string> = {
  implementer: 'for the implementers',
  designer: 'for its designer',
}

/** Whose task a note becomes, as the server decides it; nothing for what is good or was not reached. */
export const taskOf = (heardAs: HeardAs): string | null =>
  heardAs === 'good' || heardAs === 'not-reached'
    ? null
    : heardAs === 'too-long' || heardAs === 'too-short' || heardAs === 'wrong'
      ? 'Task for its designer'
      : 'Task for the implementers'
