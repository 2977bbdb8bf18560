/** A sound's shape as the server measured it, channels merged. */
export interface Peaks {
  points: number
  /** The value of full scale: 127 in the whole numbers of a thumb, as stated in the fine peaks of a sound. */
  fullScale?: number
  min: readonly number[]
  max: readonly number[]
  rms: readonly number[]
}

export interface Columns {
  min: Float32Array
  max: Float32Array
  rms: Float32Array
}

const FULL = 127

/** The fine peaks of one sound: in steps of the full scale that they name, or parts of it where they name none. */
export const finePeaks = ({ full_scale, ...read }: Omit<Peaks, 'fullScale'> & { full_scale?: number }): Peaks => ({
  ...read,
  fullScale: full_scale ?? 1,
})

/** One value a column of pixels, full scale ±1. Extremes stay extremes, and nothing is ever scaled up to fill. */
export function columnsOf(peaks: Peaks, count: number): Columns {
  const points = Math.min(peaks.points, peaks.min.length, peaks.max.length, peaks.rms.length)
  const columns = { min: new Float32Array(count), max: new Float32Array(count), rms: new Float32Array(count) }
  if (points === 0) return columns
  for (let column = 0; column < count; column += 1) {
    if (count <= points) gather(peaks, points, count, column, columns)
    else between(peaks, points, count, column, columns)
  }
  return columns
}

function gather(peaks: Peaks, points: number, count: number, column: number, into: Columns): void {
  const from = Math.floor((column * points) / count)
  const to = Math.max(from + 1, Math.floor(((column + 1) * points) / count))
  const full = peaks.fullScale ?? FULL
  let min = Infinity
  let max = -Infinity
  let squares = 0
  for (let point = from; point < to; point += 1) {
    min = Math.min(min, peaks.min[point] ?? 0)
    max = Math.max(max, peaks.max[point] ?? 0)
    squares += (peaks.rms[point] ?? 0) ** 2
  }
  into.min[column] = min / full
  into.max[column] = max / full
  into.rms[column] = Math.sqrt(squares / (to - from)) / full
}

function between(peaks: Peaks, points: number, count: number, column: number, into: Columns): void {
  const at = Math.min(points - 1, Math.max(0, ((column + 0.5) * points) / count - 0.5))
  const left = Math.floor(at)
  const right = Math.min(points - 1, left + 1)
  const part = at - left
  const mix = (values: readonly number[]) =>
    ((values[left] ?? 0) * (1 - part) + (values[right] ?? 0) * part) / (peaks.fullScale ?? FULL)
  into.min[column] = mix(peaks.min)
  into.max[column] = mix(peaks.max)
  into.rms[column] = mix(peaks.rms)
}

/** The level over time in dBFS, averaged over a window: what the level strip draws. −Infinity is silence. */
export function levelsOf(peaks: Peaks, durationS: number, windowS = 0.02): Float32Array {
  const levels = new Float32Array(peaks.points)
  const half = Math.max(0, Math.round(((windowS / Math.max(durationS, 1e-9)) * peaks.points) / 2))
  for (let point = 0; point < peaks.points; point += 1) {
    const from = Math.max(0, point - half)
    const to = Math.min(peaks.points, point + half + 1)
    let squares = 0
    for (let at = from; at < to; at += 1) squares += ((peaks.rms[at] ?? 0) / (peaks.fullScale ?? FULL)) ** 2
    levels[point] = 10 * Math.log10(squares / (to - from))
  }
  return levels
}

/** dBFS to a share of full scale: −6.02 gives 0.5. */
export const amplitudeOf = (dbfs: number): number => 10 ** (dbfs / 20)
