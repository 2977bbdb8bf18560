import type { ReactNode } from 'react'

import { TakeCard } from '@/audio'
import type { ReviewTake } from '@/verdicts/api'
import { MASTER, soundOf } from '@/verdicts/hearing'
import { length } from '@/ui/format'

import classes from './Review.module.css'

interface TakeCardsProps {
  takes: readonly ReviewTake[]
  handId: string | undefined
  /** The one that sounds now. */
  playingId: string | null
  nameOf: (take: ReviewTake) => string
  /** Letters are shuffled; shape, length and gain stay hidden until the pick. */
  blind: boolean
  onChoose: (take: ReviewTake) => void
}

/** Alternates side by side: one is picked, the others are kept. */
export function TakeCards({ takes, handId, playingId, nameOf, blind, onChoose }: TakeCardsProps) {
  return (
    <div className={`grid gap-2 flex-none ${classes.cards}`} role="radiogroup" aria-label="Alternates">
      {takes.map((take, index) => (
        <TakeCard
          key={take.id}
          letter={nameOf(take)}
          keys={index < 9 ? String(index + 1) : undefined}
          peaks={take.thumb}
          inHand={take.id === handId}
          blind={blind}
          facts={[
            ...(take.label === null ? [] : [take.label]),
            length(soundOf(take, MASTER).durationS),
            ...lastFact(take),
            take.id === playingId ? 'playing' : take.is_heard ? 'heard' : 'not heard',
          ]}
          onPick={() => onChoose(take)}
        />
      ))}
    </div>
  )
}

/** A change that was requested. */
function lastFact(take: ReviewTake): ReactNode[] {
  if (take.draft_change === null) return []
  return [
    <span key="change" className="tone-change toned">
      {take.draft_change.sends_at === null ? 'draft change' : 'change requested'}
    </span>,
  ]
}
