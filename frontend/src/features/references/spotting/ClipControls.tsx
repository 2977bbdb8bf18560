import type { RefObject } from 'react'

import { Button } from '@/ui/Button'
import { figure } from '@/ui/format'
import { Select } from '@/ui/Select'

import classes from './Spotting.module.css'
import type { Tap } from './useTap'

const SPEEDS = [1, 0.5, 0.25] as const

interface ClipControlsProps {
  video: RefObject<HTMLVideoElement | null>
  isPlaying: boolean
  tap: Tap
  rates: readonly number[]
  frameRate: number
  onPlay: () => void
  onFrameRate: (rate: number) => void
  onNudge: (frames: number) => void
}

/** Play, step, speed, and the pad that is tapped. */
export function ClipControls({
  video,
  isPlaying,
  tap,
  rates,
  frameRate,
  onPlay,
  onFrameRate,
  onNudge,
}: ClipControlsProps) {
  return (
    <div className="flex wrap items-end gap-2-3">
      <Button tall icon={isPlaying ? 'pause' : 'play'} keys="Space" onClick={onPlay}>
        {isPlaying ? 'Pause' : 'Play'}
      </Button>
      <Button
        tall
        variant="primary"
        keys="t"
        className={classes.pad}
        onPointerDown={(event) => tap.press(event.timeStamp)}
        onPointerUp={tap.release}
        onPointerCancel={tap.release}
        onContextMenu={(event) => event.preventDefault()}
        onClick={(event) => {
          if (event.detail > 0) return // a finger or a mouse, which went down before
          tap.press(event.timeStamp)
          tap.release()
        }}
      >
        Mark
      </Button>
      <Button icon="back" onClick={() => onNudge(-1)}>
        Frame back
      </Button>
      <Button icon="right" onClick={() => onNudge(1)}>
        Frame on
      </Button>
      <Select
        label="Speed"
        defaultValue={1}
        onChange={({ currentTarget: { value } }) => {
          if (video.current) video.current.playbackRate = Number(value)
        }}
      >
        {SPEEDS.map((speed) => (
          <option key={speed} value={speed}>
            {`${speed} ×`}
          </option>
        ))}
      </Select>
      <Select
        label="Frames a second"
        value={frameRate}
        onChange={({ currentTarget: { value } }) => onFrameRate(Number(value))}
      >
        {rates.map((rate) => (
          <option key={rate} value={rate}>
            {figure(rate, Number.isInteger(rate) ? 0 : 3)}
          </option>
        ))}
      </Select>
    </div>
  )
}
