import { beforeEach, describe, expect, test, vi } from 'vitest'

import { answered, api } from './client'
import { later } from './later'
import { LaterWrites } from './laterWrites'

interface Arrived {
  path: string
  key: string | null
  csrf: string | null
  body: unknown
}

let isThere: boolean
let arrived: Arrived[]
let answer: (arrived: Arrived) => Response

beforeEach(() => {
  localStorage.clear()
  later.show({ waiting: 0, refused: [] })
  document.cookie = 'soundlist_csrf=of-now; path=/'
  isThere = true
  arrived = []
  answer = () => Response.json({ id: 'v1' }, { status: 201 })
  vi.stubGlobal('fetch', async (asked: Request | URL) => {
    if (!isThere) throw new TypeError('Failed to fetch')
    if (!(asked instanceof Request)) return new Response('{}')
    const path = new URL(asked.url).pathname
    const text = await asked.text()
    const body: unknown = text === '' ? null : JSON.parse(text)
    const one = { path, key: asked.headers.get('Idempotency-Key'), csrf: asked.headers.get('X-CSRF-Token'), body }
    arrived.push(one)
    return answer(one)
  })
})

const say = (writes: LaterWrites, takeId: string, text: string, onKept: () => void = () => undefined) =>
  answered(
    api.POST('/v1/takes/{take_id}/comments', {
      params: { path: { take_id: takeId } },
      body: { text, mentions: [] },
      fetch: writes.fetch(`Comment on ${takeId}`, onKept),
    }),
  )
const texts = () => arrived.map(({ body }) => (body as { text: string }).text)
const begun = (onLateAnswer = () => undefined as void, personId = 'p1') => {
  later.writer = { personId, onLateAnswer }
  const writes = new LaterWrites()
  writes.begin()
  return writes
}
const back = () => vi.waitFor(() => expect(localStorage).toHaveLength(0), 8_000)

describe('writes that a lost line must not lose', () => {
  test('are answered at once where the server is there, and nothing is kept', async () => {
    const onKept = vi.fn()
    await expect(say(begun(), 't1', 'one', onKept)).resolves.toEqual({ id: 'v1' })
    expect(onKept).not.toHaveBeenCalled()
    expect(arrived.map(({ csrf }) => csrf)).toEqual(['of-now'])
    expect(localStorage).toHaveLength(0)
  })

  test('wait for the connection, and are sent in order, each with its own key', async () => {
    const writes = begun()
    isThere = false
    const onKept = vi.fn()
    const said = [say(writes, 't1', 'one', onKept), say(writes, 't2', 'two', onKept)]
    await vi.waitFor(() => expect(onKept).toHaveBeenCalledTimes(2))
    const third = say(writes, 't1', 'three', onKept)
    await vi.waitFor(() => expect(later.getState().waiting).toBe(3))
    isThere = true
    await Promise.all([...said, third])
    expect(texts()).toEqual(['one', 'two', 'three'])
    expect(new Set(arrived.map(({ key }) => key)).size).toBe(3)
    expect(later.getState()).toEqual({ waiting: 0, refused: [] })
    expect(localStorage).toHaveLength(0)
  })

  test('whose answer was lost come again with the same key', async () => {
    const writes = begun()
    answer = () => {
      answer = () => Response.json({ id: 'v1' })
      throw new TypeError('Failed to fetch')
    }
    await say(writes, 't1', 'one')
    expect(texts()).toEqual(['one', 'one'])
    expect(arrived[0]?.key).toBe(arrived[1]?.key)
  })

  test('outlive the page, and the next one of the same person sends them first', async () => {
    isThere = false
    void say(begun(), 't1', 'one')
    await vi.waitFor(() => expect(localStorage).toHaveLength(1))
    begun(undefined, 'p2')
    expect(later.getState().waiting).toBe(1)
    const onLateAnswer = vi.fn()
    const next = begun(onLateAnswer)
    const two = say(next, 't2', 'two')
    isThere = true
    await two
    expect(texts().filter((text) => text !== 'two')).not.toHaveLength(0)
    expect(texts().at(-1)).toBe('two')
    expect(new Set(arrived.filter(({ path }) => path.includes('t1')).map(({ key }) => key)).size).toBe(1)
    expect(onLateAnswer).toHaveBeenCalled()
  })

  test('that are refused once the person has gone on are shown with the reason, until they are read', async () => {
    const writes = begun()
    isThere = false
    const onKept = vi.fn()
    const said = say(writes, 't1', 'one', onKept).catch(() => undefined)
    await vi.waitFor(() => expect(onKept).toHaveBeenCalled())
    answer = () => Response.json({ status: 409, code: 'late', detail: 'the version moved on' }, { status: 409 })
    isThere = true
    await said
    expect(later.getState().refused).toMatchObject([{ what: 'Comment on t1', why: 'the version moved on' }])
    begun()
    expect(later.getState().refused).toHaveLength(1)
    for (const { place } of later.getState().refused) writes.forgetRefused(place)
    await back()
    begun()
    expect(later.getState().refused).toEqual([])
  })

  test('that are refused at once are answered to the caller alone', async () => {
    const writes = begun()
    answer = () => Response.json({ status: 409, code: 'late', detail: 'the version moved on' }, { status: 409 })
    await expect(say(writes, 't1', 'one')).rejects.toMatchObject({ code: 'late' })
    expect(later.getState().refused).toEqual([])
    expect(localStorage).toHaveLength(0)
  })

  test('wait for the person to sign in again', async () => {
    isThere = false
    const onKept = vi.fn()
    void say(begun(), 't1', 'one', onKept).catch(() => undefined)
    await vi.waitFor(() => expect(onKept).toHaveBeenCalled())
    answer = () => Response.json({ status: 401, code: 'not-signed-in', detail: 'sign in first' }, { status: 401 })
    isThere = true
    await vi.waitFor(() => expect(arrived).toHaveLength(1), 8_000)
    expect(localStorage).toHaveLength(1)
    answer = () => Response.json({ id: 'v1' })
    begun()
    await back()
    expect(texts().at(-1)).toBe('one')
  })
})
