import { useCallback } from 'react'

import { LevelPlot, marksOf, spectraOn, type Surface } from '@/audio'

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
  return (
    <LevelPlot
      draw={draw}
      frequencies={marksOf(spectra.hz)}
      caption={
        <span className={`flex wrap ${classes.legend}`}>
          <span data-is="line">{name}</span>
          <span data-is="cover">{other}</span>
          <span data-is="dots">what differs</span>
        </span>
      }
    />
  )
}

function drawSpectra(surface: Surface, { hz, sound_dbfs, against_dbfs, difference_dbfs }: Spectra): void {
  const spectra = spectraOn(surface, hz)
  spectra.bars(against_dbfs, 'wave-cut')
  spectra.line(sound_dbfs, 'ink')
  spectra.dots(difference_dbfs, 'now')
}
