import { useCallback } from 'react'

import { FLOOR_DB, LevelPlot, LINES_DB, LINES_HZ, type Surface } from '@/audio'

import type { Comparison } from './api'
import classes from './Scene.module.css'

type Spectra = NonNullable<Comparison['spectra']>

interface SpectraPlotProps {
  spectra: Spectra
  name: string
  other: string
}

/** Both long-term spectra in one picture: bars for the other sound, a line for the version, dots for what differs. */
export function SpectraPlot({ spectra, name, other }: SpectraPlotProps) {
  const draw = useCallback((surface: Surface) => drawSpectra(surface, spectra), [spectra])
  const [from, to] = [spectra.hz[0] ?? 20, spectra.hz.at(-1) ?? 20_000]
  const frequencies = LINES_HZ.filter((hz) => hz > from && hz < to).map((hz) => ({
    hz,
    at: Math.log(hz / from) / Math.log(to / from),
    label: hz >= 1000 ? `${hz / 1000} kHz` : `${hz} Hz`,
  }))
  return (
    <LevelPlot
      draw={draw}
      frequencies={frequencies}
      caption={
        <span className={classes.legend}>
          <span data-is="line">{name}</span>
          <span data-is="cover">{other}</span>
          <span data-is="dots">what differs</span>
        </span>
      }
    />
  )
}

function drawSpectra(surface: Surface, { hz, sound_dbfs, against_dbfs, difference_dbfs }: Spectra): void {
  const { context, width, height, scale, colour } = surface
  const [from, to] = [hz[0] ?? 20, hz.at(-1) ?? 20_000]
  const x = (band: number) => (width * Math.log(band / from)) / Math.log(to / from)
  const y = (db: number) => (height * Math.max(FLOOR_DB, Math.min(0, db))) / FLOOR_DB
  context.fillStyle = colour('wave-grid')
  for (const db of LINES_DB) context.fillRect(0, Math.round(y(db)), width, scale)
  const each = (levels: readonly (number | null)[], put: (at: number, bandX: number, levelY: number) => void) =>
    hz.forEach((band, at) => {
      const db = levels[at] ?? null
      if (db !== null) put(at, x(band), y(db))
    })
  context.fillStyle = colour('wave-cut')
  each(against_dbfs, (at, bandX, levelY) =>
    context.fillRect(bandX, levelY, Math.max(scale, x(hz[at + 1] ?? to) - bandX - scale), height - levelY),
  )
  context.strokeStyle = colour('ink')
  context.lineWidth = 2 * scale
  context.beginPath()
  each(sound_dbfs, (at, bandX, levelY) => (at === 0 ? context.moveTo(bandX, levelY) : context.lineTo(bandX, levelY)))
  context.stroke()
  context.fillStyle = colour('now')
  each(difference_dbfs, (_, bandX, levelY) => context.fillRect(bandX, levelY - scale, 3 * scale, 3 * scale))
}
