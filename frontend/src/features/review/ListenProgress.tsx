import { useEffect, useRef } from 'react'

import type { Player } from '@/audio'
import { ENOUGH_S } from '@/heard/heardMeter'
import type { ReviewTake } from '@/verdicts/api'

import classes from './Review.module.css'

/** How much of a version that plays for the first time was played, as a line at the foot of Approve. */
export function ListenProgress({ take, player }: { take: ReviewTake; player: Player }) {
  const line = useRef<HTMLSpanElement>(null)
  const enoughS = Math.min(ENOUGH_S, take.duration_s ?? ENOUGH_S)
  useEffect(
    () =>
      player.subscribe(() => {
        line.current?.style.setProperty('width', `${Math.min(100, (player.positionS() / enoughS) * 100)}%`)
      }),
    [player, enoughS],
  )
  return <span ref={line} className={`absolute ${classes.listened}`} aria-hidden="true" />
}
