import type { ReactNode } from 'react'

import { TakeCard } from '@/audio'
import type { ReviewTake } from '@/judging/api'
import { type Gains, MASTER, soundOf } from '@/judging/hearing'
import { gain, length } from '@/ui/format'

import classes from './Review.module.css'

interface TakeCardsProps {
  takes: readonly ReviewTake[]
  /** What brings each to the same level. */
  gains: Gains
  handId: string | undefined
  nameOf: (take: ReviewTake) => string
  /** Letters are shuffled; shape, length and gain stay hidden until the pick. */
  blind: boolean
  onChoose: (take: ReviewTake) => void
}

/** Alternates side by side: one is picked, the others are kept. */
export function TakeCards({ takes, gains, handId, nameOf, blind, onChoose }: TakeCardsProps) {
  return (
    <div className={classes.cards} role="group" aria-label="Alternates">
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
            gain(gains.get(take.id) ?? 0),
            ...lastFact(take),
            ...(take.is_heard ? [] : ['not heard']),
          ]}
          onPick={() => onChoose(take)}
        />
      ))}
    </div>
  )
}

/** A draft change; else the version, unless a label names it among the others. */
function lastFact(take: ReviewTake): ReactNode[] {
  if (take.draft_change) {
    return [
      <span key="change" className="tone-change toned">
        draft change
      </span>,
    ]
  }
  return take.label === null ? [`version ${take.number}`] : []
}
