/** How a game plays a set: how often, and how far pitch and level stray from one time to the next. */
export interface SetPlaybackMode {
  /** From one start to the next; null: each starts when the one before is over. */
  intervalS: number | null
  /** Up or down by at most so much. */
  pitchSemitones: number
  /** Within this much above and below their middle; the loudest is as loud as delivered, or as matched. */
  levelDb: number
}

export const IN_ORDER: SetPlaybackMode = { intervalS: null, pitchSemitones: 0, levelDb: 0 }

/** One time that a variation of the set is played. */
export interface Hit {
  index: number
  /** Since the first one. */
  atS: number
  /** 2 is an octave up, and half as long. */
  speed: number
  gainDb: number
}

/** Play variations of these lengths without end, at random, never the same twice running. */
export function* hitsOf(
  durationsS: readonly number[],
  way: SetPlaybackMode,
  random: () => number,
): Generator<Hit, never> {
  let index = -1
  let atS = 0
  for (;;) {
    index = nextInSet(index, durationsS.length, random)
    const speed = 2 ** ((way.pitchSemitones * (2 * random() - 1)) / 12)
    const gainDb = -2 * way.levelDb * random()
    yield { index, atS, speed, gainDb }
    atS += way.intervalS ?? (durationsS[index] ?? 0) / speed
  }
}

/** Any variation but the last one, each as likely as the others. */
export function nextInSet(last: number, count: number, random: () => number): number {
  if (count <= 1) return 0
  if (last < 0) return Math.floor(random() * count)
  const step = 1 + Math.floor(random() * (count - 1))
  return (last + step) % count
}
