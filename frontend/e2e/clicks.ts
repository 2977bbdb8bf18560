/** Clicks that encode where in a sound they are: each is two pulses, and the later it comes, the farther they are apart. */
export const CLICK_EVERY_S = 0.2
export const FIRST_GAP_MS = 5
export const GAP_STEP_MS = 0.2
const PULSE_S = 0.001

/** Where the middle of the first pulse of a click is. */
export const positionOfClickS = (number: number): number => (number + 0.5) * CLICK_EVERY_S

/** The value of such a sound at a time, within ±1. */
export function clicksAt(s: number): number {
  const number = Math.floor(s / CLICK_EVERY_S)
  const gapS = (FIRST_GAP_MS + GAP_STEP_MS * number) / 1_000
  const pulse = (middleS: number) => {
    const away = Math.abs(s - middleS) / PULSE_S
    return away < 0.5 ? (1 + Math.cos(2 * Math.PI * away)) / 2 : 0
  }
  const firstS = positionOfClickS(number)
  return pulse(firstS) - pulse(firstS + gapS)
}
