import { useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { useEffect, useEffectEvent } from 'react'

import { isNoted } from './afterVerdict'
import { countQuery, queueQuery, type QueueCount, type QueueItem } from './api'
import type { QueueFilter } from './queueFilter'

const NONE: never[] = []
/** Cues that are loaded beyond the selected one, before the next page is asked for. */
const AHEAD = 10

export interface Queue {
  /** What is here of it: urgent cues first, then the oldest. */
  items: readonly QueueItem[]
  /** Those that are not noted for a change. */
  open: readonly QueueItem[]
  /** How many are open, those that are not here included. */
  waits: QueueCount
  hasMore: boolean
  /** Whether it is known what comes first, or that nothing does. */
  isKnown: boolean
  error: Error | null
  /** Read the next page, and return what is open of all that is here then. */
  readOn: () => Promise<readonly QueueItem[]>
}

/** The queue as far as it is needed: its first page, and those within some cues of the selected one. */
export function useQueue(projectId: string, cueId?: string, filter?: QueueFilter): Queue {
  const queue = useInfiniteQuery(queueQuery(projectId, filter))
  const { data: count } = useQuery(countQuery(projectId, filter))
  const { hasNextPage: hasMore, isFetching, isError } = queue
  const items = queue.data ?? NONE
  const open = openOf(items)
  const ahead = open.length - 1 - open.findIndex(({ cue }) => cue.id === cueId)

  const readOn = async () => openOf((await queue.fetchNextPage({ cancelRefetch: false })).data ?? items)
  const onNear = useEffectEvent(() => void readOn())
  const isNear = ahead < AHEAD && hasMore && !isFetching && !isError
  useEffect(() => {
    if (isNear) onNear()
  }, [isNear, items.length])

  return {
    items,
    open,
    waits: hasMore ? beyond(open.length, items.length, count) : { cues: open.length, is_all: true },
    hasMore,
    isKnown: queue.isSuccess && (open.length > 0 || !hasMore),
    error: queue.error,
    readOn,
  }
}

const openOf = (items: readonly QueueItem[]): QueueItem[] => items.filter((item) => !isNoted(item))

/** How many are open where not all is here: the server counts those that are noted too. */
function beyond(open: number, here: number, count: QueueCount | undefined): QueueCount {
  if (count === undefined || count.cues < here) return { cues: open, is_all: false }
  return { cues: count.cues - (here - open), is_all: count.is_all }
}
