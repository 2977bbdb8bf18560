import { useMemo } from 'react'

import type { ReviewTake } from '@/verdicts/api'
import { inOrder, matchGains, sourceOf } from '@/verdicts/hearing'

/** What is compared in one cue: its versions, the one before and the one at hand, each at the loudness of the first. */
export function useCompared(
  heard: readonly ReviewTake[],
  before: ReviewTake | undefined,
  hand: ReviewTake | undefined,
  target: string,
) {
  // Blind or not, the order is that of delivery: the first of these says how loud all are.
  const compared = useMemo(
    () => [...new Set([...inOrder(heard), before, hand])].filter((take) => take !== undefined),
    [heard, before, hand],
  )
  const gains = useMemo(() => matchGains(compared, target), [compared, target])
  const sources = useMemo(
    () => compared.flatMap((take) => sourceOf(take, target, gains) ?? []),
    [compared, target, gains],
  )
  return { compared, gains, sources }
}
