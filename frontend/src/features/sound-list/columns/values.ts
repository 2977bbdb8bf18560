import type { ColumnKind, OwnColumn } from './api'

export const KINDS: readonly { value: ColumnKind; label: string }[] = [
  { value: 'text', label: 'Text' },
  { value: 'number', label: 'Number' },
  { value: 'yes_no', label: 'Yes or no' },
  { value: 'choice', label: 'Choice' },
  { value: 'date', label: 'Date' },
]

/** The only values that a column may have; null where any text is typed. */
export const choicesOf = ({ kind, choices }: OwnColumn): readonly string[] | null =>
  kind === 'choice' ? choices : kind === 'yes_no' ? ['yes', 'no'] : null
