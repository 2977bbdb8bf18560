import type { Reference } from '@/references'

/** What a reference is pinned to, as a choice: empty for the whole project, else `cue:…` or `category:…`. */
export type Pin = string

export const pinOf = ({ cue, category }: Pick<Reference, 'cue' | 'category'>): Pin => {
  if (cue) return `cue:${cue.id}`
  return category === null ? '' : `category:${category}`
}

/** A pin as the server reads it. */
export const bodyOfPin = (pin: Pin): { cue_id: string | null; category: string | null } => ({
  cue_id: pin.startsWith('cue:') ? pin.slice('cue:'.length) : null,
  category: pin.startsWith('category:') ? pin.slice('category:'.length) : null,
})

export interface Group {
  key: Pin
  name: string
  /** What kind of pin it is, beside the name. */
  kind: 'project' | 'category' | 'cue'
  references: Reference[]
}

/** The board in its order: the whole project, categories by name, cues by number. */
export function groupsOf(references: readonly Reference[]): Group[] {
  const groups = new Map<Pin, Group & { order: string }>()
  for (const reference of references) {
    const key = pinOf(reference)
    const { cue, category } = reference
    const kind = cue ? 'cue' : category === null ? 'project' : 'category'
    const order = cue ? `2 ${String(cue.number).padStart(9, '0')}` : category === null ? '0' : `1 ${category}`
    const group = groups.get(key) ?? {
      key,
      kind,
      name: cue?.name ?? category ?? 'Whole project',
      references: [],
      order,
    }
    group.references.push(reference)
    groups.set(key, group)
  }
  return [...groups.values()].toSorted((a, b) => (a.order < b.order ? -1 : 1))
}

/** Seconds as they are typed: "41.2", "0:41.2"; undefined for anything else, null for nothing. */
export function secondsOf(text: string): number | null | undefined {
  const typed = text.trim().replace(',', '.')
  if (typed === '') return null
  const match = /^(?:(\d{1,3}):)?(\d{1,5}(?:\.\d{1,3})?)$/.exec(typed)
  if (!match || (match[1] !== undefined && Number(match[2]) >= 60)) return undefined
  return Number(match[1] ?? 0) * 60 + Number(match[2])
}
