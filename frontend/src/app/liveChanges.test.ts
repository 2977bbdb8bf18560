import { QueryClient, type QueryKey, QueryObserver } from '@tanstack/react-query'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'

import { queryKeys } from '@/api/queryKeys'

import { isAffected, followChanges, Refresher } from './liveChanges'

const [HERE, THERE] = ['p1', 'p2']
const projects = new Set([HERE, THERE])

describe('what a change concerns', () => {
  test('is what a page shows of its project', () => {
    const hint = { project_id: HERE, rooms: ['deliveries'] }
    expect(isAffected(queryKeys.desk(HERE), hint, projects)).toBe(true)
    expect(isAffected(queryKeys.take('t1'), hint, projects)).toBe(true)
    expect(isAffected(queryKeys.desk(THERE), hint, projects)).toBe(false)
    expect(isAffected(queryKeys.contractLibrary('single'), hint, projects)).toBe(false)
  })

  test('of mails or people is little', () => {
    expect(isAffected(queryKeys.desk(HERE), { project_id: null, rooms: ['notifications'] }, projects)).toBe(false)
    expect(isAffected(queryKeys.outbox('s1'), { project_id: null, rooms: ['notifications'] }, projects)).toBe(true)
    expect(isAffected(queryKeys.me(), { project_id: null, rooms: ['accounts'] }, projects)).toBe(true)
    expect(isAffected(queryKeys.desk(HERE), { project_id: null, rooms: ['accounts'] }, projects)).toBe(false)
  })
})

function shown(client: QueryClient, queryKey: QueryKey) {
  const queryFn = vi.fn(() => Promise.resolve('read'))
  new QueryObserver(client, { queryKey, queryFn, staleTime: Infinity }).subscribe(() => undefined)
  return queryFn
}

describe('asking again', () => {
  beforeEach(() => vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] }))
  afterEach(() => vi.useRealTimers())

  test('is at once after a calm, and less and less often in a burst', async () => {
    const client = new QueryClient()
    const desk = shown(client, queryKeys.desk(HERE))
    await vi.advanceTimersByTimeAsync(10_000)
    const refresher = new Refresher(client, () => projects)
    refresher.add({ project_id: HERE, rooms: ['deliveries'] })
    await vi.advanceTimersByTimeAsync(10)
    expect(desk).toHaveBeenCalledTimes(2)
    for (let ms = 0; ms < 11_000; ms += 100) {
      refresher.add({ project_id: HERE, rooms: ['conformance'] })
      await vi.advanceTimersByTimeAsync(100)
    }
    expect(desk.mock.calls.length).toBeLessThan(8)
    expect(desk.mock.calls.length).toBeGreaterThan(4)
  })
})

class FakeSource extends EventTarget {
  static last: FakeSource
  static readonly CLOSED = 2
  readyState = 1
  constructor(readonly url: string) {
    super()
    FakeSource.last = this
  }
  say(name: string, data: unknown): void {
    this.dispatchEvent(new MessageEvent(name, { data: JSON.stringify(data) }))
  }
  close(): void {
    this.readyState = FakeSource.CLOSED
  }
}

describe('a page', () => {
  beforeEach(() => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval', 'performance'] })
    vi.stubGlobal('EventSource', FakeSource)
  })
  afterEach(() => vi.useRealTimers())

  test('asks again on a hint, and by itself once nothing is heard any more', async () => {
    const client = new QueryClient()
    const desk = shown(client, queryKeys.desk(HERE))
    await vi.advanceTimersByTimeAsync(10_000)
    const stop = followChanges(client, 'p', () => projects)
    FakeSource.last.say('open', { resumed: false })
    await vi.advanceTimersByTimeAsync(20)
    expect(desk).toHaveBeenCalledTimes(1)
    FakeSource.last.say('change', { project_id: HERE, rooms: ['reviews'] })
    await vi.advanceTimersByTimeAsync(20)
    expect(desk).toHaveBeenCalledTimes(2)
    await vi.advanceTimersByTimeAsync(120_000)
    expect(desk.mock.calls.length).toBeGreaterThan(3)
    const calls = desk.mock.calls.length
    stop()
    await vi.advanceTimersByTimeAsync(120_000)
    expect(desk.mock.calls.length).toBe(calls)
  })

  test('asks for everything when changes may have been missed, and not where none were', async () => {
    const client = new QueryClient()
    const desk = shown(client, queryKeys.desk(HERE))
    const stop = followChanges(client, 'p', () => projects)
    FakeSource.last.say('open', { resumed: false })
    FakeSource.last.say('open', { resumed: true })
    await vi.advanceTimersByTimeAsync(20)
    expect(desk).toHaveBeenCalledTimes(1)
    FakeSource.last.say('open', { resumed: false })
    await vi.advanceTimersByTimeAsync(20)
    expect(desk).toHaveBeenCalledTimes(2)
    stop()
  })
})
