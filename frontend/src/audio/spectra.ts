import type { Surface } from './draw'
import { FLOOR_DB, LINES_DB, LINES_HZ } from './LevelPlot'

/** Levels in dBFS, one a band; null where a sound has nothing. */
type Levels = readonly (number | null)[]

/** The frequencies that are named below spectra, which reach from their first band to their last. */
export function marksOf(hz: readonly number[]) {
  const from = hz[0] ?? 20
  const to = hz.at(-1) ?? 20_000
  return LINES_HZ.filter((lineHz) => lineHz > from && lineHz < to).map((lineHz) => ({
    hz: lineHz,
    at: Math.log(lineHz / from) / Math.log(to / from),
    label: lineHz >= 1000 ? `${lineHz / 1000} kHz` : `${lineHz} Hz`,
  }))
}

/** Draw the lines of level; what is returned draws spectra of these bands over each other, on a logarithmic scale. */
export function spectraOn({ context, width, height, scale, colour }: Surface, hz: readonly number[]) {
  const from = hz[0] ?? 20
  const to = hz.at(-1) ?? 20_000
  const x = (band: number) => (width * Math.log(band / from)) / Math.log(to / from)
  const y = (db: number) => (height * Math.max(FLOOR_DB, Math.min(0, db))) / FLOOR_DB
  context.fillStyle = colour('wave-grid')
  for (const db of LINES_DB) context.fillRect(0, Math.round(y(db)), width, scale)
  return {
    bars(levels: Levels, paint: string) {
      context.fillStyle = colour(paint)
      hz.forEach((band, at) => {
        const db = levels[at] ?? null
        const next = hz[at + 1] ?? band
        if (db !== null) context.fillRect(x(band), y(db), Math.max(scale, x(next) - x(band) - scale), height - y(db))
      })
    },
    /** A line that is broken where there is nothing. */
    line(levels: Levels, paint: string) {
      context.strokeStyle = colour(paint)
      context.lineWidth = 2 * scale
      context.beginPath()
      let drawing = false
      hz.forEach((band, at) => {
        const db = levels[at] ?? null
        if (db !== null) context[drawing ? 'lineTo' : 'moveTo'](x(band), y(db))
        drawing = db !== null
      })
      context.stroke()
    },
    dots(levels: Levels, paint: string) {
      context.fillStyle = colour(paint)
      hz.forEach((band, at) => {
        const db = levels[at] ?? null
        if (db !== null) context.fillRect(x(band), y(db) - scale, 3 * scale, 3 * scale)
      })
    },
  }
}
