import type { ReactNode } from 'react'

import { Choice } from '@/ui/Choice'
import { Icon } from '@/ui/Icon'
import { Key } from '@/ui/Key'

import type { Peaks } from './peaks'
import classes from './TakeCard.module.css'
import { WaveThumb } from './WaveThumb'

interface TakeCardProps {
  /** A, B, C. */
  letter: string
  /** The key that selects it. */
  keys?: string
  peaks: Peaks | null
  inHand: boolean
  /** Another alternate was picked; it can still be heard. */
  setAside?: boolean
  /** Shuffled letters: wave, gain and adviser stay hidden until the pick. */
  blind?: boolean
  /** "0.84 s", "−2.1 dB", "composer's choice": the first one stays on narrow screens. */
  facts?: readonly ReactNode[]
  /** One line high, as on Today. */
  flat?: boolean
  onPick: () => void
}

/** One of several alternates. A press selects it, and playback continues with it. */
export function TakeCard({ letter, keys, peaks, inHand, setAside, blind, facts = [], flat, onPick }: TakeCardProps) {
  return (
    <Choice
      className={flat ? `${classes.card} ${classes.flat}` : classes.card}
      checked={inHand}
      aria-keyshortcuts={keys}
      onChoose={onPick}
    >
      <span className={inHand ? `${classes.letter} on-ink` : classes.letter}>
        {letter}
        {keys && <Key keys={keys} />}
      </span>
      <span className={`min-w-0 ${classes.inside}`}>
        {blind ? (
          <span className={`block ${classes.hidden}`} />
        ) : (
          <WaveThumb peaks={peaks} highlighted={inHand} faded={setAside} heightPx={30} />
        )}
        <span className={`flex between gap-2 mid nowrap text-small leading-small ${classes.facts}`}>
          {setAside ? (
            <span className="dim">
              <Icon name="turn" size={14} /> set aside
            </span>
          ) : (
            !blind && facts.map((fact, index) => <span key={index}>{fact}</span>)
          )}
        </span>
      </span>
    </Choice>
  )
}
