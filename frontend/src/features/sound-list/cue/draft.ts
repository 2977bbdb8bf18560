import type { ApiProblem } from '@/api'

import type { Cue, CueAdd, CueFacts, FieldChange } from '../api'

/** A cue as form fields: figures are as typed. */
export interface CueDraft {
  name: string
  file_name: string
  category: string
  use: string
  description: string
  trigger: string
  duration_s: string
  duration_min_s: string
  duration_max_s: string
  length_locked: boolean
  frame_rate_fps: string
  loop: boolean
  reverb: string
  channels: string
  variations: string
  state: string
  need: string
  phase: string
  playback_priority: string
  due_on: string
  placeholder: boolean
  palette: boolean
  /** Ids of people; empty for no one. */
  implementer_id: string
  recorder_id: string
  /** Values in the project's own columns, and in kept ones, by the column's name. */
  extra: Record<string, string>
}

export type DraftValue = CueDraft[DraftField]

export type DraftField = keyof CueDraft
export type Faults = Partial<Record<DraftField, string>>

export const EMPTY_DRAFT: CueDraft = {
  name: '',
  file_name: '',
  category: '',
  use: '',
  description: '',
  trigger: '',
  duration_s: '',
  duration_min_s: '',
  duration_max_s: '',
  length_locked: false,
  frame_rate_fps: '',
  loop: false,
  reverb: '',
  channels: '',
  variations: '1',
  state: 'concept',
  need: 'must',
  phase: '',
  playback_priority: '',
  due_on: '',
  placeholder: false,
  palette: false,
  implementer_id: '',
  recorder_id: '',
  extra: {},
}

const FIELDS = Object.keys(EMPTY_DRAFT) as DraftField[]

const typed = (value: number | null): string => (value === null ? '' : String(value))

export function draftOf(cue: Cue): CueDraft {
  return {
    ...EMPTY_DRAFT,
    ...Object.fromEntries(FIELDS.map((field) => [field, cue[field]])),
    duration_s: typed(cue.duration_s),
    duration_min_s: typed(cue.duration_min_s),
    duration_max_s: typed(cue.duration_max_s),
    frame_rate_fps: typed(cue.frame_rate_fps),
    playback_priority: typed(cue.playback_priority),
    variations: String(cue.variations),
    reverb: cue.reverb ?? '',
    channels: cue.channels ?? '',
    phase: cue.phase ?? '',
    due_on: cue.due_on ?? '',
    implementer_id: cue.implementer_id ?? '',
    recorder_id: cue.recorder_id ?? '',
  }
}

interface Figure {
  expected: string
  whole?: true
  needed?: true
}

const FIGURES: Partial<Record<DraftField, Figure>> = {
  duration_s: { expected: 'seconds such as 1.5' },
  duration_min_s: { expected: 'seconds such as 0.5' },
  duration_max_s: { expected: 'seconds such as 2' },
  frame_rate_fps: { expected: 'frames a second such as 60' },
  variations: { expected: 'a whole number such as 4', whole: true, needed: true },
  playback_priority: { expected: 'a whole number such as 1', whole: true },
}

/** Read a figure with a point or a comma; nothing typed is null. */
function readFigure(text: string, { expected, whole, needed }: Figure): number | null | { fault: string } {
  const plain = text.trim().replace(',', '.').replace(/\s*s$/, '')
  if (plain === '') return needed ? 1 : null
  const value = Number(plain)
  if (!/^[0-9]*\.?[0-9]*$/.test(plain) || Number.isNaN(value) || (whole && !Number.isInteger(value))) {
    return { fault: `Enter ${expected} (found “${text.trim()}”).` }
  }
  return value
}

export interface ReadDraft {
  facts: CueAdd
  faults: Faults
}

/** What a draft says, and what in it cannot be read. */
export function readDraft(draft: CueDraft): ReadDraft {
  const facts: Record<string, unknown> = { ...draft }
  for (const field of ['reverb', 'channels', 'phase', 'due_on', 'implementer_id', 'recorder_id'] as const)
    facts[field] = draft[field] || null
  const faults: Faults = {}
  for (const [field, figure] of Object.entries(FIGURES) as [DraftField, Figure][]) {
    const read = readFigure(draft[field] as string, figure)
    if (read !== null && typeof read === 'object') faults[field] = read.fault
    else facts[field] = read
  }
  if (draft.name.trim() === '' && draft.file_name.trim() === '') faults.name = 'Enter a name.'
  return { facts: facts as unknown as CueAdd, faults }
}

const isSame = (a: unknown, b: unknown): boolean =>
  a === b || (typeof a === 'object' && JSON.stringify(a) === JSON.stringify(b))

/** The fields that differ from what was read. */
export const touched = (base: Cue, draft: CueDraft): DraftField[] => {
  const before = draftOf(base)
  return FIELDS.filter((field) => !isSame(before[field], draft[field]))
}

/** Only the changed fields, so that another person's changes are kept. */
export function changedFacts(base: Cue, draft: CueDraft): CueFacts {
  const { facts } = readDraft(draft)
  return Object.fromEntries(touched(base, draft).map((field) => [field, facts[field]]))
}

/** What another person changed between two readings of a cue. */
export function changesBetween(base: Cue, fresh: Cue): FieldChange[] {
  return FIELDS.filter((field) => !isSame(base[field], fresh[field])).map((field) => ({
    field,
    before: base[field],
    after: fresh[field],
  }))
}

/** A draft on top of a newer reading: what was touched stays as it was typed, the rest is as it is now. */
export function rebased(base: Cue, fresh: Cue, draft: CueDraft): CueDraft {
  const mine = Object.fromEntries(touched(base, draft).map((field) => [field, draft[field]]))
  return { ...draftOf(fresh), ...mine, extra: rebasedValues(base.extra, fresh.extra, draft.extra) }
}

function rebasedValues(base: Cue['extra'], fresh: Cue['extra'], typed: CueDraft['extra']): CueDraft['extra'] {
  const mine = Object.entries(typed).filter(([column, text]) => text !== (base[column] ?? ''))
  return { ...fresh, ...Object.fromEntries(mine) }
}

const isField = (name: string | undefined): name is DraftField =>
  name !== 'extra' && FIELDS.includes(name as DraftField)

const asSentence = (message: string): string =>
  `${message.charAt(0).toUpperCase()}${message.slice(1)}${/[.!?]$/.test(message) ? '' : '.'}`

/** What a refusal says against the fields of one row, and against the whole of it. */
export interface Refused {
  fields: Faults
  whole: string[]
}

/** The refusals of rows, by their place from 0; `row 2: name` and `cues.1.name` are the same place. */
export function refusedRows(problem: ApiProblem): Map<number, Refused> {
  const rows = new Map<number, Refused>()
  for (const { field: where, message } of problem.errors) {
    const row = /^row (\d+): (\w+)$/.exec(where)
    const path = /(?:^|\.)cues\.(\d+)(?:\.(\w+))?/.exec(where)
    const place = row ? Number(row[1]) - 1 : path ? Number(path[1]) : 0
    const name = row?.[2] ?? path?.[2] ?? where.split('.').at(-1)
    const refused = rows.get(place) ?? { fields: {}, whole: [] }
    if (isField(name)) refused.fields[name] = asSentence(message)
    else
      refused.whole.push(row || path || name === undefined ? asSentence(message) : `${where}: ${asSentence(message)}`)
    rows.set(place, refused)
  }
  return rows
}
