import { vi } from 'vitest'

export interface Asked {
  method: string
  path: string
  query: URLSearchParams
  headers: Headers
  body: unknown
}

type Reply = { status: number; body: unknown }
export type Answers = Record<string, unknown>

/** A refusal as problem details name it. */
export function refusal(status: number, code: string, detail: string, more: Record<string, unknown> = {}): Reply {
  return { status, body: { type: 'about:blank', title: 'Refused', status, code, detail, ...more } }
}

export const answer = (body: unknown, status = 200): Reply => ({ status, body })

const FILE_TYPES = ['application/pdf', 'application/octet-stream', 'application/offset+octet-stream']

/** Whether a file is sent by itself; jsdom makes it a text. */
const isFile = (request: Request) => FILE_TYPES.includes(request.headers.get('Content-Type') ?? '')

const isReply = (value: unknown): value is Reply => typeof value === 'object' && value !== null && 'body' in value

/**
 * Stand at the edge of the network: `'GET /v1/me': {…}`, a function of what was asked, a refusal, or `answer(…, 201)`.
 * Undescribed requests are a 404, and all requests are recorded.
 */
export function serve(answers: Answers): { asked: Asked[]; answers: Answers } {
  const asked: Asked[] = []
  vi.stubGlobal('fetch', async (input: RequestInfo | URL, init?: RequestInit) => {
    const address = input instanceof URL ? input.href : input
    const request = new Request(typeof address === 'string' ? new URL(address, location.origin) : address, init)
    const { pathname, searchParams } = new URL(request.url)
    const text = await request.text()
    const one: Asked = {
      method: request.method,
      path: pathname,
      query: searchParams,
      headers: request.headers,
      body: text === '' ? undefined : isFile(request) ? text : JSON.parse(text),
    }
    asked.push(one)
    const found = answers[`${request.method} ${pathname}`]
    const given: unknown = await (typeof found === 'function' ? (found as (asked: Asked) => unknown)(one) : found)
    const reply =
      found === undefined ? refusal(404, 'not-found', 'nothing is here') : isReply(given) ? given : answer(given)
    const empty = reply.status === 204
    return new Response(empty ? null : JSON.stringify(reply.body), {
      status: reply.status,
      headers: empty ? { 'Content-Length': '0' } : { 'Content-Type': 'application/json' },
    })
  })
  return { asked, answers }
}

/** What was asked of the server by a method and path, as in "POST /v1/projects". */
export const wrote = (asked: readonly Asked[], what: string) =>
  asked.filter(({ method, path }) => `${method} ${path}` === what)
