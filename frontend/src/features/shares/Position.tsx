import { type CSSProperties, useSyncExternalStore } from 'react'

import { type Peaks, type Player, WaveThumb } from '@/audio'
import { length, placeInWords } from '@/ui/format'

import classes from './Shares.module.css'

interface PositionProps {
  player: Player
  durationS: number
  thumb: Peaks | null
  onSeek: (s: number) => void
  disabled?: boolean
}

const STEPS_A_SECOND = 20

/** The playhead over a sound's shape; arrow keys and presses move it. */
export function Position({ player, durationS, thumb, onSeek, disabled = false }: PositionProps) {
  const step = useSyncExternalStore(player.subscribe, () => Math.round(player.positionS() * STEPS_A_SECOND))
  const atS = Math.min(durationS, step / STEPS_A_SECOND)
  return (
    <div className="grid gap-1">
      <div className={`relative ${classes.shape}`}>
        <WaveThumb peaks={thumb} heightPx={72} />
        <span
          className={`absolute ${classes.head}`}
          style={{ '--at': durationS > 0 ? `${(100 * atS) / durationS}%` : '0%' } as CSSProperties}
          aria-hidden="true"
        />
        <input
          type="range"
          className={`pointer w-full absolute m-0 ${classes.seek}`}
          aria-label="Playhead"
          aria-valuetext={placeInWords(atS)}
          min={0}
          max={durationS}
          step={1 / STEPS_A_SECOND}
          value={atS}
          disabled={disabled || durationS === 0}
          onChange={(event) => onSeek(Number(event.currentTarget.value))}
        />
      </div>
      <span className="small mid num nowrap">
        {length(atS)} of {length(durationS)}
      </span>
    </div>
  )
}
