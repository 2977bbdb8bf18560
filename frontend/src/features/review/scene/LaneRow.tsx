import { useRef } from 'react'

import { type Player, WaveThumb } from '@/audio'
import { Button } from '@/ui/Button'
import { level, plural } from '@/ui/format'

import type { SceneLane } from './api'
import classes from './Scene.module.css'
import { type LaneLevel, SOUND } from './useLanes'

const LOWEST_DB = -60
const HIGHEST_DB = 12

interface LaneRowProps {
  lane: SceneLane
  lengthS: number
  now: LaneLevel
  hasSpots: boolean
  onLevel: (to: LaneLevel) => void
  /** A level that was moved rests. */
  onRest: () => void
  onRemove?: () => void
}

/** One sound of the scene: when it plays, how loud, and whether it does. */
export function LaneRow({ lane, lengthS, now, hasSpots, onLevel, onRest, onRemove }: LaneRowProps) {
  const title = lane.bed ? `${ROLES[lane.bed.role]}, ${lane.name}` : lane.name
  return (
    <li className={classes.lane} data-own={lane.id === SOUND || undefined} data-off={!now.isOn || undefined}>
      <span className={`grid min-w-0 ${classes.laneName}`}>
        <span className="strong cut-text">{title}</span>
        <span className="small dim cut-text">{detailOf(lane, hasSpots)}</span>
      </span>
      <span className={`bg-well ${classes.track}`} aria-hidden="true">
        {lane.duration_s !== null &&
          playsAt(lane, lengthS).map((startS) => (
            <span
              key={startS}
              className={`grid items-center absolute ${classes.hit}`}
              style={{
                left: `${(startS / lengthS) * 100}%`,
                width: `${(Math.min(lane.duration_s ?? 0, lengthS - startS) / lengthS) * 100}%`,
              }}
            >
              <WaveThumb peaks={lane.thumb} highlighted={lane.id === SOUND} faded={!now.isOn} heightPx={28} />
            </span>
          ))}
      </span>
      <span className={`grid items-center gap-6px ${classes.level}`}>
        <input
          type="range"
          min={LOWEST_DB}
          max={HIGHEST_DB}
          step={0.5}
          value={now.levelDb}
          aria-label={`Level of ${lane.name}`}
          aria-valuetext={level(now.levelDb)}
          onChange={(event) => onLevel({ ...now, levelDb: Number(event.currentTarget.value) })}
          onPointerUp={onRest}
          onKeyUp={onRest}
          onBlur={onRest}
        />
        <output className="small mono">{level(now.levelDb)}</output>
        <Button
          square
          pressed={!now.isOn}
          aria-label={`Mute ${lane.name}`}
          onClick={() => onLevel({ ...now, isOn: !now.isOn })}
        >
          M
        </Button>
        {onRemove && (
          <Button square variant="quiet" icon="cross" aria-label={`Remove ${lane.name}`} onClick={onRemove} />
        )}
      </span>
    </li>
  )
}

const ROLES = { music: 'Music', ambience: 'Ambience', voice: 'Voice' } as const

function detailOf(lane: SceneLane, hasSpots: boolean): string {
  if (lane.problem) return lane.problem
  if (!lane.is_measured) return 'being measured'
  const times = lane.loops ? 'throughout' : plural(lane.starts_s.length, 'time')
  if (lane.bed) return `${lane.bed.category || 'whole project'}, ${times}`
  if (lane.id === SOUND) return hasSpots ? `${times}, from the list` : times
  return `${times}, ${lane.level_from === 'audit' ? 'level of the build' : 'level as approved'}`
}

/** When a sound begins within the scene; a loop as often as it goes round. */
function playsAt({ loops, starts_s, duration_s }: SceneLane, lengthS: number): number[] {
  if (!loops || !duration_s) return starts_s.filter((startS) => startS < lengthS)
  const rounds = Math.min(60, Math.ceil(lengthS / duration_s))
  return Array.from({ length: rounds }, (_, round) => round * duration_s)
}

/** Where the scene is heard, over all lanes; a press goes there. */
export function LaneAxis({ lengthS, player }: { lengthS: number; player: Player }) {
  const ref = useRef<HTMLDivElement>(null)
  const step = lengthS > 12 ? 5 : lengthS > 4 ? 2 : 1
  const marks = Array.from({ length: Math.floor(lengthS / step) + 1 }, (_, index) => index * step)
  return (
    <div
      ref={ref}
      className={`pointer ${classes.axis}`}
      role="presentation"
      onPointerDown={(event) => {
        const box = event.currentTarget.getBoundingClientRect()
        player.seek(((event.clientX - box.left) / box.width) * lengthS)
      }}
    >
      {marks.map((s) => (
        <span key={s} className="small dim mono" style={{ left: `${(s / lengthS) * 100}%` }}>
          {s}
        </span>
      ))}
    </div>
  )
}
