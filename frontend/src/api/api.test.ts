import { beforeEach, describe, expect, test, vi } from 'vitest'

import { answered, api, ApiProblem, newIdempotencyKey, problemOf } from './index'
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
    await expect(answered(anyApi.GET('/v1/me'))).resolves.toEqual({ ok: true })
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
    const refusal = await answered(anyApi.POST('/v1/projects', { body: {} })).catch((error: unknown) => error)
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

  test('a line that drops is told apart from a refusal', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')))
    await expect(answered(anyApi.GET('/v1/me'))).rejects.toMatchObject({ status: 0, code: 'line-lost' })
  })

  test('a question that was taken back is no problem of the line', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new DOMException('aborted', 'AbortError')))
    await expect(answered(anyApi.GET('/v1/me'))).rejects.toMatchObject({ name: 'AbortError' })
  })

  test.each([
    [502, '<html>bad gateway</html>', 'http-502', /our fault/],
    [418, null, 'http-418', /418/],
  ])('a body that is no problem document still becomes a sentence: %s', (status, body, code, detail) => {
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
