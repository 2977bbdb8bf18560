import { QueryClient } from '@tanstack/react-query'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'

import { queryKeys } from '@/api/queryKeys'
import type { PlayerState } from '@/audio'
import { SILENT } from '@/audio/playerState'
import { anItem, aReview, aTake, PROJECT } from '@/test/review'
import { answer, refusal, serve } from '@/test/server'

import { meterHeard } from './heardMeter'
import { HeardTakes, markHeard } from './heardTakes'

beforeEach(() => {
  localStorage.clear()
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] })
})
afterEach(() => vi.useRealTimers())

describe('what counts as heard', () => {
  /** A player without sound, whose state is set by hand. */
  function metered(now = () => performance.now()) {
    let state = SILENT
    let listener: () => void = () => undefined
    const heard: string[] = []
    const player = {
      getState: () => state,
      subscribeState: (to: () => void) => {
        listener = to
        return () => undefined
      },
    }
    const stop = meterHeard(player, (id) => heard.push(id), now)
    const set = (change: Partial<PlayerState>) => {
      state = { ...state, ...change }
      listener()
    }
    return { heard, set, stop }
  }
  const play = (set: (change: Partial<PlayerState>) => void, id: string, durationS: number) => {
    set({ sourceId: id, takeId: id, durationS })
    set({ status: 'playing' })
  }

  test('half a minute of a long sound, while it goes on', () => {
    const { heard, set } = metered()
    play(set, 'a', 60)
    vi.advanceTimersByTime(29_900)
    expect(heard).toEqual([])
    vi.advanceTimersByTime(100)
    expect(heard).toEqual(['a'])
    vi.advanceTimersByTime(60_000)
    expect(heard).toEqual(['a'])
  })

  test('all of a shorter sound, in parts, and not the time in which it is paused', () => {
    const { heard, set } = metered()
    play(set, 'a', 2)
    vi.advanceTimersByTime(1_600)
    set({ status: 'paused' })
    vi.advanceTimersByTime(10_000)
    expect(heard).toEqual([])
    set({ status: 'playing' })
    vi.advanceTimersByTime(400)
    expect(heard).toEqual(['a'])
  })

  test('a very short sound that was over before anybody looked', () => {
    let nowMs = 0
    const { heard, set } = metered(() => nowMs)
    play(set, 'a', 0.01)
    nowMs = 11
    set({ status: 'paused' })
    expect(heard).toEqual(['a'])
  })

  test('a sound that was only skipped over is not heard, nor one that is still on its way', () => {
    const { heard, set } = metered()
    play(set, 'a', 10)
    vi.advanceTimersByTime(1_000)
    set({ sourceId: 'b', takeId: 'b' }) // selected: the first goes on until it is read
    vi.advanceTimersByTime(5_000)
    set({ durationS: 10 })
    vi.advanceTimersByTime(2_000)
    set({ status: 'paused' })
    expect(heard).toEqual([])
  })

  test('each sound of a set that is played as in the game', () => {
    const { heard, set } = metered()
    set({ isRandomized: true, status: 'playing', sourceId: 'a', takeId: 'a', durationS: 1 })
    vi.advanceTimersByTime(1_000)
    set({ sourceId: 'b', takeId: 'b', durationS: 0.4 })
    vi.advanceTimersByTime(400)
    expect(heard).toEqual(['a', 'b'])
  })

  test('a take in parts, as master and as game file, and nothing of a sound that is no take', () => {
    const { heard, set } = metered()
    play(set, 'a', 4)
    vi.advanceTimersByTime(3_000)
    set({ sourceId: 'a mobile' })
    set({ durationS: 4 })
    vi.advanceTimersByTime(1_000)
    expect(heard).toEqual(['a'])
    set({ sourceId: 'fixed', takeId: null })
    set({ durationS: 4 })
    vi.advanceTimersByTime(10_000)
    expect(heard).toEqual(['a'])
  })

  test('after it is stopped nothing is counted', () => {
    const { heard, set, stop } = metered()
    play(set, 'a', 10)
    stop()
    vi.advanceTimersByTime(10_000)
    expect(heard).toEqual([])
  })
})

describe('what was heard on its way to the server', () => {
  const PATH = `POST /v1/projects/${PROJECT}/heard-takes`
  const bodies = (asked: readonly { path: string; body: unknown }[]) =>
    asked.filter(({ path }) => path.endsWith('/heard-takes')).map(({ body }) => body)
  const settle = () => vi.advanceTimersByTimeAsync(2_000)

  test('is sent together', async () => {
    const { asked } = serve({ [PATH]: answer(null, 204) })
    const sent = vi.fn()
    const heard = new HeardTakes('ada', PROJECT, sent)
    heard.add('a')
    heard.add('b')
    heard.add('a')
    await settle()
    expect(bodies(asked)).toEqual([{ take_ids: ['a', 'b'] }])
    expect(sent).toHaveBeenCalledExactlyOnceWith(['a', 'b'])
    expect(localStorage).toHaveLength(0)
  })

  test('outlives a lost line and a closed page, for the same person alone', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')))
    const heard = new HeardTakes('ada', PROJECT, vi.fn())
    heard.add('a')
    await settle()
    const { asked } = serve({ [PATH]: answer(null, 204), 'GET /readyz': {} })
    new HeardTakes('ben', PROJECT, vi.fn())
    await vi.advanceTimersByTimeAsync(0)
    expect(bodies(asked)).toEqual([])
    new HeardTakes('ada', PROJECT, vi.fn())
    await settle()
    expect(bodies(asked)[0]).toEqual({ take_ids: ['a'] })
    expect(localStorage).toHaveLength(0)
  })

  test('is dropped where the server refuses it, and kept where it fails', async () => {
    const { asked, answers } = serve({ [PATH]: refusal(500, 'internal', 'It failed.') })
    const heard = new HeardTakes('ada', PROJECT, vi.fn())
    heard.add('a')
    await settle()
    expect(bodies(asked)).toHaveLength(1)
    answers[PATH] = refusal(404, 'project-not-found', 'There is no such project.')
    heard.add('b')
    await settle()
    expect(bodies(asked)).toEqual([{ take_ids: ['a'] }, { take_ids: ['a', 'b'] }])
    expect(localStorage).toHaveLength(0)
  })
})

test('a take is shown as heard in every list that has it', () => {
  const client = new QueryClient()
  const unheard = anItem({ id: 'shield' }, [aTake('a', { is_heard: false }), aTake('b', { is_heard: false })])
  client.setQueryData(queryKeys.reviewQueue(PROJECT), { pages: [{ items: [unheard], next: null }], pageParams: [null] })
  client.setQueryData(queryKeys.reviewQueue(PROJECT, 'count'), { cues: 1, is_all: true })
  client.setQueryData(queryKeys.cueReview('shield'), aReview(unheard))
  const entries = [
    { take_id: 'a', is_heard: false },
    { take_id: 'b', is_heard: false },
  ]
  client.setQueryData(queryKeys.playlist('combat'), { takes: entries })
  client.setQueryData(queryKeys.playlist('combat', 'live'), { take_id: 'a' })
  const other = { cue_id: 'door', unheard_take_ids: ['c'] }
  client.setQueryData(queryKeys.progress(PROJECT, 'cues'), [{ cue_id: 'shield', unheard_take_ids: ['a', 'b'] }, other])
  markHeard(client, PROJECT, ['a'])
  const { pages } =
    client.getQueryData<{ pages: { items: (typeof unheard)[] }[] }>(queryKeys.reviewQueue(PROJECT)) ?? {}
  const heard = (takes?: readonly { id: string; is_heard: boolean }[]) =>
    takes?.filter(({ is_heard }) => is_heard).map(({ id }) => id)
  expect(heard(pages?.[0]?.items[0]?.takes)).toEqual(['a'])
  expect(heard(client.getQueryData<ReturnType<typeof aReview>>(queryKeys.cueReview('shield'))?.takes)).toEqual(['a'])
  expect(client.getQueryData(queryKeys.playlist('combat'))).toEqual({
    takes: [{ take_id: 'a', is_heard: true }, entries[1]],
  })
  expect(client.getQueryData(queryKeys.playlist('combat', 'live'))).toEqual({ take_id: 'a' })
  const listed = client.getQueryData<object[]>(queryKeys.progress(PROJECT, 'cues'))
  expect(listed).toEqual([{ cue_id: 'shield', unheard_take_ids: ['b'] }, other])
  expect(listed?.[1]).toBe(other) // a row that does not change is not drawn again
  expect(client.getQueryData(queryKeys.reviewQueue(PROJECT, 'count'))).toEqual({ cues: 1, is_all: true })
})
