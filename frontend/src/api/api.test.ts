import { waitFor } from '@testing-library/react'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { refusal } from '@/test/server'

import { unwrap, api, ApiProblem, connection, newIdempotencyKey, onSessionEnd, problemOf } from './index'
import { worthAskingAgain } from './queryClient'

/** Any path will do here: which paths there are is the schema's business. */
const anyApi = api as unknown as {
  GET: (path: string, init?: object) => Promise<{ data?: unknown; error?: unknown; response: Response }>
  POST: (path: string, init?: object) => Promise<{ data?: unknown; error?: unknown; response: Response }>
}

let requests: Request[]
let answer: () => Response

beforeEach(() => {
  requests = []
  answer = () => Response.json({ ok: true })
  document.cookie = 'soundlist_csrf=t%2Foken; path=/'
  vi.stubGlobal('fetch', (request: Request) => {
    requests.push(request)
    return Promise.resolve(answer())
  })
})

describe('requests', () => {
  test('what changes nothing carries neither token nor key', async () => {
    await anyApi.GET('/v1/me')
    expect(requests[0]?.headers.has('X-CSRF-Token')).toBe(false)
    expect(requests[0]?.headers.has('Idempotency-Key')).toBe(false)
    expect(requests[0]?.credentials).toBe('same-origin')
  })

  test('over TLS the token comes in a cookie that is bound to the host', async () => {
    vi.spyOn(document, 'cookie', 'get').mockReturnValue('theme=dark; __Host-soundlist_csrf=bound%2Ftoken')
    await anyApi.POST('/v1/projects', { body: {} })
    expect(requests[0]?.headers.get('X-CSRF-Token')).toBe('bound/token')
    vi.restoreAllMocks()
  })

  test('what changes something proves that it comes from our page, and is done once', async () => {
    await anyApi.POST('/v1/projects', { body: {} })
    await anyApi.POST('/v1/projects', { body: {} })
    const keys = requests.map(({ headers }) => headers.get('Idempotency-Key'))
    expect(requests[0]?.headers.get('X-CSRF-Token')).toBe('t/oken')
    expect(keys[0]).toMatch(/^[0-9a-f]{32}$/)
    expect(keys[0]).not.toBe(keys[1])
  })

  test('a key of the caller is kept, so that a repeated act stays one', async () => {
    const key = newIdempotencyKey()
    await anyApi.POST('/v1/projects', { headers: { 'Idempotency-Key': key } })
    expect(requests[0]?.headers.get('Idempotency-Key')).toBe(key)
  })
})

describe('answers', () => {
  test('data comes through', async () => {
    await expect(unwrap(anyApi.GET('/v1/me'))).resolves.toEqual({ ok: true })
  })

  test('a refusal is thrown with its code, its fix and what stands against each field', async () => {
    answer = () =>
      new Response(
        JSON.stringify({
          title: 'Invalid request',
          status: 422,
          code: 'invalid-request',
          detail: 'name: is taken',
          fix: 'Choose another.',
          errors: [{ where: 'name', message: 'is taken' }],
          request_id: 'r1',
        }),
        { status: 422, headers: { 'content-type': 'application/problem+json' } },
      )
    const refusal = await unwrap(anyApi.POST('/v1/projects', { body: {} })).catch((error: unknown) => error)
    expect(refusal).toBeInstanceOf(ApiProblem)
    const problem = refusal as ApiProblem
    expect([problem.status, problem.code, problem.message, problem.fix]).toEqual([
      422,
      'invalid-request',
      'name: is taken',
      'Choose another.',
    ])
    expect(problem.of('name')?.message).toBe('is taken')
    expect(problem.of('other')).toBeUndefined()
    expect(problem.more.request_id).toBe('r1')
  })

  test('a write that nobody answers is refused at once', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')))
    await expect(unwrap(anyApi.POST('/v1/sign-out'))).rejects.toMatchObject({ status: 0, code: 'line-lost' })
    vi.stubGlobal('fetch', () => Promise.resolve(new Response('{}')))
    await waitFor(() => expect(connection.isUnreachable()).toBe(false))
  })

  test('reads wait for the server to come back, and the page says so meanwhile', async () => {
    let isThere = false
    vi.stubGlobal('fetch', () =>
      isThere
        ? Promise.resolve(Response.json({ name: 'Ada' }))
        : Promise.resolve(new Response('Bad Gateway', { status: 502 })),
    )
    const read = unwrap(anyApi.GET('/v1/me'))
    await waitFor(() => expect(connection.isUnreachable()).toBe(true))
    isThere = true
    expect(await read).toEqual({ name: 'Ada' })
    expect(connection.isUnreachable()).toBe(false)
  })

  test('a server that is too busy is there', async () => {
    const { body } = refusal(503, 'overloaded', 'busy')
    vi.stubGlobal('fetch', () => Promise.resolve(Response.json(body, { status: 503 })))
    await expect(unwrap(anyApi.GET('/v1/me'))).rejects.toMatchObject({ code: 'overloaded' })
    expect(connection.isUnreachable()).toBe(false)
  })

  test('where the session has ended, one sign-in serves all, and each request is sent again', async () => {
    let isSignedIn = false
    const sent: string[] = []
    vi.stubGlobal('fetch', async (request: Request) => {
      const text = await request.text()
      sent.push(`${request.method} ${request.headers.get('X-CSRF-Token') ?? ''} ${text}`)
      const { body } = refusal(401, 'not-signed-in', 'sign in first')
      return isSignedIn ? Response.json({ kept: true }) : Response.json(body, { status: 401 })
    })
    const ask = vi.fn(() => {
      isSignedIn = true
      document.cookie = 'soundlist_csrf=new-token; path=/'
      return Promise.resolve(true)
    })
    const forget = onSessionEnd(ask)
    const answers = await Promise.all([
      unwrap(anyApi.POST('/v1/projects', { body: { name: 'Typed' } })),
      unwrap(anyApi.GET('/v1/me')),
    ])
    forget()
    expect(answers).toEqual([{ kept: true }, { kept: true }])
    expect(ask).toHaveBeenCalledTimes(1)
    expect(sent).toContain('POST new-token {"name":"Typed"}')
  })

  test('a wrong password is not a session that ended', async () => {
    const { body } = refusal(401, 'wrong-sign-in', 'no')
    vi.stubGlobal('fetch', () => Promise.resolve(Response.json(body, { status: 401 })))
    const ask = vi.fn(() => Promise.resolve(true))
    const forget = onSessionEnd(ask)
    await expect(unwrap(anyApi.POST('/v1/sign-in'))).rejects.toMatchObject({ code: 'wrong-sign-in' })
    expect(ask).not.toHaveBeenCalled()
    forget()
  })

  test('a question that was taken back is not a problem of the line', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new DOMException('aborted', 'AbortError')))
    await expect(unwrap(anyApi.GET('/v1/me'))).rejects.toMatchObject({ name: 'AbortError' })
  })

  test.each([
    [502, '<html>bad gateway</html>', 'http-502', /on the server/],
    [418, null, 'http-418', /418/],
  ])('a body that is not a problem document still becomes a sentence: %s', (status, body, code, detail) => {
    const problem = problemOf(status, body)
    expect(problem.code).toBe(code)
    expect(problem.detail).toMatch(detail)
  })
})

test('asking again is for lines and servers that break, not for refusals', () => {
  const problem = (status: number) => new ApiProblem(status, { code: 'x', detail: '' })
  expect(worthAskingAgain(0, problem(404))).toBe(false)
  expect(worthAskingAgain(0, problem(0))).toBe(true)
  expect(worthAskingAgain(1, problem(503))).toBe(true)
  expect(worthAskingAgain(2, problem(503))).toBe(false)
})
