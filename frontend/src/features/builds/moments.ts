import type { CueToHear, HeardAs } from './api'

/** What was heard at one moment of a recording, before it is a note. */
export interface Moment {
  id: number
  atS: number
  said: HeardAs
  /** What was typed to find its sound. */
  sound: string
  text: string
}

export interface Moments {
  moments: readonly Moment[]
  nextId: number
}

export const NO_MOMENTS: Moments = { moments: [], nextId: 1 }

/** A sound as the field of a moment offers it: with what begins it in the game, so that an event finds it too. */
export const nameOfSound = ({ cue, events }: CueToHear): string =>
  `${cue.label} ${cue.name}${events.length > 0 ? ` (${events.join(', ')})` : ''}`

/** The sound that is meant: the one that is named, else the only one that has what was typed. */
export function soundOf(typed: string, cues: readonly CueToHear[]): CueToHear | null {
  const query = typed.trim().toLowerCase()
  if (query === '') return null
  const exact = cues.find((cue) =>
    [nameOfSound(cue), cue.cue.name, cue.cue.label].some((name) => name.toLowerCase() === query),
  )
  if (exact) return exact
  const matches = cues.filter((cue) => nameOfSound(cue).toLowerCase().includes(query))
  return matches.length === 1 ? (matches[0] ?? null) : null
}

export const withMoment = ({ moments, nextId }: Moments, atS: number, heardAs: HeardAs): Moments => ({
  moments: [...moments, { id: nextId, atS, said: heardAs, sound: '', text: '' }].toSorted((a, b) => a.atS - b.atS),
  nextId: nextId + 1,
})

export const withChange = (now: Moments, id: number, change: Partial<Moment>): Moments => ({
  ...now,
  moments: now.moments.map((moment) => (moment.id === id ? { ...moment, ...change } : moment)),
})

export const without = (now: Moments, ids: ReadonlySet<number>): Moments => ({
  ...now,
  moments: now.moments.filter(({ id }) => !ids.has(id)),
})

/** "1:05.2", as players count. */
export function timeOf(s: number): string {
  const tenths = Math.round(s * 10)
  return `${Math.floor(tenths / 600)}:${String(Math.floor((tenths % 600) / 10)).padStart(2, '0')}.${tenths % 10}`
}
