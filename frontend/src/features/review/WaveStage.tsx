import { useMediaQuery } from '@mantine/hooks'
import { useMemo } from 'react'

import {
  type CommentMark,
  type FindingMark,
  LevelStrip,
  type Player,
  SpectrumStrip,
  type TimeRange,
  Waveform,
} from '@/audio'
import { type ReviewTake } from '@/verdicts/api'
import { AS_DELIVERED, MASTER, soundOf } from '@/verdicts/hearing'
import { useRelease } from '@/verdicts/useHearing'
import { sentence } from '@/verdicts/words'
import { usePeaks } from '@/verdicts/peaks'
import { figure } from '@/ui/format'

import classes from './Review.module.css'

interface WaveStageProps {
  take: ReviewTake
  name: string
  target: string
  player: Player
  range: TimeRange | null
  comments: readonly CommentMark[]
  openComment?: string
  /** Blind listening: nothing is drawn that identifies a version. */
  hidden: boolean
  /** Spectrum and level below the wave. */
  hasStrips: boolean
  /** Rows of a set stand above it. */
  small: boolean
  onMark: (fromS: number, id: string) => void
}

/** The current sound, large: its wave with what was found and said, its spectrum, its level. */
export function WaveStage(props: WaveStageProps) {
  const { take, name, target, player, range, comments, openComment, hidden, small, onMark } = props
  const narrow = useMediaQuery('(max-width: 760px)')
  const sound = soundOf(take, target)
  const peaks = usePeaks(hidden ? undefined : sound.peaksUrl)
  useRelease(player, hidden || peaks !== undefined)
  const { spectrumUrl } = sound
  const spectrum = useMemo(() => (hidden || spectrumUrl === null ? null : { src: spectrumUrl }), [hidden, spectrumUrl])
  const findings = useMemo(
    () => (hidden || (target !== MASTER && target !== AS_DELIVERED) ? [] : findingMarks(take)),
    [hidden, target, take],
  )
  return (
    <div className={`flex flex-col gap-6px ${classes.waves}`}>
      <Waveform
        label={name}
        peaks={peaks}
        durationS={sound.durationS}
        clock={player}
        findings={findings}
        comments={comments}
        openComment={openComment}
        selection={range}
        onSelect={(picked) => player.setRange(picked)}
        onSeek={(s) => player.seek(s)}
        onMark={(fromS, mark) => onMark(fromS, mark.id)}
        heightPx={narrow ? (props.hasStrips ? 170 : 220) : undefined}
      />
      {props.hasStrips && (
        <SpectrumStrip
          spectrogram={spectrum}
          durationS={sound.durationS}
          clock={player}
          heightPx={narrow ? 74 : small ? 92 : 132}
        />
      )}
      {props.hasStrips && !narrow && (
        <LevelStrip peaks={peaks} durationS={sound.durationS} clock={player} heightPx={58} />
      )}
    </div>
  )
}

const LEVELS = new Set(['true-peak', 'sample-peak'])

function findingMarks(take: ReviewTake): FindingMark[] {
  const down = take.renders.find(({ attenuation_db }) => (attenuation_db ?? 0) > 0.05)
  return take.findings.map((finding, index) => ({
    id: `${index} ${finding.code}`,
    severity: finding.severity,
    label: sentence(finding.message),
    more:
      down && LEVELS.has(finding.check)
        ? `${down.target} file is lowered by ${figure(down.attenuation_db ?? 0, 1)} dB`
        : undefined,
    startS: finding.start_s ?? undefined,
    endS: finding.end_s ?? undefined,
  }))
}
