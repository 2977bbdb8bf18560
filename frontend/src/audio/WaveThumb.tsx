import { useCallback } from 'react'

import { Drawing } from './Drawing'
import { drawAxis, drawWave, type Surface } from './draw'
import type { Peaks } from './peaks'
import classes from './WaveThumb.module.css'

interface WaveThumbProps {
  /** null: nothing was delivered yet. */
  peaks: Peaks | null
  /** Selected. */
  highlighted?: boolean
  /** Set aside: drawn at 55 %. */
  faded?: boolean
  heightPx?: number
}

/** A sound's shape in a row. Full scale is the full height, so that quiet looks quiet. */
export function WaveThumb({ peaks, highlighted = false, faded = false, heightPx = 20 }: WaveThumbProps) {
  const draw = useCallback(
    (surface: Surface) => {
      if (peaks === null) return
      drawAxis(surface)
      drawWave(surface, peaks, { highlighted })
    },
    [peaks, highlighted],
  )
  if (peaks === null) return <span className={`block rounded-2px ${classes.nothing}`} aria-hidden="true" />
  return (
    <span className="block min-w-0" style={{ height: heightPx, opacity: faded ? 0.55 : undefined }}>
      <Drawing draw={draw} />
    </span>
  )
}
