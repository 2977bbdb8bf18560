import { plural, shortDay } from '@/ui/format'
import type { StateKind } from '@/ui/StatusBadge'
import { STATE_OF_TAKE } from '@/verdicts/stateOfTake'

import type { Delivery, DeliveryDetail, Take } from './api'

/** When a delivery was begun and closed. */
export function daysOf({ created_at, closed_at }: Pick<Delivery, 'created_at' | 'closed_at'>): string {
  const [begun, closed] = [shortDay(created_at), closed_at && shortDay(closed_at)]
  if (closed === null) return `begun ${begun}, open`
  return closed === begun ? `${begun}, closed` : `${begun} to ${closed}, closed`
}

/** How a file of a delivery stands; one without a cue waits for it. */
export const standOf = ({ state, cue }: Take): StateKind =>
  cue === null && state !== 'received' ? 'unmatched' : STATE_OF_TAKE[state]

const ORDER: readonly StateKind[] = [
  'checking',
  'unjudged',
  'returned',
  'unmatched',
  'change_requested',
  'to_review',
  'approved',
  'set_aside',
]

/** How many files stand how, what needs someone first; discarded ones are not counted. */
export function countsOf({ takes }: DeliveryDetail): { kind: StateKind; files: number }[] {
  const kept = takes.filter(({ discarded_at }) => discarded_at === null)
  return ORDER.map((kind) => ({ kind, files: kept.filter((take) => standOf(take) === kind).length })).filter(
    ({ files }) => files > 0,
  )
}

/** "version 2, 03, 1.2 MB": what a file is besides its cue. */
export function versionOf({ number, alternate, variation, label, cue }: Take): string {
  if (cue === null) return ''
  const parts = [
    number === null ? '' : `version ${number}${alternate === null ? '' : ` ${String.fromCharCode(64 + alternate)}`}`,
    variation > 1 ? `variation ${variation}` : '',
    label ?? '',
  ]
  return parts.filter(Boolean).join(', ')
}

export const filesOf = (count: number): string => plural(count, 'file')
