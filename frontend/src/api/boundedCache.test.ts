import { QueryClient, QueryObserver } from '@tanstack/react-query'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'

import { boundCache } from './boundedCache'

const kept = (client: QueryClient, family: string) =>
  client
    .getQueryCache()
    .findAll({ queryKey: [family] })
    .map(({ queryKey }) => queryKey[1])
const answer = (client: QueryClient, at: number) =>
  client.setQueryData(['peaks', at], [at], { updatedAt: Date.now() + at })

beforeEach(() => vi.useFakeTimers())
afterEach(() => vi.useRealTimers())

test('of each family the newest answers that no page shows are kept', () => {
  const client = new QueryClient()
  boundCache(client, 3)
  client.setQueryData(['today', 'p1'], 'of another family')
  for (let at = 0; at < 10; at += 1) answer(client, at)
  vi.advanceTimersByTime(1_000)
  expect(kept(client, 'peaks')).toEqual([7, 8, 9])
  expect(kept(client, 'today')).toEqual(['p1'])
  answer(client, 10)
  vi.advanceTimersByTime(1_000)
  expect(kept(client, 'peaks')).toEqual([8, 9, 10])
})

test('what a page shows stays, and so does what is on its way', () => {
  const client = new QueryClient()
  boundCache(client, 1)
  client.setQueryData(['peaks', 'shown'], 'shape')
  void client.prefetchQuery({ queryKey: ['peaks', 'coming'], queryFn: () => new Promise(() => undefined) })
  for (let at = 0; at < 5; at += 1) answer(client, at)
  // As React does: what is drawn says a moment later that it shows the answer.
  const stop = new QueryObserver(client, { queryKey: ['peaks', 'shown'], staleTime: Infinity }).subscribe(vi.fn())
  vi.advanceTimersByTime(1_000)
  expect(kept(client, 'peaks')).toEqual(['shown', 'coming', 4])
  stop()
})
