import { queryById } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import type { Cue, FieldChange } from './api'

export type CuePerson = components['schemas']['CuePersonRead']

/** Who may be named as implementer or recorder of a cue; a designer is answered with themselves alone. */
export const cuePeopleQuery = queryById('/v1/projects/{project_id}/cue-people', (projectId) =>
  queryKeys.soundList(projectId, 'people'),
)

export type Task = 'implementer' | 'recorder'

/** What a person does for a cue: the column of a sheet, and the fact of a cue. */
export const TASKS = [
  { task: 'implementer', fact: 'implementer_id', label: 'Puts it in the game' },
  { task: 'recorder', fact: 'recorder_id', label: 'Records it' },
] as const satisfies readonly { task: Task; fact: keyof Cue; label: string }[]

/** A person who does a task, as the address of a list keeps it: `recorder:` and an id; `none` for no one. */
export type PersonFilter = `${Task}:${string}`

export const readPersonFilter = (value: unknown): PersonFilter | undefined =>
  typeof value === 'string' && /^(implementer|recorder):[\w-]+$/.test(value) ? (value as PersonFilter) : undefined

export function isOf(cue: Cue, filter: PersonFilter): boolean {
  const [task, id] = filter.split(':')
  const named = task === 'implementer' ? cue.implementer_id : cue.recorder_id
  return id === 'none' ? named === null : named === id
}

export const namesOf = (people: readonly CuePerson[]): ReadonlyMap<string, string> =>
  new Map(people.map(({ id, name }) => [id, name]))

/** Changes with people by their names. */
export const withPeopleNames = (changes: readonly FieldChange[], people: readonly CuePerson[]): FieldChange[] => {
  const names = namesOf(people)
  return changes.map((change) =>
    TASKS.some(({ fact }) => fact === change.field)
      ? {
          field: change.field,
          before: names.get(String(change.before)) ?? null,
          after: names.get(String(change.after)) ?? null,
        }
      : change,
  )
}
