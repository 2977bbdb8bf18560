import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { figure } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'

import classes from './Review.module.css'
import type { PanelProps } from './useSetPlaybackMode'

const RATES = [
  { value: 'free', label: 'One after another', intervalS: null },
  { value: 'steps', label: '2 a second', intervalS: 0.5 },
  { value: 'rounds', label: '600 a minute', intervalS: 0.1 },
] as const
const SEMITONES = [0, 0.5, 1, 2, 3, 6, 12]
const DECIBELS = [0, 1, 2, 3, 6]

/** How often the set is played, and how far pitch and level stray, as the game will do it. */
export function OpenedPanel({ way, setWay, setOpen, isPlaying, onPlay, onStop }: PanelProps) {
  const rate = RATES.find(({ intervalS }) => intervalS === way.intervalS)?.value ?? 'free'
  const choose = (chosen: Partial<typeof way>) => {
    if (isPlaying) onStop()
    setWay({ ...way, ...chosen })
  }
  useHotkeys([{ keys: 'Escape', label: 'Close', group: 'Review', unlisted: true, run: () => setOpen(false) }])
  const amounts = (values: readonly number[], unit: string) =>
    values.map((value) => (
      <option key={value} value={value}>
        {value === 0 ? 'as delivered' : `± ${figure(value, value % 1 === 0 ? 0 : 1)} ${unit}`}
      </option>
    ))
  return (
    <section
      id="set-way"
      aria-label="How the set is played"
      className={`flex wrap items-end border-t flex-none gap-2-4 ${classes.setWay}`}
    >
      <Segmented
        label="Rate"
        options={RATES}
        value={rate}
        onChange={(value) => choose({ intervalS: RATES.find((option) => option.value === value)?.intervalS ?? null })}
      />
      <Select
        label="Pitch"
        value={way.pitchSemitones}
        onChange={(event) => choose({ pitchSemitones: Number(event.currentTarget.value) })}
      >
        {amounts(SEMITONES, 'semitones')}
      </Select>
      <Select
        label="Level"
        value={way.levelDb}
        onChange={(event) => choose({ levelDb: Number(event.currentTarget.value) })}
      >
        {amounts(DECIBELS, 'dB')}
      </Select>
      <Button icon={isPlaying ? 'stop' : 'play'} onClick={isPlaying ? onStop : onPlay}>
        {isPlaying ? 'Stop' : 'Play the set'}
      </Button>
      <Button variant="quiet" icon="cross" square aria-label="Close" onClick={() => setOpen(false)} />
      <p className="small dim">Never the same variation twice running; none is louder than it is by itself.</p>
    </section>
  )
}
