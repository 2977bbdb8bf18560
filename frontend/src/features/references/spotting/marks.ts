/** A place in a clip where a sound is needed. */
export interface Mark {
  id: number
  startS: number
  /** Null where only the beginning was marked. */
  lengthS: number | null
  name: string
  /** Null: the one that its name speaks of. */
  category: string | null
}

/** The marks of a clip, as they are kept in this browser until they are cues. */
export interface Spotted {
  marks: readonly Mark[]
  nextId: number
  /** Frames a second, where a person chose them. */
  frameRate: number | null
}

export const NO_MARKS: Spotted = { marks: [], nextId: 1, frameRate: null }
export const FRAME_RATES = [23.976, 24, 25, 29.97, 30, 50, 59.94, 60] as const
export const USUAL_RATE = 30
/** A press that is shorter marks a beginning only. */
export const HELD_S = 0.25
const SHORTEST_S = 0.001

const toMs = (s: number): number => Math.round(s * 1000) / 1000

const inOrder = (marks: readonly Mark[]): Mark[] => marks.toSorted((a, b) => a.startS - b.startS || a.id - b.id)

/** Add a mark where a sound begins. */
export function withMark(spotted: Spotted, atS: number): Spotted {
  const mark: Mark = { id: spotted.nextId, startS: toMs(Math.max(0, atS)), lengthS: null, name: '', category: null }
  return { ...spotted, marks: inOrder([...spotted.marks, mark]), nextId: spotted.nextId + 1 }
}

/** Change what is known of one mark; a length below a millisecond is none. */
export function withChange(spotted: Spotted, id: number, change: Partial<Omit<Mark, 'id'>>): Spotted {
  const changed = spotted.marks.map((mark) => {
    if (mark.id !== id) return mark
    const { startS, lengthS, ...rest } = { ...mark, ...change }
    const isLong = lengthS !== null && lengthS >= SHORTEST_S
    return { ...rest, startS: toMs(Math.max(0, startS)), lengthS: isLong ? toMs(lengthS) : null }
  })
  return { ...spotted, marks: inOrder(changed) }
}

/** Move a mark by some seconds. */
export function withShift(spotted: Spotted, id: number, byS: number): Spotted {
  const mark = spotted.marks.find((candidate) => candidate.id === id)
  return mark ? withChange(spotted, id, { startS: mark.startS + byS }) : spotted
}

export const withoutMark = (spotted: Spotted, id: number): Spotted => ({
  ...spotted,
  marks: spotted.marks.filter((mark) => mark.id !== id),
})

/** The mark that follows another one, or the first or last where none is selected. */
export function neighbour(marks: readonly Mark[], id: number | null, by: 1 | -1): Mark | undefined {
  const at = marks.findIndex((mark) => mark.id === id)
  if (at < 0) return by > 0 ? marks[0] : marks.at(-1)
  return marks[Math.min(marks.length - 1, Math.max(0, at + by))]
}

/** What a cue is called: as typed, or by the clip and its place in it. */
export const nameOf = (mark: Mark, at: number, clip: string): string =>
  mark.name.trim() || `${clip.replace(/\.[^.]+$/, '')} ${at + 1}`

/** The frame rate that the times of successive frames speak of; null where they speak of none that is usual. */
export function frameRateOf(timesS: readonly number[]): number | null {
  const steps = timesS.slice(1).map((time, at) => time - (timesS[at] ?? 0))
  const shortest = Math.min(...steps.filter((step) => step > 0.001))
  if (!Number.isFinite(shortest)) return null
  const rate = 1 / shortest
  const nearest = FRAME_RATES.reduce((best, candidate) =>
    Math.abs(candidate - rate) < Math.abs(best - rate) ? candidate : best,
  )
  return Math.abs(nearest - rate) / rate < 0.03 ? nearest : null
}

/** An instant of a clip to the millisecond: 1:41.204. */
export function clock(s: number): string {
  const ms = Math.round(s * 1000)
  return `${Math.floor(ms / 60_000)}:${((ms % 60_000) / 1000).toFixed(3).padStart(6, '0')}`
}
