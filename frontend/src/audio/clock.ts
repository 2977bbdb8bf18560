import { type RefObject, useEffect } from 'react'

/** Where a sound is being played, asked at every frame without drawing the page again. */
export interface Clock {
  positionS: () => number
  isPlaying: () => boolean
  /** Called at every step of the playhead. */
  subscribe: (listener: () => void) => () => void
}

/** Keep `--at`, the played share 0..1, on an element; a figure that stands still needs no clock. */
export function useAt(
  ref: RefObject<HTMLElement | null>,
  durationS: number,
  playheadS: number | undefined,
  clock: Clock | undefined,
): void {
  useEffect(() => {
    const set = (s: number) => {
      const share = durationS > 0 ? Math.min(1, Math.max(0, s / durationS)) : 0
      ref.current?.style.setProperty('--at', String(share))
    }
    if (clock === undefined) {
      set(playheadS ?? 0)
      return
    }
    const step = () => set(clock.positionS())
    step()
    return clock.subscribe(step)
  }, [ref, durationS, playheadS, clock])
}
