import { useCallback } from 'react'

import { LevelPlot, marksOf, spectraOn, type Surface } from '@/audio'

import type { Loss } from './api'
import classes from './Losses.module.css'

type Spectra = Loss['spectra']

/** Master and game file over each other: what the master had and the file lacks stays pale. */
export function LossPlot({ spectra }: { spectra: Spectra }) {
  const draw = useCallback((surface: Surface) => drawSpectra(surface, spectra), [spectra])
  return (
    <LevelPlot
      draw={draw}
      frequencies={marksOf(spectra.hz)}
      caption={
        <span className={`flex wrap gap-2px-4 ${classes.legend}`}>
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

/** Pale bars for the master, a dark line over them for the file. */
function drawSpectra(surface: Surface, { hz, master_dbfs, render_dbfs }: Spectra): void {
  const spectra = spectraOn(surface, hz)
  spectra.bars(master_dbfs, 'wave-peak')
  spectra.line(render_dbfs, 'ink')
}
