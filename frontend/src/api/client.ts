import createClient, { type Middleware } from 'openapi-fetch'

import { ApiProblem, lineLost, problemOf } from './problem'
import type { paths } from './schema.gen'

const CSRF_COOKIE = 'soundlist_csrf'
const SAFE = new Set(['GET', 'HEAD', 'OPTIONS'])

/** The token that proves a request comes from our own page. */
export function csrfToken(): string | undefined {
  const pair = document.cookie.split('; ').find((part) => part.startsWith(`${CSRF_COOKIE}=`))
  return pair && decodeURIComponent(pair.slice(CSRF_COOKIE.length + 1))
}

/** A fresh key for one act, so that sending it twice does it once. randomUUID would want HTTPS. */
export function newIdempotencyKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16))
  return [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join('')
}

const ourHeaders: Middleware = {
  onRequest({ request }) {
    if (SAFE.has(request.method)) return
    const token = csrfToken()
    if (token !== undefined) request.headers.set('X-CSRF-Token', token)
    if (request.method === 'POST' && !request.headers.has('Idempotency-Key')) {
      request.headers.set('Idempotency-Key', newIdempotencyKey())
    }
  },
}

/** The server, typed by its OpenAPI document: `api.GET('/v1/me')`. */
export const api = createClient<paths>({
  baseUrl: globalThis.location.origin,
  credentials: 'same-origin',
  // openapi-fetch would keep the fetch of import time; tests and instrumentation replace it later.
  fetch: (request) => globalThis.fetch(request),
})
api.use(ourHeaders)

type Answer<T> = { data?: T; error?: unknown; response: Response }

/** The data of an answer; a refusal is thrown as an ApiProblem, so that queries and mutations see it as their error. */
export async function answered<T>(asking: Promise<Answer<T>>): Promise<T> {
  let answer: Answer<T>
  try {
    answer = await asking
  } catch (error) {
    if (error instanceof ApiProblem || (error instanceof DOMException && error.name === 'AbortError')) throw error
    throw lineLost()
  }
  if (!answer.response.ok) throw problemOf(answer.response.status, answer.error)
  return answer.data as T
}
