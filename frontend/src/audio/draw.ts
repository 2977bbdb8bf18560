import { amplitudeOf, type Columns, columnsOf, type Peaks } from './peaks'

/** A canvas in device pixels, and the tokens it draws with. */
export interface Surface {
  context: CanvasRenderingContext2D
  width: number
  height: number
  /** Device pixels a CSS pixel. */
  scale: number
  /** The value of a token: `colour('wave-peak')`. */
  colour: (token: string) => string
}

export interface TimeRange {
  startS: number
  endS: number
}

export interface WaveLook {
  /** Played, or selected. */
  highlighted: boolean
  /** What exceeds this is coloured as over the limit. */
  limitDbfs?: number
  /** CSS pixels left free above and below full scale. */
  pad?: number
}

const middleOf = ({ height }: Surface): number => height / 2
const reachOf = (surface: Surface, pad: number): number => surface.height / 2 - pad * surface.scale

/** The shape itself: peaks with the RMS as a darker core. */
export function drawWave(surface: Surface, peaks: Peaks, { highlighted, limitDbfs, pad = 1 }: WaveLook): void {
  const { context, width, colour, scale } = surface
  const columns = columnsOf(peaks, width)
  const middle = middleOf(surface)
  const reach = reachOf(surface, pad)
  const fill = (name: string, top: (column: number) => number, bottom: (column: number) => number) => {
    context.fillStyle = colour(name)
    for (let column = 0; column < width; column += 1) {
      const from = middle - top(column) * reach
      context.fillRect(column, from, 1, Math.max(scale, middle - bottom(column) * reach - from))
    }
  }
  const core = coreOf(columns)
  fill(
    highlighted ? 'wave-peak-on' : 'wave-peak',
    (column) => columns.max[column] ?? 0,
    (column) => columns.min[column] ?? 0,
  )
  fill(
    highlighted ? 'wave-rms-on' : 'wave-rms',
    (column) => core.top[column] ?? 0,
    (column) => core.bottom[column] ?? 0,
  )
  if (limitDbfs !== undefined) drawOver(surface, columns, amplitudeOf(limitDbfs), reach)
}

/** The RMS drawn round the middle of each column, inside its peaks: a one-sided sound keeps a one-sided core. */
function coreOf({ min, max, rms }: Columns): { top: Float32Array; bottom: Float32Array } {
  const top = new Float32Array(rms.length)
  const bottom = new Float32Array(rms.length)
  rms.forEach((value, column) => {
    top[column] = Math.min(value, max[column] ?? 0)
    bottom[column] = Math.max(-value, min[column] ?? 0)
  })
  return { top, bottom }
}

function drawOver(
  { context, colour, scale, ...surface }: Surface,
  { min, max }: Columns,
  limit: number,
  reach: number,
): void {
  const middle = surface.height / 2
  context.fillStyle = colour('wave-over')
  for (let column = 0; column < surface.width; column += 1) {
    const above = (max[column] ?? 0) - limit
    const below = -(min[column] ?? 0) - limit
    if (above > 0) context.fillRect(column, middle - (limit + above) * reach, 1, above * reach + scale)
    if (below > 0) context.fillRect(column, middle + limit * reach - scale, 1, below * reach + scale)
  }
}

/** The line of silence. */
export function drawAxis(surface: Surface): void {
  surface.context.fillStyle = surface.colour('wave-axis')
  surface.context.fillRect(0, Math.round(middleOf(surface)), surface.width, surface.scale)
}

/** Lines at round times, and at −6 and −12 dB. */
export function drawGrid(surface: Surface, durationS: number, stepS: number, pad = 1): void {
  const { context, width, height, scale, colour } = surface
  context.fillStyle = colour('wave-grid')
  const middle = middleOf(surface)
  const reach = reachOf(surface, pad)
  for (let line = 1; line * stepS < durationS; line += 1) {
    context.fillRect(Math.round((width * line * stepS) / durationS), 0, scale, height)
  }
  for (const db of [-6, -12]) {
    const away = amplitudeOf(db) * reach
    context.fillRect(0, Math.round(middle - away), width, scale)
    context.fillRect(0, Math.round(middle + away), width, scale)
  }
}

/** Dashed lines at the limit, above and below. */
export function drawLimit(surface: Surface, limitDbfs: number, pad = 1): void {
  const { context, width, scale, colour } = surface
  const away = amplitudeOf(limitDbfs) * reachOf(surface, pad)
  const middle = middleOf(surface)
  context.fillStyle = colour('wave-limit')
  for (let x = 0; x < width; x += 6 * scale) {
    context.fillRect(x, Math.round(middle - away), 3 * scale, scale)
    context.fillRect(x, Math.round(middle + away), 3 * scale, scale)
  }
}

/** Hatching over what a fix takes away. */
export function drawCuts(surface: Surface, cuts: readonly TimeRange[], durationS: number): void {
  const { context, width, height, scale, colour } = surface
  context.strokeStyle = colour('wave-cut')
  context.lineWidth = 1.2 * scale
  for (const { startS, endS } of cuts) {
    const from = (width * startS) / durationS
    const to = (width * endS) / durationS
    context.save()
    context.beginPath()
    context.rect(from, 0, to - from, height)
    context.clip()
    for (let x = from - height; x < to + height; x += 7 * scale) {
      context.beginPath()
      context.moveTo(x, height)
      context.lineTo(x + height, 0)
      context.stroke()
    }
    context.restore()
  }
}

export const LEVEL_FLOOR_DB = -48

/** The level over time as a filled line. */
export function drawLevels(surface: Surface, levels: Float32Array): void {
  const { context, width, height, scale, colour } = surface
  const y = (db: number) => (height * Math.max(LEVEL_FLOOR_DB, Math.min(0, db))) / LEVEL_FLOOR_DB
  context.fillStyle = colour('wave-grid')
  for (const db of [-12, -24, -36]) context.fillRect(0, Math.round(y(db)), width, scale)
  if (levels.length === 0) return
  context.beginPath()
  context.moveTo(0, height)
  for (let x = 0; x <= width; x += 1) {
    const at = Math.min(levels.length - 1, Math.floor((x / width) * levels.length))
    context.lineTo(x, y(levels[at] ?? LEVEL_FLOOR_DB))
  }
  context.lineTo(width, height)
  context.closePath()
  context.fillStyle = colour('wave-cut')
  context.fill()
  context.strokeStyle = colour('wave-rms-on')
  context.lineWidth = 1.25 * scale
  context.stroke()
}

/** A spectrogram of the server: rows from the highest frequency down, 0 quiet to 255 loud. */
export interface Spectrogram {
  columns: number
  rows: number
  values: ArrayLike<number>
}

type Rgb = [number, number, number]

/** "#0d0e0f" or "rgb(13 14 15)" as three numbers. */
export function rgbOf(colour: string): Rgb {
  const hex = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(colour)
  if (hex) return [parseInt(hex[1] ?? '0', 16), parseInt(hex[2] ?? '0', 16), parseInt(hex[3] ?? '0', 16)]
  const [red = 0, green = 0, blue = 0] = (colour.match(/[\d.]+/g) ?? []).map(Number)
  return [red, green, blue]
}

/** Ink by loudness between the two ends of the ramp, as RGBA bytes of the spectrogram's own size. */
export function inkOf({ columns, rows, values }: Spectrogram, quiet: Rgb, loud: Rgb): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(columns * rows * 4)
  for (let cell = 0; cell < columns * rows; cell += 1) {
    const part = (values[cell] ?? 0) / 255
    for (let channel = 0; channel < 3; channel += 1) {
      const from = quiet[channel] ?? 0
      pixels[cell * 4 + channel] = from + ((loud[channel] ?? 0) - from) * part
    }
    pixels[cell * 4 + 3] = 255
  }
  return pixels
}
