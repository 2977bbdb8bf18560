import { useMemo, useState } from 'react'

import type { CueReview, ReviewTake } from '@/verdicts/api'
import { useComparedBlind } from '@/verdicts/comparedBlind'
import { inOrder, LETTERS } from '@/verdicts/hearing'
import { takeName } from '@/verdicts/words'

import { shuffled } from './blind'

/** The version that is heard first: the one asked for, then what waits, then what was approved, then the newest. */
function firstInHand(review: CueReview, waiting: readonly ReviewTake[], takeId?: string): string | undefined {
  const newest = review.takes.find(({ state }) => state === 'approved') ?? review.takes[0]
  const asked = review.takes.find(({ id }) => id === takeId)
  return (asked ?? waiting.find(({ draft_change }) => draft_change === null) ?? waiting[0] ?? newest)?.id
}

/** The versions of a cue that are heard beside one another, which of them is in hand, and which are picked. */
export function useTakesHeard(review: CueReview, startTakeId: string | undefined) {
  const { cue } = review
  const waiting = useMemo(() => inOrder(review.takes.filter(({ state }) => state === 'conforming')), [review.takes])
  const [handId, setHandId] = useState(() => firstInHand(review, waiting, startTakeId))
  const [blind, setBlind] = useState<readonly string[] | null>(null)
  useComparedBlind(blind ? cue.id : undefined)
  const [picked, setPicked] = useState<ReadonlySet<string>>(new Set())
  const [chosen, setChosen] = useState<ReadonlyMap<number, string>>(new Map())

  const hand =
    review.takes.find(({ id }) => id === handId) ?? review.takes.find(({ id }) => id === firstInHand(review, waiting))
  const isSet = cue.variations > 1
  const heard = useMemo(() => {
    const takes = isSet && waiting.length === 0 ? review.takes.filter(({ state }) => state === 'approved') : waiting
    return blind ? blind.flatMap((id) => takes.find((take) => take.id === id) ?? []) : inOrder(takes)
  }, [isSet, waiting, review.takes, blind])
  // A version that answers a change is heard beside the one that the change was asked of.
  const current = heard[0]
  const before =
    heard.length === 1 && current
      ? review.takes.find(
          ({ variation, number, state }) =>
            variation === current.variation && number < current.number && state === 'change_requested',
        )
      : undefined

  const choose = (take: ReviewTake) => {
    setHandId(take.id)
    if (isSet) setChosen((now) => new Map(now).set(take.variation, take.id))
  }
  const flip = () => {
    const to = hand?.id === before?.id ? current : before
    if (to) choose(to)
  }
  const stepTake = (by: number) => {
    if (hand === undefined || heard.length < 2) return
    const at = heard.findIndex(({ id }) => id === hand.id)
    const to = heard[(at + by + heard.length) % heard.length]
    if (to) choose(to)
  }
  const pick = (extend: boolean) => {
    if (hand === undefined || !isSet) return
    const at = heard.indexOf(hand)
    const lastPicked = heard.findLastIndex(({ id }, index) => picked.has(id) && index !== at)
    setPicked((now) => {
      const next = new Set(now)
      if (extend && lastPicked >= 0) {
        for (const { id } of heard.slice(Math.min(at, lastPicked), Math.max(at, lastPicked) + 1)) next.add(id)
      } else if (!next.delete(hand.id)) next.add(hand.id)
      return next
    })
  }

  const toggleBlind = () => {
    if (blind) {
      setBlind(null)
      return
    }
    const order = shuffled(waiting.map(({ id }) => id))
    setBlind(order)
    setHandId(order[0])
  }
  const nameOf = (take: ReviewTake) => {
    const place = blind?.indexOf(take.id) ?? -1
    return place >= 0 ? (LETTERS[place] ?? '') : takeName(take, cue, waiting)
  }

  return {
    waiting,
    heard,
    hand,
    isSet,
    chosen,
    before,
    current,
    flip,
    choose,
    stepTake,
    picked,
    pick,
    unpick: () => setPicked(new Set()),
    blind,
    toggleBlind,
    showNames: () => setBlind(null),
    nameOf,
    /** Of the takes that wait, the first that `decided` leaves open comes into the hand. */
    moveOn: (decided: (take: ReviewTake) => boolean) => {
      const next = waiting.find((take) => !decided(take) && take.draft_change === null)
      if (next) setHandId(next.id)
      return next
    },
  }
}
