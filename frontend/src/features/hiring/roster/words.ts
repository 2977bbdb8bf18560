import type { components } from '@/api/schema.gen'
import { shortDay } from '@/ui/format'

type Schemas = components['schemas']
type Row = Schemas['RosterRow']
export type Service = Row['services'][number]
export type Week = Row['weeks'][number]
export type Busy = Schemas['BusyRangeWrite']
export type Rate = Schemas['RosterRate']

/** What the roster is searched for, kept in the address. */
export interface RosterSearch {
  studio?: string
  q?: string
  speciality?: string
  service?: Service
  language?: string
  /** The days that have to be free, as in 2026-11-20. */
  from?: string
  to?: string
}

export const SERVICE_WORDS: Record<Service, string> = {
  composes: 'Composes music',
  directs: 'Directs voice',
  supplies_talent: 'Supplies voice talent',
  narration: 'Records narration',
  field_recording: 'Records in the field',
  implements: 'Implements in the engine',
}
export const SERVICES = Object.keys(SERVICE_WORDS) as Service[]

export const EXCLUSIVITY_WORDS: Record<Row['exclusivity'], string> = {
  unknown: 'Not known',
  alone: 'One project at a time',
  several: 'Several projects at once',
}

export const WEEK_WORDS: Record<Week, string> = {
  free: 'free',
  half_days: 'half days',
  partly: 'partly booked',
  booked: 'booked',
}

export const FIELD_WORDS: Record<Schemas['RosterImportColumn']['field'], string> = {
  name: 'Name',
  email: 'Email',
  specialities: 'Specialities',
  services: 'Services',
  languages: 'Languages',
  equipment: 'Equipment',
  credits: 'Credits',
  referees: 'References',
  links: 'Links',
  exclusivity: 'Exclusivity',
  weekly_hours: 'Hours a week',
  available_from_on: 'Available from',
  rate: 'Rate',
  notes: 'Notes',
  ignore: 'Do not import',
}

/** "30 Nov to 11 Dec, half days, another game". */
export const busyInWords = ({ from_on: from, to_on: to, kind, note }: Busy): string =>
  [
    from === to ? shortDay(from) : `${shortDay(from)} to ${shortDay(to)}`,
    kind === 'half_days' ? 'half days' : '',
    note ?? '',
  ]
    .filter(Boolean)
    .join(', ')

/** Words that were typed with commas between them. */
export const listed = (typed: string): string[] =>
  typed
    .split(',')
    .map((word) => word.trim())
    .filter(Boolean)
