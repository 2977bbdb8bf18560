import { useEffect, useMemo, useState } from 'react'

import { useHotkeys } from '@/app/keys'
// eslint-disable-next-line no-restricted-imports -- its sounds are of no project
import { LevelStrip, type Source, SpectrumStrip, TakeCard, usePlayer, Waveform } from '@/audio'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { figure, gain, length } from '@/ui/format'

import classes from './Parts.module.css'
import { addressOf, lengthOf, peaksOf, SAMPLES, spectrogramOf } from './sounds'

const TAKES = [
  { letter: 'A', samples: SAMPLES.shieldA, matchGainDb: 0, who: 'composer’s choice' },
  { letter: 'B', samples: SAMPLES.shieldB, matchGainDb: -2.1, who: 'programmer’s choice' },
  { letter: 'C', samples: SAMPLES.shieldC, matchGainDb: 1.4, who: 'nobody’s yet' },
].map((take) => ({ ...take, peaks: peaksOf(take.samples, 2000), durationS: lengthOf(take.samples) }))

const DOOR = peaksOf(SAMPLES.door, 1200)

/** Alternates, wave, strips and transport together, as the review room has them; and a fix's before. */
export function Stage() {
  const [player, state] = usePlayer()
  const [sources] = useState<Source[]>(() =>
    TAKES.map(({ letter, samples, matchGainDb }) => ({ id: letter, url: addressOf(samples), matchGainDb })),
  )
  const [open, setOpen] = useState<string>('c2')
  useEffect(() => {
    player.previews.keepReady(sources.map(({ url }) => url))
    if (sources[0]) void player.select(sources[0])
  }, [player, sources])

  const at = Math.max(
    0,
    TAKES.findIndex(({ letter }) => letter === state.sourceId),
  )
  const take = TAKES[at]
  const spectrogram = useMemo(() => take && spectrogramOf(take.samples), [take])
  const pick = (index: number) => {
    const source = sources[index]
    if (source) void player.select(source)
  }
  useHotkeys([
    { keys: 'Space', label: 'Play, pause', group: 'Parts', run: () => void player.toggle() },
    { keys: 'b', label: 'Next alternate', group: 'Parts', run: () => pick((at + 1) % TAKES.length) },
    {
      keys: 'h',
      label: 'Hold: as the game does',
      group: 'Parts',
      run: () => void player.playRandomized(sources),
      release: () => player.pause(),
    },
    { keys: 'v', label: 'Reverse', group: 'Parts', run: () => player.setReversed(!state.reversed) },
  ])
  if (take === undefined) return null

  return (
    <Card aria-label="Stage" className={`grid grid-cols-1 gap-6px ${classes.stage}`}>
      <div className={`grid gap-2 ${classes.takes}`} role="group" aria-label="Alternates">
        {TAKES.map(({ letter, peaks, durationS, matchGainDb, who }, index) => (
          <TakeCard
            key={letter}
            letter={letter}
            peaks={peaks}
            inHand={index === at}
            facts={[
              length(durationS),
              <span key="gain" className="dim">
                {gain(matchGainDb)}
              </span>,
              who,
            ]}
            onPick={() => pick(index)}
          />
        ))}
      </div>
      <Waveform
        label={`shield_hit, ${take.letter}`}
        peaks={take.peaks}
        durationS={take.durationS}
        clock={player}
        heightPx={280}
        onSeek={(s) => player.seek(s)}
        onMark={(fromS, mark) => {
          if ('number' in mark) setOpen(mark.id)
          void player.play(fromS)
        }}
        selection={state.range}
        onSelect={(range) => player.setRange(range)}
        openComment={open}
        limitDbfs={-1}
        findings={[
          {
            id: 'f1',
            severity: 'warning',
            label: 'True peak −0.6 dBTP, limit −1.0',
            more: 'game file comes down 0.4 dB',
            startS: 0.005,
            endS: 0.017,
          },
        ]}
        comments={[
          { id: 'c1', number: 1, startS: 0.044 },
          { id: 'c2', number: 2, startS: 0.307, endS: 0.462 },
          { id: 'c3', number: 3, startS: 0.697 },
        ]}
      />
      <SpectrumStrip spectrogram={spectrogram ?? null} durationS={take.durationS} clock={player} />
      <LevelStrip peaks={take.peaks} durationS={take.durationS} clock={player} />
      <div className={`row p-1-0 overflow-x-auto ${classes.transport}`}>
        <Button
          square
          icon={state.status === 'playing' ? 'pause' : 'play'}
          aria-label={state.status === 'playing' ? 'Pause' : 'Play'}
          onClick={() => void player.toggle()}
        />
        <span className="mono lead">{figure(take.durationS, 3)}</span>
        <Button icon="loop" pressed={state.looping} onClick={() => player.setLooping(!state.looping)}>
          Loop
        </Button>
        <Button icon="reverse" keys="v" pressed={state.reversed} onClick={() => player.setReversed(!state.reversed)}>
          Reverse
        </Button>
        <Button icon="ab" keys="b" onClick={() => pick((at + 1) % TAKES.length)}>
          A ⇄ B
        </Button>
        <Button icon="level" pressed={state.matched} onClick={() => player.setMatched(!state.matched)}>
          Match level
        </Button>
      </div>
      <Waveform
        plain
        label="airlock_cycle, original"
        peaks={DOOR}
        durationS={2.41}
        heightPx={84}
        limitDbfs={-0.9}
        cuts={[{ startS: 0, endS: 0.412 }]}
        playheadS={1.2}
        findings={[]}
        comments={[{ id: 'd1', number: 1, startS: 1.95 }]}
      />
      <Waveform plain label="void_whale" peaks={null} durationS={9} heightPx={56} />
    </Card>
  )
}
