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
  const wanted = typed.trim().toLowerCase()
  if (wanted === '') return null
  const exact = cues.find((one) =>
    [nameOfSound(one), one.cue.name, one.cue.label].some((name) => name.toLowerCase() === wanted),
  )
  if (exact) return exact
  const found = cues.filter((one) => nameOfSound(one).toLowerCase().includes(wanted))
  return found.length === 1 ? (found[0] ?? null) : null
}

export const withMoment = ({ moments, nextId }: Moments, atS: number, said: HeardAs): Moments => ({
  moments: [...moments, { id: nextId, atS, said, sound: '', text: '' }].toSorted((one, other) => one.atS - other.atS),
  nextId: nextId + 1,
})

export const withChange = (now: Moments, id: number, change: Partial<Moment>): Moments => ({
  ...now,
  moments: now.moments.map((one) => (one.id === id ? { ...one, ...change } : one)),
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
