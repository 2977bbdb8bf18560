import createClient, { type Middleware } from 'openapi-fetch'

import { serverReturns } from './connection'
import { prefetchedAnswer } from './prefetched'
import { ApiProblem, networkError, problemOf } from './problem'
import type { paths } from './schema.gen'
import { whileSending } from './sending'
import { signedInAgain, type SignInReason, signInsSoFar } from './signIn'

const CSRF_COOKIE = /(?:^|; )(?:__Host-)?soundlist_csrf=([^;]*)/ // the prefix is there over TLS
const SAFE = new Set(['GET', 'HEAD', 'OPTIONS'])

/** The token that proves a request comes from our own page. */
export function csrfToken(): string | undefined {
  const value = CSRF_COOKIE.exec(document.cookie)?.[1]
  return value === undefined ? undefined : decodeURIComponent(value)
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

/** Whether no server was reached: a proxy answers with a status of its own. */
const isUnreachable = ({ status }: Response) => status === 502 || status === 503 || status === 504

async function fetchOnce(request: Request): Promise<Response | null> {
  try {
    const response = await (prefetchedAnswer(request) ?? globalThis.fetch(request))
    return isUnreachable(response) && !(await isBusy(response)) ? null : response
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') throw error
    return null
  }
}

async function codeOf(response: Response): Promise<string | undefined> {
  if (response.headers.get('Content-Type')?.includes('json') !== true) return undefined
  const problem: unknown = await response.clone().json()
  return typeof problem === 'object' && problem !== null && 'code' in problem ? String(problem.code) : undefined
}

/** A server that is up, and is too busy or refuses. */
async function isBusy(response: Response): Promise<boolean> {
  const code = await codeOf(response)
  return code !== undefined && code !== 'database-away'
}

/** Why the server wants the person to sign in before it answers; null where it does not. */
async function reasonToSignIn(response: Response): Promise<SignInReason | null> {
  if (response.status !== 401 && response.status !== 403) return null
  const code = await codeOf(response)
  if (code === 'not-signed-in') return 'ended'
  return code === 'recent-sign-in-needed' ? 'recent' : null
}

/** Send a request; a write counts as in flight until its answer is here. */
export const send = (request: Request): Promise<Response> =>
  SAFE.has(request.method) ? deliver(request) : whileSending(() => deliver(request))

/**
 * Send a request. What only reads waits while the server is away, so that pages keep what they show; a write is refused
 * at once, with what was typed still there. Either is sent again after signing in, where the server asks for that.
 */
async function deliver(request: Request): Promise<Response> {
  for (;;) {
    const sentAfter = signInsSoFar()
    const response = await fetchOnce(request.clone())
    const reason = response && (await reasonToSignIn(response))
    if (response === null) {
      const back = serverReturns()
      if (!SAFE.has(request.method)) throw networkError()
      await back
    } else if (reason !== null && (await signedInAgain(sentAfter, reason))) {
      const token = csrfToken()
      if (!SAFE.has(request.method) && token !== undefined) request.headers.set('X-CSRF-Token', token)
    } else return response
  }
}

/** The server, typed by its OpenAPI document: `api.GET('/v1/me')`. */
export const api = createClient<paths>({
  baseUrl: globalThis.location.origin,
  credentials: 'same-origin',
  fetch: send,
})
api.use(ourHeaders)

type Answer<T> = { data?: T; error?: unknown; response: Response }

/** The data of an answer; a refusal is thrown as an ApiProblem, so that queries and mutations see it as their error. */
export async function unwrap<T>(asking: Promise<Answer<T>>): Promise<T> {
  let answer: Answer<T>
  try {
    answer = await asking
  } catch (error) {
    if (error instanceof ApiProblem || (error instanceof DOMException && error.name === 'AbortError')) throw error
    throw networkError()
  }
  if (!answer.response.ok) throw problemOf(answer.response.status, answer.error)
  return answer.data as T
}
