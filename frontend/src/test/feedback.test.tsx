import { act, screen, waitFor } from '@testing-library/react'
import { beforeAll, beforeEach, expect, test, vi } from 'vitest'

import { unwrap, api } from '@/api'
import { router } from '@/app/router'
import type { Code } from '@/app/prefetchPage'
import { StatusSlot } from '@/app/toast'

import { HandContext } from './audioContext'
import { draw } from './draw'
import { openApp } from './openApp'
import { aMe, PROJECT } from './review'

type Route = { options: { component?: unknown; beforeLoad?: unknown; loader?: unknown } }
/** What no answer of the server is needed for: the pages of the checks come with the product. */
const NEEDS_NO_ANSWER = ['/$', '/checks/$check']
const routes = Object.entries(router.routesByPath as Record<string, Route>).filter(
  ([path]) => !NEEDS_NO_ANSWER.includes(path),
)
const addressOf = (path: string) => path.replace('$projectId', PROJECT).replace(/\$\w+/g, 'id')
const me = aMe()

/** A server that says who is signed in, and answers nothing else. */
const ANSWERED: Record<string, unknown> = {
  '/v1/me': me,
  '/v1/session': { signed_in: true, demo: false, person: me.person },
}

beforeAll(async () => {
  for (const [, { options }] of routes) await (options.component as Code | undefined)?.preload?.()
}, 240_000)

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

const hold = (answers: Record<string, unknown>) =>
  vi.stubGlobal('fetch', ({ url }: Request) => {
    const body = answers[new URL(url).pathname]
    return body === undefined ? new Promise(() => undefined) : Promise.resolve(Response.json(body))
  })

test('there are pages to go through', () => expect(routes.length).toBeGreaterThan(60))

test.each(routes)(
  '%s shows that it waits, or what one can do, while its answers are held',
  async (path, { options }) => {
    hold(ANSWERED)
    const app = openApp(addressOf(path))
    const waitsBefore = options.beforeLoad !== undefined || options.loader !== undefined
    await waitFor(() => {
      if (!waitsBefore) expect(app.isLoaded(), 'the page itself is there').toBe(true)
      const main = screen.getByRole('main')
      expect(
        main.matches('[data-waiting]') || main.querySelector('[aria-busy="true"], [role="alert"], button, input'),
      ).toBeTruthy()
    })
  },
)

test.each(['/', '/sign-in', `/projects/${PROJECT}/review`])(
  '%s shows that it waits for who is signed in',
  async (path) => {
    hold({})
    openApp(path)
    await waitFor(() => expect(document.body.querySelector('[aria-busy="true"], form')).not.toBeNull())
  },
)

test('any write that waits for its answer is said in the status slot after a moment, and no longer once it is here', async () => {
  let answer: (response: Response) => void = () => undefined
  vi.stubGlobal('fetch', () => new Promise<Response>((resolve) => (answer = resolve)))
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  try {
    draw(<StatusSlot />)
    const slot = screen.getByRole('status')
    const write = unwrap(api.POST('/v1/sign-out'))
    await act(() => vi.advanceTimersByTimeAsync(299))
    expect(slot).toBeEmptyDOMElement()
    await act(() => vi.advanceTimersByTimeAsync(1))
    expect(slot).toHaveTextContent('Sending…')
    await act(async () => {
      answer(new Response(null, { status: 204 }))
      await write
    })
    expect(slot).toBeEmptyDOMElement()
  } finally {
    vi.useRealTimers()
  }
})
