import type { WriteKind } from '@/api'
import { plural } from '@/ui/format'

const KINDS: readonly WriteKind[] = ['verdict', 'undo', 'comment']

/** "1 undo", "2 verdicts and 1 comment", "2 verdicts, 1 undo and 1 comment". */
export function keptWords(waiting: readonly WriteKind[]): string {
  const counts = KINDS.map((kind) => ({ kind, count: waiting.filter((waitingKind) => waitingKind === kind).length }))
  const parts = counts.filter(({ count }) => count > 0).map(({ kind, count }) => plural(count, kind))
  return [parts.slice(0, -1).join(', '), ...parts.slice(-1)].filter(Boolean).join(' and ')
}
