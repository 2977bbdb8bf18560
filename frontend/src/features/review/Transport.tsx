import { type ReactNode, useEffect, useState } from 'react'

import { HotkeyButton, useHotkeys } from '@/app/keys'
import type { Player, PlayerState } from '@/audio'
import { Button } from '@/ui/Button'
import { CopyButton } from '@/ui/CopyButton'
import { figure } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { LazyMenu } from '@/ui/LazyMenu'

import classes from './Review.module.css'
import type { Conditions } from './useCondition'

interface TransportProps {
  player: Player
  playing: PlayerState
  durationS: number
  /** Why there is nothing to hear. */
  silent: string | null
  onNext?: () => void
  nextWords: string
  /** How levels are matched: "matched: A −3.2 dB, B −9.1 dB". */
  matchedSays: string
  conditions: Conditions
  blind?: { on: boolean; toggle: () => void }
  /** What plays the set, and the button that opens how. */
  asGame?: { play: () => void; way: ReactNode }
  /** Hear it among the other sounds of its scene. */
  scene?: { on: boolean; toggle: () => void; compares: boolean; compare: () => void }
  takeId: string
}

const LIGHT = 'Coded, to begin sooner. The exact sound takes its place as soon as it is here.'

const loadConditions = () => import('./ConditionsMenu').then(({ ConditionsMenu }) => ConditionsMenu)

/** Whether it is heard as a phone or a television plays it; said as long as it is so. */
function HeardAs({ condition, choose }: Conditions) {
  return (
    <LazyMenu
      button={
        <Button
          icon="headphones"
          className={condition ? classes.early : undefined}
          pressed={condition !== null}
          title={condition ? `Heard only: ${condition.figures}. Files and measurements stay as they are.` : undefined}
        >
          {condition ? `Heard as: ${condition.name}` : 'Full range'}
          <Icon name="chevron" />
        </Button>
      }
      load={loadConditions}
      given={{ condition, choose }}
    />
  )
}

/** How it is heard: where, round and round, backwards, against the others, at one level. */
export function Transport({
  player,
  playing,
  durationS,
  silent,
  onNext,
  nextWords,
  matchedSays,
  conditions,
  blind,
  asGame,
  scene,
  takeId,
}: TransportProps) {
  const isPlaying = playing.status === 'playing'
  const trouble = silent ?? playing.error ?? conditions.trouble
  const linkToPlace = () => {
    const link = new URL(window.location.href)
    link.search = new URLSearchParams({ take: takeId, at: player.positionS().toFixed(3) }).toString()
    return link.href
  }
  useHotkeys([
    {
      keys: 'Space',
      label: 'Play, pause',
      group: 'Review',
      run: () => void player.toggle(),
      disabled: silent !== null,
    },
  ])
  return (
    <div className={classes.transport} role="group" aria-label="Playing">
      <Button
        square
        icon={isPlaying ? 'pause' : 'play'}
        className={classes.play}
        aria-label={isPlaying ? 'Pause' : 'Play'}
        aria-keyshortcuts="Space"
        disabled={silent !== null}
        onClick={() => void player.toggle()}
      />
      <Time player={player} durationS={durationS} />
      {silent === null && playing.durationS > 0 && playing.isLight && (
        <span className="small mid" title={LIGHT}>
          Preview
        </span>
      )}
      <HotkeyButton
        keys="l"
        keyLabel="Loop the range"
        keyGroup="Review"
        icon="loop"
        pressed={playing.looping}
        onPress={() => player.setLooping(!playing.looping)}
      >
        Loop
      </HotkeyButton>
      <HotkeyButton
        keys="v"
        keyLabel="Play in reverse"
        keyGroup="Review"
        icon="reverse"
        pressed={playing.reversed}
        onPress={() => player.setReversed(!playing.reversed)}
      >
        Reverse
      </HotkeyButton>
      <i className={classes.separator} />
      {onNext && (
        <HotkeyButton
          keys="b"
          keyLabel="Switch to the next one at the same position"
          keyGroup="Review"
          icon="ab"
          className={classes.early}
          onPress={onNext}
        >
          {nextWords}
        </HotkeyButton>
      )}
      <HotkeyButton
        keys="m"
        keyLabel="Match levels"
        keyGroup="Review"
        icon="level"
        className={classes.early}
        pressed={playing.matched}
        onPress={() => player.setMatched(!playing.matched)}
      >
        Match level
      </HotkeyButton>
      {playing.matched && matchedSays && <span className="small dim nowrap">{matchedSays}</span>}
      <HeardAs {...conditions} />
      {blind && (
        <HotkeyButton keys="d" keyLabel="Compare blind" keyGroup="Review" pressed={blind.on} onPress={blind.toggle}>
          Blind
        </HotkeyButton>
      )}
      {scene && (
        <>
          <HotkeyButton
            keys="o"
            keyLabel="Alone, or in its scene"
            keyGroup="Review"
            pressed={scene.on}
            onPress={scene.toggle}
          >
            In the scene
          </HotkeyButton>
          <Button pressed={scene.compares} onClick={scene.compare}>
            Against
          </Button>
        </>
      )}
      {asGame && (
        <>
          <Button keys="h" pressed={playing.asGame} onClick={() => (playing.asGame ? player.pause() : asGame.play())}>
            Randomise
          </Button>
          {asGame.way}
        </>
      )}
      {trouble && (
        <span role="status" className="small mid">
          {trouble}
        </span>
      )}
      <CopyButton
        text={linkToPlace}
        what="Link to this place"
        variant="quiet"
        square
        className="end wide-only"
        aria-label="Copy a link to this place"
      />
    </div>
  )
}

function Time({ player, durationS }: { player: Player; durationS: number }) {
  const [at, setAt] = useState(() => figure(player.positionS(), 3))
  useEffect(() => player.subscribe(() => setAt(figure(player.positionS(), 3))), [player])
  return (
    <span className={classes.time}>
      {at}
      <span className="dim"> / {figure(durationS, 3)}</span>
    </span>
  )
}
