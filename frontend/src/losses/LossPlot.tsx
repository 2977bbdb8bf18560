import { useCallback } from 'react'

import { FLOOR_DB, LevelPlot, LINES_DB, LINES_HZ, type Surface } from '@/audio'

import type { Loss } from './api'
import classes from './Losses.module.css'

type Spectra = Loss['spectra']

/** Master and game file over each other: what the master had and the file lacks stays pale. */
export function LossPlot({ spectra }: { spectra: Spectra }) {
  const draw = useCallback((surface: Surface) => drawSpectra(surface, spectra), [spectra])
  const from = spectra.hz[0] ?? 20
  const to = spectra.hz.at(-1) ?? 20_000
  const named = LINES_HZ.filter((hz) => hz > from && hz < to).map((hz) => ({
    hz,
    at: Math.log(hz / from) / Math.log(to / from),
    label: hz >= 1000 ? `${hz / 1000} kHz` : `${hz} Hz`,
  }))
  return (
    <LevelPlot
      draw={draw}
      frequencies={named}
      caption={
        <span className={classes.legend}>
          <span>
            <i data-of="master" /> master
          </span>
          <span>
            <i data-of="file" /> game file
          </span>
          <span>RMS over the whole sound, dBFS</span>
        </span>
      }
    />
  )
}

/** Pale bars for the master, a dark line over them for the file, on a logarithmic scale. */
function drawSpectra(surface: Surface, { hz, master_dbfs, render_dbfs }: Spectra): void {
  const { context, width, height, scale, colour } = surface
  const from = hz[0] ?? 20
  const to = hz.at(-1) ?? 20_000
  const x = (band: number) => (width * Math.log(band / from)) / Math.log(to / from)
  const y = (db: number) => (height * Math.max(FLOOR_DB, Math.min(0, db))) / FLOOR_DB
  context.fillStyle = colour('wave-grid')
  for (const db of LINES_DB) context.fillRect(0, Math.round(y(db)), width, scale)
  context.fillStyle = colour('wave-peak')
  hz.forEach((band, at) => {
    const db = master_dbfs[at] ?? null
    const next = hz[at + 1] ?? band
    if (db !== null) context.fillRect(x(band), y(db), Math.max(scale, x(next) - x(band) - scale), height - y(db))
  })
  context.strokeStyle = colour('ink')
  context.lineWidth = 2 * scale
  context.beginPath()
  let drawing = false
  hz.forEach((band, at) => {
    const db = render_dbfs[at] ?? null
    if (db === null) drawing = false
    else if (drawing) context.lineTo(x(band), y(db))
    else {
      context.moveTo(x(band), y(db))
      drawing = true
    }
  })
  context.stroke()
}
