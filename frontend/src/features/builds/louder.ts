import type { Peaks } from '@/audio'

/** The shape of a sound at another level; what goes beyond full scale is cut there, as the game's output cuts it. */
export function louder(peaks: Peaks, gainDb: number): Peaks {
  const factor = 10 ** (gainDb / 20)
  const full = peaks.fullScale ?? 127
  const scaled = (values: readonly number[]) => values.map((value) => Math.max(-full, Math.min(full, value * factor)))
  return { ...peaks, min: scaled(peaks.min), max: scaled(peaks.max), rms: scaled(peaks.rms) }
}
