import type { TimeRange } from './draw'
import type { PlayerState, Source } from './playerState'
import type { Wanted } from './previews'

/** What repeats, in the buffer as it is played; null without a loop. */
export function loopOf({ looping, range, reversed }: PlayerState, durationS: number): TimeRange | null {
  if (!looping) return null
  const startS = Math.max(0, range?.startS ?? 0)
  const endS = Math.min(durationS, range?.endS ?? durationS)
  if (endS <= startS) return { startS: 0, endS: durationS }
  return reversed ? { startS: durationS - endS, endS: durationS - startS } : { startS, endS }
}

/** Where playing starts by default: at the current position, or from the start after the end. */
export function startOf({ reversed }: PlayerState, positionS: number, durationS: number): number {
  if (reversed) return positionS <= 0 ? durationS : Math.min(positionS, durationS)
  return positionS >= durationS ? 0 : positionS
}

/** What a beginning of a sound must hold to play from there; null where all of it is needed. */
export function wantedOf({ durationS, place }: Source, state: PlayerState, positionS: number): Wanted | null {
  const { reversed, looping, range } = state
  if (durationS === undefined || place || reversed || (looping && range)) return null
  return { durationS, fromS: startOf(state, positionS, durationS) }
}
