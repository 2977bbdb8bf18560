import type { Peaks } from '@/audio'
import type { Phase } from '@/phases'
import { figure, plural } from '@/ui/format'
import type { Need } from '@/ui/NeedMark'
import type { NeedSum } from '@/ui/NeedSums'
import type { SetBlock } from '@/ui/SetBlocks'
import { STATES, type StateKind } from '@/ui/StatusBadge'

import type { Cue, CueStatus, Question, CueProgress, Take } from './api'
import type { FactQuestion } from './clarity'
import { isOf, type PersonFilter } from './people'
import { type Stands, standsOf } from './stands'
import { NEEDS, STATUS_ORDER, STATUS_WORDS } from './words'

/** One line of the list with everything that it shows. */
export interface CueRow {
  id: string
  cue: Cue
  progress: CueProgress | undefined
  status: CueStatus
  kind: StateKind
  /** Other words than the state's own, as "5 of 8 accepted". */
  stateWords?: string
  stands: Stands
  /** What its words leave open to a designer. */
  unclear: readonly FactQuestion[]
  /** A version of it waits or is approved that the current person has not heard. */
  isUnheard: boolean
  /** An action is needed: the name is bold. */
  needsSomeone: boolean
  peaks: Peaks | null
  previewUrl: string | null
  /** Everything that the filter searches, in small letters. */
  text: string
}

export interface Known {
  progressList?: readonly CueProgress[]
  questions?: readonly Question[]
  unmatched?: readonly Take[]
  unclear?: ReadonlyMap<string, readonly FactQuestion[]>
}

export const kindOf = (status: CueStatus): StateKind => (status === 'partly_accepted' ? 'accepted' : status)

const NOTHING: readonly FactQuestion[] = []
const RESTING: readonly CueStatus[] = ['to_make', 'checking', 'accepted', 'cut']

/** Join what the list says with where each cue stands. */
export function rowsOf(
  cues: readonly Cue[],
  { progressList, questions, unmatched, unclear }: Known,
  now = new Date(),
): CueRow[] {
  const progressOf = new Map(progressList?.map((progress) => [progress.cue_id, progress]))
  const askedAt = new Map(questions?.toReversed().map((question) => [question.cue_id, question.asked_at]))
  const guessed = new Map(
    unmatched?.flatMap(({ file_name, sure, guesses }) => {
      const likeliest = sure ?? guesses[0]
      return likeliest ? [[likeliest.cue_id, file_name] as const] : []
    }),
  )
  return cues.map((cue) => {
    const progress = progressOf.get(cue.id)
    const status = cue.state === 'cut' ? 'cut' : (progress?.status ?? 'to_make')
    const open = (status === 'to_make' && unclear?.get(cue.id)) || NOTHING
    const beside = { askedAt: askedAt.get(cue.id), guessedFile: guessed.get(cue.id), unclear: open }
    const stands = standsOf(cue, progress, beside, now)
    const newest = progress?.newest_take
    return {
      id: cue.id,
      cue,
      progress,
      status,
      kind: kindOf(status),
      stateWords:
        status === 'partly_accepted' && progress ? `${progress.accepted} of ${progress.wanted} accepted` : undefined,
      stands,
      unclear: open,
      isUnheard: (progress?.unheard_take_ids.length ?? 0) > 0,
      needsSomeone: !RESTING.includes(status),
      // A picture is an open object in the schema; its shape is that of a thumb.
      peaks: (newest?.thumb ?? null) as Peaks | null,
      previewUrl: newest?.preview_url ?? null,
      text: [cue.label, cue.name, cue.file_name, cue.category, cue.use, cue.description, cue.trigger]
        .concat(Object.values(cue.extra), stands.before, stands.marked, stands.after)
        .join('\n')
        .toLowerCase(),
    }
  })
}

/** One block a variation, coloured by where it stands. */
export function blocksOf({ progress, cue }: CueRow): SetBlock[] {
  const status = new Map(progress?.variations.map((variation) => [variation.variation, variation.status]))
  return Array.from({ length: cue.variations }, (_, place) => {
    const state = status.get(place + 1)
    return { tone: state === undefined || state === 'to_make' ? 'idle' : STATES[kindOf(state)].tone }
  })
}

/** A cue of the palette is in that phase, whatever else it says. */
export const phaseOf = ({ palette, phase }: Cue): Phase | null => (palette ? 'palette' : phase)

export interface Filter {
  state?: CueStatus
  category?: string
  need?: Need
  phase?: Phase
  person?: PersonFilter
  unclear?: boolean
  heard?: 'no'
  /** The take in the player: its cue stays once it is heard. */
  playedId?: string | null
  words: string
}

/** The rows that match: every typed word must stand somewhere in the row. */
export function matching(rows: readonly CueRow[], filter: Filter): CueRow[] {
  const { state, category, need, phase, person, unclear, heard, playedId, words } = filter
  const isPlayed = ({ progress }: CueRow) => playedId != null && progress?.newest_take?.id === playedId
  const terms = words.toLowerCase().split(/\s+/).filter(Boolean)
  return rows.filter(
    (row) =>
      (state === undefined || row.status === state) &&
      (category === undefined || row.cue.category === category) &&
      (need === undefined || row.cue.need === need) &&
      (phase === undefined || phaseOf(row.cue) === phase) &&
      (person === undefined || isOf(row.cue, person)) &&
      (!unclear || row.unclear.length > 0) &&
      (heard === undefined || row.isUnheard || isPlayed(row)) &&
      terms.every((word) => row.text.includes(word)),
  )
}

export type Grouping = 'list' | 'category' | 'state' | 'priority'

/** What the list leaves out, and how it is grouped; shared by its address. */
export interface ListSearch {
  state?: CueStatus
  category?: string
  need?: Need
  phase?: Phase
  /** Who puts the cue in the game or records it. */
  person?: PersonFilter
  by?: Grouping
  /** Which columns the table has; what the cues are, or where they stand. */
  view?: 'content'
  /** Only cues whose words leave something open. */
  unclear?: true
  /** Only cues with a version that the current person has not heard. */
  heard?: 'no'
  /** Words that were typed to filter by. */
  q?: string
}

export interface Group {
  id: string
  name: string
  note: string
  rows: CueRow[]
}

function progress(rows: readonly CueRow[]): string {
  const live = rows.filter(({ status }) => status !== 'cut')
  const accepted = live.filter(({ status }) => status === 'accepted').length
  const cut = rows.length - live.length
  return [`${figure(accepted)} of ${figure(live.length)} accepted`, cut > 0 ? `${figure(cut)} cut` : '']
    .filter(Boolean)
    .join(', ')
}

/** The rows under headings; the palette comes first in list order. */
export function groupsOf(rows: readonly CueRow[], by: Grouping): Group[] {
  if (by === 'state') {
    return STATUS_ORDER.map((status) => {
      const own = rows.filter((row) => row.status === status)
      const name = STATUS_WORDS[status] ?? STATES[kindOf(status)].word
      return { id: status, name, note: plural(own.length, 'cue'), rows: own }
    }).filter((group) => group.rows.length > 0)
  }
  if (by === 'priority') {
    const ranked = rows.filter(({ cue }) => cue.playback_priority !== null)
    ranked.sort((a, b) => (a.cue.playback_priority ?? 0) - (b.cue.playback_priority ?? 0))
    const unranked = rows.filter(({ cue }) => cue.playback_priority === null)
    return [
      { id: 'priority set', name: 'By playback priority, 0 first', note: plural(ranked.length, 'cue'), rows: ranked },
      { id: 'priority none', name: 'No playback priority', note: plural(unranked.length, 'cue'), rows: unranked },
    ].filter((group) => group.rows.length > 0)
  }
  const parts = new Map<string, CueRow[]>()
  for (const row of rows) {
    const part = by === 'category' ? row.cue.category : row.cue.palette ? 'palette' : 'rest'
    parts.set(part, [...(parts.get(part) ?? []), row])
  }
  const names = [...parts.keys()]
  if (by === 'list') names.sort((a, b) => Number(b === 'palette') - Number(a === 'palette'))
  else names.sort((a, b) => Number(a === '') - Number(b === '') || a.localeCompare(b))
  const heads: Record<string, string> = by === 'list' ? { palette: 'Palette', rest: 'The rest' } : { '': 'No category' }
  return names.map((id) => {
    const own = parts.get(id) ?? []
    return { id: `${by} ${id}`, name: heads[id] ?? id, note: progress(own), rows: own }
  })
}

/** How many cues of each need are accepted, cut ones left out. */
export function needSumsOf(rows: readonly CueRow[]): NeedSum[] {
  return NEEDS.map(({ value: need }) => {
    const own = rows.filter(({ cue, status }) => cue.need === need && status !== 'cut')
    return { need, accepted: own.filter(({ status }) => status === 'accepted').length, cues: own.length }
  }).filter(({ cues }) => cues > 0)
}

/** Every category of the list, for the select and for typing. */
export const categoriesOf = (rows: readonly { cue: Cue }[]): string[] =>
  [...new Set(rows.map(({ cue }) => cue.category).filter(Boolean))].sort((a, b) => a.localeCompare(b))

/** "9 of 23 accepted; 1 cut; 14 files to review". */
export function sumsOf(rows: readonly CueRow[], filesToReview: number): string {
  return [progress(rows).replace(', ', '; '), filesToReview > 0 ? `${plural(filesToReview, 'file')} to review` : '']
    .filter(Boolean)
    .join('; ')
}
