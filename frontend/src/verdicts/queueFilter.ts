import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']

/** What of the queue is wanted, as it stands in the address; what is left out filters nothing. */
export interface QueueFilter {
  category?: string
  designer?: string
  /** The last target date. */
  due?: string
  need?: Schemas['Need']
  kind?: Schemas['QueueKind']
  version?: Schemas['VersionKind']
  /** Of which a version waits that the current person has not heard. */
  heard?: 'no'
  q?: string
}

const NAMES = ['category', 'designer', 'due', 'need', 'kind', 'version', 'heard', 'q'] as const

/** The filter in an address; anything else there is left out. */
export function filterOf(search: object): QueueFilter {
  const entries = NAMES.flatMap((name) => {
    const value: unknown = (search as Record<string, unknown>)[name]
    const isKnown = name !== 'heard' || value === 'no'
    return typeof value === 'string' && value !== '' && isKnown ? [[name, value]] : []
  })
  return Object.fromEntries(entries) as QueueFilter
}

export const isFiltered = (filter: QueueFilter): boolean => Object.keys(filter).length > 0

/** The filter as the server takes it. */
export const asked = ({ designer, due, heard, ...filter }: QueueFilter) => ({
  ...filter,
  ...(heard && { unheard: true }),
  designer_id: designer,
  due_by: due,
})
