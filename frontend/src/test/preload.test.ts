import { waitFor } from '@testing-library/react'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'

import { prefetchedAnswer } from '@/api/prefetched'

import { preloadPage } from '../../scripts/preload'

const PROJECT = '0190a1b2-0000-7000-8000-000000000001'
const QUEUE = `/v1/review-queue?project_id=${PROJECT}`
const PAGES = [
  {
    at: '^/projects/([0-9a-f-]{36})/review$',
    asks: ['/v1/me', '/v1/review-queue?project_id={project}'],
    files: ['/assets/ReviewPage.js', '/assets/ReviewPage.css'],
  },
]
const item = (id: string, draft: object | null) => ({ cue: { id }, takes: [{ draft_change: draft }] })

let asked: string[]
const links = () =>
  [...document.head.querySelectorAll('link')].map(({ rel, href }) => `${rel} ${new URL(href).pathname}`)
const taken = (path: string, method = 'GET') => prefetchedAnswer(new Request(location.origin + path, { method }))

beforeEach(() => {
  asked = []
  vi.stubGlobal('fetch', (path: string) => {
    asked.push(path)
    return Promise.resolve(Response.json({ items: [item('noted', {}), item('first', null), item('second', null)] }))
  })
})

afterEach(() => {
  document.head.replaceChildren()
  history.replaceState(null, '', '/')
})

test('a page known by its address has its files and its answers on their way, and what Review opens of the queue', async () => {
  history.replaceState(null, '', `/projects/${PROJECT}/review`)
  preloadPage(PAGES)
  await waitFor(() => expect(asked).toEqual(['/v1/me', QUEUE, '/v1/cues/first/review']))
  expect(links()).toEqual(['modulepreload /assets/ReviewPage.js', 'preload /assets/ReviewPage.css'])
  expect(await (await taken(QUEUE))?.json()).toHaveProperty('items')
})

test('a desk has the fix of what came back first on its way', async () => {
  vi.stubGlobal('fetch', (path: string) => {
    asked.push(path)
    return Promise.resolve(Response.json({ came_back: [{ take_id: 'newest' }, { take_id: 'older' }] }))
  })
  history.replaceState(null, '', `/projects/${PROJECT}/desk`)
  preloadPage([{ at: '^/projects/([0-9a-f-]{36})/desk$', asks: ['/v1/projects/{project}/desk'], files: [] }])
  await waitFor(() => expect(asked).toEqual([`/v1/projects/${PROJECT}/desk`, '/v1/takes/newest/fix']))
})

test('an answer is taken once, by a request that only reads, while it is fresh', () => {
  history.replaceState(null, '', `/projects/${PROJECT}/review`)
  preloadPage(PAGES)
  expect(taken('/v1/me', 'POST')).toBeUndefined()
  expect(taken('/v1/session')).toBeUndefined()
  expect(taken('/v1/me')).toBeDefined()
  expect(taken('/v1/me')).toBeUndefined()
  vi.spyOn(performance, 'now').mockReturnValue(performance.now() + 11_000)
  expect(taken(QUEUE)).toBeUndefined()
})

test('of other pages nothing is prefetched', () => {
  history.replaceState(null, '', `/projects/${PROJECT}/people`)
  preloadPage(PAGES)
  expect(asked).toEqual([])
  expect(links()).toEqual([])
})
