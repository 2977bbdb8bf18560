import { length } from '@/ui/format'

import type { CueStatus, ImportField } from './api'

/** The facts of a cue as screens call them. */
const FIELD_WORDS: Record<string, string> = {
  number: 'Number',
  name: 'Name',
  file_name: 'File name',
  category: 'Category',
  description: 'Description',
  use: 'Use in the game',
  trigger: 'Trigger',
  duration_s: 'Length',
  length_locked: 'Exact length',
  frame_rate_fps: 'Frame rate',
  loop: 'Loop',
  reverb: 'Reverb',
  variations: 'Variations',
  state: 'Settled',
  playback_priority: 'Priority',
  placeholder: 'Placeholder',
  palette: 'Palette',
  extra: 'Own columns',
}

export const fieldWord = (field: string): string => FIELD_WORDS[field] ?? field

/** What a column of a sheet can be read as, in the order of the select. */
export const IMPORT_FIELDS: readonly { value: ImportField; label: string }[] = [
  ...(
    [
      'number',
      'name',
      'file_name',
      'category',
      'description',
      'use',
      'trigger',
      'duration_s',
      'length_locked',
      'frame_rate_fps',
      'loop',
      'reverb',
      'variations',
      'state',
      'playback_priority',
      'placeholder',
      'palette',
    ] as const
  ).map((value) => ({ value, label: fieldWord(value) })),
  { value: 'extra', label: 'Keep it as it is' },
  { value: 'ignore', label: 'Leave it out' },
]

export const SETTLED = [
  { value: 'concept', label: 'Concept, may go' },
  { value: 'prototype', label: 'Prototype, may change' },
  { value: 'locked', label: 'Locked, will stay' },
] as const

export const REVERBS = [
  { value: '', label: 'Not said' },
  { value: 'dry', label: 'None in the file' },
  { value: 'designed-tail', label: 'Designed tail' },
  { value: 'separate-tail', label: 'Tail in its own file' },
] as const

const VALUE_WORDS: Record<string, Record<string, string>> = {
  state: { concept: 'concept', prototype: 'prototype', locked: 'locked', cut: 'cut' },
  reverb: Object.fromEntries(REVERBS.map(({ value, label }) => [value, label.toLowerCase()])),
}

/** A fact as a sentence can hold it: "0.80 s", "yes", "none". */
export function valueWord(field: string, value: unknown): string {
  if (value === null || value === undefined || value === '') return 'none'
  if (typeof value === 'boolean') return value ? 'yes' : 'no'
  if (typeof value === 'number') return field === 'duration_s' ? length(value) : String(value)
  if (typeof value === 'string') return VALUE_WORDS[field]?.[value] ?? value
  const own = Object.entries(value)
  return own.length === 0 ? 'none' : own.map(([column, text]) => `${column}: ${String(text)}`).join('; ')
}

/** Chips and headings in the order of a list: what needs someone first. */
export const STATUS_ORDER: readonly CueStatus[] = [
  'to_review',
  'returned',
  'change_requested',
  'question',
  'unjudged',
  'placeholder',
  'to_make',
  'checking',
  'partly_accepted',
  'accepted',
  'cut',
]

export const STATUS_WORDS: Partial<Record<CueStatus, string>> = { partly_accepted: 'Partly accepted' }
