import { useCallback } from 'react'

import { FLOOR_DB, LevelPlot, LINES_DB, LINES_HZ, type Surface } from '@/audio'
import { figure } from '@/ui/format'

import type { Bands } from './api'
import classes from './Take.module.css'

const FROM_HZ = 20

interface BandPlotProps {
  bands: Bands
  /** Half the sample rate. */
  toHz: number
  /** The highest frequency that stands out of the noise. */
  bandwidthHz: number | null
}

/** How the energy of the whole sound is spread over frequency: level of each sixth of an octave, and where it ends. */
export function BandPlot({ bands, toHz, bandwidthHz }: BandPlotProps) {
  const across = (hz: number) => Math.log(Math.max(hz, FROM_HZ) / FROM_HZ) / Math.log(toHz / FROM_HZ)
  const draw = useCallback(
    (surface: Surface) => drawBands(surface, bands, bandwidthHz, toHz),
    [bands, bandwidthHz, toHz],
  )
  const loudest = bands.dbfs.reduce<number>(
    (most, db, at) => ((db ?? -999) > (bands.dbfs[most] ?? -999) ? at : most),
    0,
  )
  const named = [
    { hz: FROM_HZ, at: 0, label: `${FROM_HZ} Hz` },
    ...LINES_HZ.filter((hz) => hz < toHz / 1.6).map((hz) => ({
      hz,
      at: across(hz),
      label: formatHz(hz),
      wideOnly: hz > toHz / 3,
    })),
    { hz: toHz, at: 1, label: formatHz(toHz) },
  ]
  const loudestDb = bands.dbfs[loudest] ?? null
  return (
    <LevelPlot
      draw={draw}
      frequencies={named}
      tall
      caption={`RMS level per sixth of an octave over the whole sound, in dBFS. Loudest near ${formatHz(bands.hz[loudest] ?? 0)}${
        loudestDb === null ? '; silent throughout' : `, ${figure(loudestDb, 1)} dBFS`
      }.`}
    >
      {bandwidthHz !== null && bandwidthHz > FROM_HZ && (
        <span
          className={`bg-well nowrap absolute rounded-2px ink text-small leading-small ${classes.bandwidth}`}
          data-left={across(bandwidthHz) > 0.6 || undefined}
          style={{ left: `${Math.min(1, across(bandwidthHz)) * 100}%` }}
        >
          ends at {formatHz(bandwidthHz)}
        </span>
      )}
    </LevelPlot>
  )
}

const formatHz = (hz: number): string =>
  hz >= 1000 ? `${figure(hz / 1000, hz >= 10_000 ? 0 : 1)} kHz` : `${figure(hz)} Hz`

/** Bars of ink on a logarithmic scale; beyond the bandwidth they are drawn quietly. */
function drawBands(surface: Surface, bands: Bands, bandwidthHz: number | null, toHz: number): void {
  const { context, width, height, scale, colour } = surface
  const x = (hz: number) => (width * Math.log(Math.max(hz, FROM_HZ) / FROM_HZ)) / Math.log(toHz / FROM_HZ)
  const y = (db: number) => (height * Math.max(FLOOR_DB, Math.min(0, db))) / FLOOR_DB
  context.fillStyle = colour('wave-grid')
  for (const db of LINES_DB) context.fillRect(0, Math.round(y(db)), width, scale)
  for (const hz of LINES_HZ) context.fillRect(Math.round(x(hz)), 0, scale, height)
  bands.hz.forEach((hz, at) => {
    const db = bands.dbfs[at]
    if (db === null || db === undefined || db <= FLOOR_DB) return
    const left = x(hz / 2 ** (1 / 12))
    const right = x(hz * 2 ** (1 / 12))
    context.fillStyle = colour(bandwidthHz !== null && hz > bandwidthHz * 1.06 ? 'wave-peak' : 'wave-rms')
    context.fillRect(left, y(db), Math.max(scale, right - left - scale), height - y(db))
  })
  if (bandwidthHz !== null && bandwidthHz > FROM_HZ) {
    context.fillStyle = colour('ink')
    context.fillRect(Math.round(Math.min(x(bandwidthHz), width - scale)), 0, scale, height)
  }
}
