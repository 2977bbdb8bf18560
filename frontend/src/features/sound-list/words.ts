import { length } from '@/ui/format'
import type { Need } from '@/ui/NeedMark'

import type { CueStatus } from './api'
import type { ImportField } from './import/api'

/** The facts of a cue as screens call them. */
const FIELD_WORDS: Record<string, string> = {
  number: 'ID',
  name: 'Name',
  file_name: 'File name',
  category: 'Category',
  description: 'Description',
  use: 'Use in the game',
  trigger: 'Trigger',
  duration_s: 'Length',
  duration_min_s: 'Length at least',
  duration_max_s: 'Length at most',
  length_locked: 'Exact length',
  frame_rate_fps: 'Frame rate',
  loop: 'Loop',
  reverb: 'Reverb',
  channels: 'Mono or stereo',
  variations: 'Variations',
  state: 'Design status',
  need: 'Need',
  phase: 'Phase',
  playback_priority: 'Playback priority',
  due_on: 'Needed by',
  placeholder: 'Placeholder in build',
  palette: 'Palette',
  implementer: 'Puts it in the game',
  implementer_id: 'Puts it in the game',
  recorder: 'Records it',
  recorder_id: 'Records it',
  extra: 'Custom columns',
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
      'duration_min_s',
      'duration_max_s',
      'length_locked',
      'frame_rate_fps',
      'loop',
      'reverb',
      'channels',
      'variations',
      'state',
      'need',
      'phase',
      'playback_priority',
      'due_on',
      'placeholder',
      'palette',
      'implementer',
      'recorder',
    ] as const
  ).map((value) => ({ value, label: fieldWord(value) })),
  { value: 'extra', label: 'Keep as custom column' },
  { value: 'ignore', label: 'Ignore' },
]

export const SETTLED = [
  { value: 'concept', label: 'Concept' },
  { value: 'prototype', label: 'In flux' },
  { value: 'locked', label: 'Locked' },
] as const

export const NEEDS = [
  { value: 'must', label: 'Must' },
  { value: 'should', label: 'Should' },
  { value: 'wish', label: 'Wish' },
] as const satisfies readonly { value: Need; label: string }[]

export const REVERBS = [
  { value: '', label: 'Unspecified' },
  { value: 'dry', label: 'Dry' },
  { value: 'designed-tail', label: 'Designed tail' },
  { value: 'separate-tail', label: 'Separate tail file' },
] as const

export const CHANNELS = [
  { value: '', label: 'As the spec says' },
  { value: 'mono', label: 'Mono' },
  { value: 'stereo', label: 'Stereo' },
] as const

const VALUE_WORDS: Record<string, Record<string, string>> = {
  state: { concept: 'concept', prototype: 'prototype', locked: 'locked', cut: 'cut' },
  reverb: Object.fromEntries(REVERBS.map(({ value, label }) => [value, label.toLowerCase()])),
}

/** A fact as a sentence can hold it: "0.80 s", "yes", "none". */
export function valueWord(field: string, value: unknown): string {
  if (value === null || value === undefined || value === '') return 'none'
  if (typeof value === 'boolean') return value ? 'yes' : 'no'
  if (typeof value === 'number') return field.startsWith('duration_') ? length(value) : String(value)
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
