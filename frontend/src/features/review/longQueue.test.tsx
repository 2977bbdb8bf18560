import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aDraft, aMe, anItem, aPreview, aReview, aServer, aTake, PROJECT, somePeaks } from '@/test/review'
import { type Asked, refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))

const CUES = 32
const A_PAGE = 12
const items = Array.from({ length: CUES }, (_, place) =>
  anItem({ id: `cue-${place}`, name: `hit_${place}`, label: `SW-${place}` }, [aTake(`take-${place}`)]),
)
const noted = items.map((item) => ({
  ...item,
  takes: item.takes.map((take) => ({ ...take, draft_change: aDraft(take, item.cue, 'Too loud.') })),
}))

let server: ReturnType<typeof aServer>
let queue: typeof items

/** A page from the cue that a cursor names. */
const page = ({ query }: Asked) => {
  const from = Number(query.get('cursor') ?? 0)
  const to = from + A_PAGE
  return { items: queue.slice(from, to), next: to < queue.length ? String(to) : null }
}
const pagesAsked = () => server.of('GET /v1/review-queue').map(({ query }) => query.get('cursor') ?? 'first')

beforeEach(() => {
  dismissToast()
  vi.stubGlobal('AudioContext', HandContext)
  queue = items
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', page)
    .on('GET /v1/review-queue/count', () => ({ cues: 99, is_all: false }))
    .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
    .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
    .on(`GET /v1/projects/${PROJECT}/judged-lately`, [])
  for (const item of items) {
    server
      .on(`GET /v1/cues/${item.cue.id}/review`, aReview(item))
      .on(`GET /v1/sounds/${item.takes[0]?.id}/preview`, aPreview)
      .on(`GET /v1/sounds/${item.takes[0]?.id}/peaks.json`, somePeaks)
  }
})

const heading = (place: number) => screen.findByRole('heading', { name: `hit_${place}`, level: 1 })
const opened = async (place: number) => {
  openApp(`/projects/${PROJECT}/review/cue-${place}`)
  await screen.findByRole('region', { name: 'Verdict' })
  await within(panel()).findByRole('link', { name: /hit_11/ })
}
const panel = () => screen.getByRole('complementary', { name: 'Queue' })

describe('a long queue in the review room', () => {
  test('is read as far as it is needed, and no further', async () => {
    await opened(1)
    expect(pagesAsked()).toEqual(['first'])
    await userEvent.keyboard('j')
    await heading(2)
    expect(await within(panel()).findByRole('link', { name: /hit_23/ })).toBeInTheDocument()
    await userEvent.keyboard('j')
    await heading(3)
    expect(pagesAsked()).toEqual(['first', '12'])
  })

  test('says how many wait, those that are not here among them', async () => {
    await opened(0)
    await waitFor(() => expect(panel()).toHaveTextContent('99+ waiting'))
    expect(screen.getByRole('link', { name: /^Review/ })).toHaveTextContent('99+ waiting')
    server.on('GET /v1/review-queue/count', () => ({ cues: 31, is_all: true }))
    server.on('POST /v1/takes/take-0/verdict', {})
    queue = items.slice(1)
    await userEvent.keyboard('a')
    await heading(1)
    await waitFor(() => expect(panel()).toHaveTextContent('31 waiting'))
  })

  test('j at the end of what is here goes on where the next page begins', async () => {
    let send: () => void = () => undefined
    const held = new Promise<void>((resolve) => (send = resolve))
    server.on('GET /v1/review-queue', async (asked: Asked) => {
      if (asked.query.get('cursor') === '12') await held
      return page(asked)
    })
    await opened(11)
    await waitFor(() => expect(pagesAsked()).toEqual(['first', '12']))
    await userEvent.keyboard('j')
    send()
    await heading(12)
    expect(pagesAsked()).toEqual(['first', '12'])
  })

  test('what was just judged stays out when the next page, asked for before, arrives', async () => {
    let send: () => void = () => undefined
    const held = new Promise<void>((resolve) => (send = resolve))
    let answer: (verdict: object) => void = () => undefined
    const verdict = new Promise<object>((resolve) => (answer = resolve))
    server.on('GET /v1/review-queue', async (asked: Asked) => {
      if (asked.query.get('cursor') === '12') await held
      return page(asked)
    })
    server.on('POST /v1/takes/take-3/verdict', () => verdict)
    await opened(3)
    await waitFor(() => expect(pagesAsked()).toEqual(['first', '12']))
    await userEvent.keyboard('a')
    await heading(4)
    send()
    expect(await within(panel()).findByRole('link', { name: /hit_12 / })).toBeInTheDocument()
    expect(within(panel()).queryByRole('link', { name: /hit_3 / })).toBeNull()
    answer({})
    await waitFor(() => expect(pagesAsked().filter((cursor) => cursor === 'first')).toHaveLength(2))
  })

  test('a cue far behind opens by its address, and j goes to what waits longest', async () => {
    await opened(30)
    expect(await heading(30)).toBeVisible()
    expect(pagesAsked()).toEqual(['first'])
    await userEvent.keyboard('j')
    await heading(0)
  })

  test('a refused verdict brings its cue and the count back', async () => {
    server.on('GET /v1/review-queue/count', () => ({ cues: 32, is_all: true }))
    server.on('POST /v1/takes/take-3/verdict', () => refusal(409, 'take-changed', 'The take changed meanwhile.'))
    await opened(3)
    await waitFor(() => expect(panel()).toHaveTextContent('32 waiting'))
    await userEvent.keyboard('a')
    expect(await screen.findByRole('alert')).toHaveTextContent('The take changed meanwhile.')
    expect(within(panel()).getByRole('link', { name: /hit_3 / })).toBeInTheDocument()
    expect(panel()).toHaveTextContent('32 waiting')
  })

  test('pages on which all is noted are passed over', async () => {
    queue = [...noted.slice(0, 24), ...items.slice(24)]
    openApp(`/projects/${PROJECT}/review`)
    await heading(24)
    expect(pagesAsked().slice(0, 3)).toEqual(['first', '12', '24'])
  })
})

test('a page that shows nothing of a long queue asks for the count alone', async () => {
  openApp('/account')
  expect(await screen.findByText('99+')).toBeVisible()
  expect(pagesAsked()).toEqual([])
})
