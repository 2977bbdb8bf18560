import { useEffect, useRef, useState } from 'react'

import { HotkeyButton } from '@/app/keys'
import type { Player, PlayerState } from '@/audio'
import { Button } from '@/ui/Button'
import { figure } from '@/ui/format'
import { LazyMenu } from '@/ui/LazyMenu'

import { type MoreGroup, useMoreKeys } from './more'
import classes from './Review.module.css'

interface TransportProps {
  player: Player
  playing: PlayerState
  durationS: number
  /** Why it does not sound, or not as chosen. */
  trouble: string | null
  isSilent: boolean
  /** The next version at the same position; left out where there is none. */
  onNext?: () => void
  /** How it is heard where that is not as delivered: "Heard as: phone", "Levels are matched". */
  says: readonly string[]
  /** Everything that is not in sight. */
  more: readonly MoreGroup[]
}

const loadMore = () => import('./MoreMenu').then(({ MoreMenu }) => MoreMenu)

/** Play, compare, loop; and the menu with every other way of hearing and judging. */
export function Transport({ player, playing, durationS, trouble, isSilent, onNext, says, more }: TransportProps) {
  const isPlaying = playing.status === 'playing'
  const bar = useRef<HTMLDivElement>(null)
  useMoreKeys([
    ...more,
    {
      items: [
        {
          label: 'More',
          keys: '.',
          run: () => bar.current?.querySelector<HTMLElement>('[aria-haspopup="menu"]')?.click(),
        },
      ],
    },
  ])
  return (
    <div ref={bar} className={`flex wrap items-center gap-6px ${classes.transport}`} role="group" aria-label="Playing">
      <HotkeyButton
        keys="Space"
        keyLabel="Play, pause"
        keyGroup="Review"
        icon={isPlaying ? 'pause' : 'play'}
        disabled={isSilent}
        onPress={() => void player.toggle()}
      >
        <span className={classes.playWord}>{isPlaying ? 'Pause' : 'Play'}</span>
      </HotkeyButton>
      <Time player={player} durationS={durationS} />
      <HotkeyButton
        keys="b"
        keyLabel="Compare: the next version at the same position"
        keyGroup="Review"
        icon="ab"
        disabled={onNext === undefined}
        onPress={() => onNext?.()}
      >
        Compare
      </HotkeyButton>
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
      <span className={`small dim wide-only ${classes.heardHow}`}>{says.join('. ')}</span>
      {trouble && (
        <span role="status" className="small mid">
          {trouble}
        </span>
      )}
      <span className="flex end">
        <LazyMenu
          button={
            <Button icon="more" aria-keyshortcuts=".">
              <span className={classes.playWord}>More</span>
            </Button>
          }
          load={loadMore}
          given={{ groups: more }}
        />
      </span>
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
