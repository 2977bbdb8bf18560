import { useMediaQuery } from '@mantine/hooks'
import { useMemo, useState } from 'react'

import { HotkeyButton } from '@/app/keys'
import { type FindingMark, LevelStrip, type Player, type PlayerState, SpectrumStrip, Waveform } from '@/audio'
import { AS_DELIVERED, MASTER, masterUrl, playsAsDelivered } from '@/verdicts/hearing'
import { usePeaks } from '@/verdicts/peaks'
import { Card, CardHead } from '@/ui/Card'
import { sampleFormat, length, rate } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Segmented } from '@/ui/Segmented'

import type { GameFile, Sounds, Take } from './api'
import classes from './Take.module.css'

interface SoundCardProps {
  take: Take
  sounds: Sounds | undefined
  marks: readonly FindingMark[]
  limitDbfs?: number
  player: Player
  playing: PlayerState
  /** A finding's mark was pressed: its place in the list. */
  onMark: (at: number) => void
}

/** The sound, large: its wave with what was found, its spectrum and its level on one axis, and the way to hear it. */
export function SoundCard({ take, sounds, marks, limitDbfs, player, playing, onMark }: SoundCardProps) {
  const narrow = useMediaQuery('(max-width: 760px)')
  const [chosen, setChosen] = useState(MASTER)
  const files = (sounds?.renders ?? []).filter(({ preview_url }) => preview_url !== null)
  const file = files.find(({ target }) => target === chosen)
  const sound = file ?? sounds?.master
  const peaks = usePeaks(sound?.peaks_url)
  const spectrumUrl = sound?.spectrum_url ?? null
  const spectrum = useMemo(() => (spectrumUrl === null ? null : { src: spectrumUrl }), [spectrumUrl])
  const hasMoreBits = sounds !== undefined && sounds.closed === null && playsAsDelivered(sounds.master.facts)
  const choices = [MASTER, ...(hasMoreBits ? [AS_DELIVERED] : []), ...files.map(({ target }) => target)]
  const playable = (target: string) => {
    if (target === AS_DELIVERED) return { id: `${take.id} ${target}`, url: masterUrl(take.id) }
    const heard = files.find((candidate) => candidate.target === target)
    return { id: heard ? `${take.id} ${target}` : take.id, url: (heard ?? sounds?.master)?.preview_url ?? null }
  }
  const { id: sourceId, url } = playable(chosen)
  const durationS = sound?.duration_s ?? null
  const isHeard = playing.sourceId === sourceId
  const isPlaying = isHeard && playing.status === 'playing'

  const hear = (fromS?: number) => {
    if (url === null) return
    void player.select({ id: sourceId, takeId: take.id, url })
    void player.play(fromS)
  }
  const seek = (s: number) => {
    if (url === null) return
    void player.select({ id: sourceId, takeId: take.id, url })
    player.seek(s)
  }
  const choose = (target: string) => {
    setChosen(target)
    const next = playable(target)
    // The other one goes on at the same place.
    if (next.url !== null && player.isPlaying()) void player.select({ id: next.id, takeId: take.id, url: next.url })
  }
  return (
    <Card aria-labelledby="sound">
      <CardHead
        id="sound"
        title="Sound"
        note={factsOf(sounds, file)}
        end={
          choices.length > 1 && (
            <Segmented
              label="Master or game file"
              options={choices.map((target) => ({
                value: target,
                label: target === AS_DELIVERED ? 'As delivered' : target.charAt(0).toUpperCase() + target.slice(1),
              }))}
              value={choices.includes(chosen) ? chosen : MASTER}
              onChange={choose}
            />
          )
        }
      />
      <div className="grid gap-2 p-3-inset-14px">
        {durationS === null ? (
          <p className="mid">
            {sounds === undefined || sounds.master.state === 'drawing'
              ? 'Drawing the waveform…'
              : 'No waveform: the file could not be read as audio.'}
          </p>
        ) : (
          <>
            <Waveform
              label={take.cue?.name ?? take.file_name}
              peaks={peaks}
              durationS={durationS}
              findings={file ? [] : marks}
              limitDbfs={file ? undefined : limitDbfs}
              clock={isHeard ? player : undefined}
              playheadS={0}
              onSeek={seek}
              onMark={(_, mark) => onMark(Number(mark.id))}
              heightPx={narrow ? 150 : 220}
            />
            <SpectrumStrip
              spectrogram={spectrum}
              durationS={durationS}
              clock={isHeard ? player : undefined}
              heightPx={narrow ? 84 : 132}
            />
            <LevelStrip peaks={peaks} durationS={durationS} clock={isHeard ? player : undefined} heightPx={58} />
          </>
        )}
        {playing.error !== null && isHeard && (
          <ErrorBanner detail="Sound could not be played." fix="Check your connection and try again." />
        )}
        {url !== null && (
          <div className={`flex wrap gap-2 ${classes.transport}`}>
            <HotkeyButton
              variant="primary"
              icon={isPlaying ? 'pause' : 'play'}
              keys="Space"
              keyLabel="Play, pause"
              keyGroup="Version"
              onPress={() => (isPlaying ? player.pause() : hear())}
            >
              {isPlaying ? 'Pause' : 'Play'}
            </HotkeyButton>
            <HotkeyButton
              icon="loop"
              keys="l"
              keyLabel="Loop"
              keyGroup="Version"
              pressed={playing.looping}
              onPress={() => player.setLooping(!playing.looping)}
            >
              Loop
            </HotkeyButton>
            <HotkeyButton
              icon="reverse"
              keys="v"
              keyLabel="Play in reverse"
              keyGroup="Version"
              pressed={playing.reversed}
              onPress={() => player.setReversed(!playing.reversed)}
            >
              Reverse
            </HotkeyButton>
          </div>
        )}
      </div>
    </Card>
  )
}

function factsOf(sounds: Sounds | undefined, file: GameFile | undefined): string {
  const sound = file ?? sounds?.master
  const {
    sample_rate_hz: hz,
    bit_depth: bits,
    encoding,
  } = (sound?.facts ?? {}) as {
    sample_rate_hz?: number
    bit_depth?: number
    encoding?: string
  }
  return [hz && rate(hz), sampleFormat(bits, encoding), sound?.duration_s && length(sound.duration_s)]
    .filter(Boolean)
    .join(', ')
}
