import { waitFor } from '@testing-library/react'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { unwrap, api } from './client'
import { outbox } from './outbox'
import { OfflineOutbox } from './offlineOutbox'

interface Arrived {
  method: string
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
  outbox.show({ waiting: [], refused: [] })
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
    const { method } = asked
    const one = {
      method,
      path,
      key: asked.headers.get('Idempotency-Key'),
      csrf: asked.headers.get('X-CSRF-Token'),
      body,
    }
    arrived.push(one)
    return answer(one)
  })
})

const say = (writes: OfflineOutbox, takeId: string, text: string, onKept: () => void = () => undefined) =>
  unwrap(
    api.POST('/v1/takes/{take_id}/comments', {
      params: { path: { take_id: takeId } },
      body: { text, mentions: [], heard: true },
      fetch: writes.fetch(`Comment on ${takeId}`, onKept),
    }),
  )
const texts = () => arrived.map(({ body }) => (body as { text: string }).text)
const begun = (onLateAnswer = () => undefined as void, personId = 'p1') => {
  outbox.writer = { personId, onLateAnswer }
  const writes = new OfflineOutbox()
  writes.begin()
  return writes
}
const approve = (writes: OfflineOutbox, key: string, onKept: () => void = () => undefined) =>
  unwrap(
    api.POST('/v1/takes/{take_id}/verdict', {
      params: { path: { take_id: 't1' } },
      headers: { 'Idempotency-Key': key },
      body: {
        kind: 'approve',
        note: '',
        reasons: [],
        seen_state: 'conforming',
        mentions: [],
        heard: true,
        send: false,
      },
      fetch: writes.fetch('t1 approved', onKept),
    }),
  )
const undo = (writes: OfflineOutbox, key: string, onKept: () => void = () => undefined) =>
  unwrap(
    api.DELETE('/v1/takes/{take_id}/verdict', {
      params: { path: { take_id: 't1' } },
      fetch: writes.fetch('undo', onKept, key),
    }),
  )
const nothing = () => undefined
const back = () => waitFor(() => expect(localStorage).toHaveLength(0))

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
    await waitFor(() => expect(onKept).toHaveBeenCalledTimes(2))
    const third = say(writes, 't1', 'three', onKept)
    await waitFor(() => expect(outbox.getState().waiting).toHaveLength(3))
    isThere = true
    await Promise.all([...said, third])
    expect(texts()).toEqual(['one', 'two', 'three'])
    expect(new Set(arrived.map(({ key }) => key)).size).toBe(3)
    expect(outbox.getState()).toEqual({ waiting: [], refused: [] })
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
    await waitFor(() => expect(localStorage).toHaveLength(1))
    begun(undefined, 'p2')
    expect(outbox.getState().waiting).toHaveLength(1)
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
    await waitFor(() => expect(onKept).toHaveBeenCalled())
    answer = () => Response.json({ status: 409, code: 'late', detail: 'the version moved on' }, { status: 409 })
    isThere = true
    await said
    expect(outbox.getState().refused).toMatchObject([{ what: 'Comment on t1', why: 'the version moved on' }])
    begun()
    expect(outbox.getState().refused).toHaveLength(1)
    for (const { place } of outbox.getState().refused) writes.forgetRefused(place)
    await back()
    begun()
    expect(outbox.getState().refused).toEqual([])
  })

  test('that are refused at once are answered to the caller alone', async () => {
    const writes = begun()
    answer = () => Response.json({ status: 409, code: 'late', detail: 'the version moved on' }, { status: 409 })
    await expect(say(writes, 't1', 'one')).rejects.toMatchObject({ code: 'late' })
    expect(outbox.getState().refused).toEqual([])
    expect(localStorage).toHaveLength(0)
  })

  test('wait for the person to sign in again', async () => {
    isThere = false
    const onKept = vi.fn()
    void say(begun(), 't1', 'one', onKept).catch(() => undefined)
    await waitFor(() => expect(onKept).toHaveBeenCalled())
    answer = () => Response.json({ status: 401, code: 'not-signed-in', detail: 'sign in first' }, { status: 401 })
    isThere = true
    await waitFor(() => expect(arrived).toHaveLength(1))
    expect(localStorage).toHaveLength(1)
    answer = () => Response.json({ id: 'v1' })
    begun()
    await back()
    expect(texts().at(-1)).toBe('one')
  })
})

test('writes are sent beside one another while the server is there', async () => {
  const writes = begun()
  const answers: (() => void)[] = []
  vi.stubGlobal('fetch', async () => {
    await new Promise<void>((resolve) => answers.push(resolve))
    return Response.json({})
  })
  const said: Promise<unknown>[] = []
  for (const text of ['one', 'two', 'three']) {
    said.push(say(writes, 't1', text))
    await waitFor(() => expect(answers).toHaveLength(said.length))
  }
  for (const answerOne of answers) answerOne()
  await Promise.all(said)
})

describe('the undo of a write that is sent later', () => {
  const methods = () => arrived.map(({ method }) => method)
  const away = async (writes: OfflineOutbox) => {
    isThere = false
    vi.spyOn(navigator, 'onLine', 'get').mockReturnValue(false)
    const onKept = vi.fn()
    const given = approve(writes, 'k1', onKept)
    given.catch(nothing)
    await waitFor(() => expect(onKept).toHaveBeenCalled())
    return { given }
  }
  const lineReturns = () => {
    isThere = true
    vi.spyOn(navigator, 'onLine', 'get').mockReturnValue(true)
  }

  test('takes it out at once where it was not sent, and nothing is sent later', async () => {
    const writes = begun()
    const { given } = await away(writes)
    const said = say(writes, 't2', 'two')
    await waitFor(() => expect(outbox.getState().waiting).toHaveLength(2))
    expect(writes.drop('k1')).toBe(true)
    await expect(given).rejects.toMatchObject({ name: 'AbortError' })
    expect(outbox.getState().waiting).toHaveLength(1)
    expect(localStorage).toHaveLength(1)
    lineReturns()
    await said
    expect(arrived.map(({ path }) => path)).toEqual(['/v1/takes/t2/comments'])
    expect(outbox.getState()).toEqual({ waiting: [], refused: [] })
  })

  test('is no longer sent by another page that had found it', async () => {
    const writes = begun()
    await away(writes)
    begun() // another page of the same person
    expect(writes.drop('k1')).toBe(true)
    lineReturns()
    await say(writes, 't2', 'two')
    await waitFor(() => expect(texts()).toContain('two'))
    expect(arrived.map(({ path }) => path)).not.toContain('/v1/takes/t1/verdict')
  })

  test('follows one that may have arrived, in order, and outlives the page', async () => {
    const writes = begun()
    answer = () => {
      isThere = false
      throw new TypeError('Failed to fetch') // it arrived, and its answer was lost
    }
    const onKept = vi.fn()
    void approve(writes, 'k1', onKept).catch(nothing)
    await waitFor(() => expect(onKept).toHaveBeenCalled())
    expect(writes.drop('k1')).toBe(false)
    const onUndoKept = vi.fn()
    void undo(writes, 'k1', onUndoKept).catch(nothing)
    await waitFor(() => expect(onUndoKept).toHaveBeenCalled())
    expect(localStorage).toHaveLength(2)
    answer = () => Response.json({})
    arrived = []
    begun() // the next page: the first one is closed, and would send the same with the same keys
    isThere = true
    await back()
    const sent = arrived.filter(({ key }, at) => arrived.findIndex((one) => one.key === key) === at)
    expect(sent.map(({ method, path }) => `${method} ${path}`)).toEqual([
      'POST /v1/takes/t1/verdict',
      'DELETE /v1/takes/t1/verdict',
    ])
  })

  test('waits for the answer to one that is being sent', async () => {
    const writes = begun()
    let answerVerdict = nothing
    vi.stubGlobal('fetch', async (asked: Request) => {
      arrived.push({ method: asked.method, path: '', key: null, csrf: null, body: null })
      if (asked.method === 'POST') await new Promise<void>((resolve) => (answerVerdict = resolve as typeof nothing))
      return Response.json({})
    })
    const given = approve(writes, 'k1')
    await waitFor(() => expect(methods()).toEqual(['POST']))
    expect(writes.drop('k1')).toBe(false)
    const undone = undo(writes, 'k1')
    await waitFor(() => expect(localStorage).toHaveLength(2))
    expect(methods()).toEqual(['POST'])
    answerVerdict()
    await Promise.all([given, undone])
    expect(methods()).toEqual(['POST', 'DELETE'])
    expect(localStorage).toHaveLength(0)
  })

  test('keeps nothing waiting that is written after it', async () => {
    const writes = begun()
    let answerVerdict = nothing
    vi.stubGlobal('fetch', async (asked: Request) => {
      arrived.push({ method: asked.method, path: new URL(asked.url).pathname, key: null, csrf: null, body: null })
      if (asked.url.endsWith('/verdict') && asked.method === 'POST')
        await new Promise<void>((resolve) => (answerVerdict = resolve as typeof nothing))
      return Response.json({})
    })
    const given = approve(writes, 'k1')
    await waitFor(() => expect(methods()).toEqual(['POST']))
    const undone = undo(writes, 'k1')
    await say(writes, 't2', 'two')
    expect(methods()).toEqual(['POST', 'POST'])
    answerVerdict()
    await Promise.all([given, undone])
    expect(methods()).toEqual(['POST', 'POST', 'DELETE'])
  })

  test('is not sent where the server refuses what it would undo', async () => {
    const writes = begun()
    const { given } = await away(writes)
    const undone = undo(writes, 'k1')
    await waitFor(() => expect(localStorage).toHaveLength(2))
    answer = () => Response.json({ status: 409, code: 'late', detail: 'the version moved on' }, { status: 409 })
    lineReturns()
    await expect(undone).rejects.toMatchObject({ name: 'AbortError' })
    await expect(given).rejects.toMatchObject({ code: 'late' })
    await expect(undo(writes, 'k1')).rejects.toMatchObject({ name: 'AbortError' })
    expect(methods()).toEqual(['POST'])
    expect(outbox.getState()).toMatchObject({ waiting: [], refused: [{ what: 't1 approved' }] })
  })

  test('a write is sent all the same where the browser is wrong to know of no line', async () => {
    const writes = begun()
    vi.spyOn(navigator, 'onLine', 'get').mockReturnValue(false)
    await say(writes, 't1', 'one')
    expect(texts()).toEqual(['one'])
  })
})
