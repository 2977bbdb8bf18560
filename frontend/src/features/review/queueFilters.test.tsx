import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aMe, anItem, aPreview, aReview, aServer, aTake, PROJECT, somePeaks } from '@/test/review'
import type { Asked } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart'), import('./QueueFilters')]))

const shield = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a')])
const theme = anItem({ id: 'theme', name: 'menu_theme', category: 'music' }, [aTake('b')])
const click = anItem({ id: 'click', name: 'menu_click', category: 'ui' }, [aTake('c')])

let server: ReturnType<typeof aServer>

const left = ({ query }: Asked) =>
  [shield, theme, click].filter(
    ({ cue }) => (query.get('category') ?? cue.category) === cue.category && cue.name.includes(query.get('q') ?? ''),
  )

beforeEach(() => {
  vi.stubGlobal('AudioContext', HandContext)
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', (asked: Asked) => ({ items: left(asked), next: null }))
    .on('GET /v1/review-queue/count', (asked: Asked) => ({ cues: left(asked).length, is_all: true }))
    .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
    .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
    .on(`GET /v1/projects/${PROJECT}/judged-lately`, [])
    .on(`GET /v1/projects/${PROJECT}/categories`, [
      { category: 'music', cues: 1 },
      { category: 'ui', cues: 1 },
    ])
    .on(`GET /v1/projects/${PROJECT}`, { engagements: [{ designer: { id: 'ada', name: 'Ada' } }] })
    .on(`GET /v1/projects/${PROJECT}/saved-views`, [
      { id: 'v1', page: 'review_queue', name: 'Music only', query: 'category=music' },
      { id: 'v2', page: 'sound_list', name: 'Of the list', query: 'need=must' },
    ])
  for (const item of [shield, theme, click]) {
    const take = item.takes[0]?.id ?? ''
    server
      .on(`GET /v1/cues/${item.cue.id}/review`, aReview(item))
      .on(`GET /v1/sounds/${take}/preview`, aPreview)
      .on(`GET /v1/sounds/${take}/peaks.json`, somePeaks)
  }
})

const open = async (path: string) => {
  const app = openApp(`/projects/${PROJECT}/review${path}`)
  await screen.findByRole('region', { name: 'Verdict' })
  return app
}
const panel = () => screen.getByRole('complementary', { name: 'Queue' })
const cues = () =>
  within(panel())
    .getAllByRole('link')
    .map((link) => link.querySelector('.strong')?.textContent)

test(
  'a key opens the filter, what is chosen stands in the address, and the next cue keeps it',
  { tags: ['slow'] },
  async () => {
    const app = await open('/shield')
    await userEvent.keyboard('f')
    const form = await screen.findByRole('form', { name: 'Filter the queue' })
    expect(within(form).getByLabelText('Words in name, description or use')).toHaveFocus()
    await userEvent.type(within(form).getByLabelText('Words in name, description or use'), 'menu{Enter}')
    await waitFor(() => expect(cues()).toEqual(['menu_theme', 'menu_click']))
    expect(app.search()).toEqual({ q: 'menu' })
    await userEvent.selectOptions(await within(form).findByLabelText('Designer'), 'ada')
    await waitFor(() => expect(app.search()).toEqual({ q: 'menu', designer: 'ada' }))
    expect(server.of('GET /v1/review-queue').at(-1)?.query.get('designer_id')).toBe('ada')
    const { violations } = await axe.run(form, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations).toEqual([])
    await userEvent.click(within(panel()).getByRole('link', { name: /menu_theme/ }))
    await waitFor(() => expect(app.at()).toBe(`/projects/${PROJECT}/review/theme`))
    expect(app.search()).toEqual({ q: 'menu', designer: 'ada' })
  },
)

test('an address with a filter opens the first cue that it leaves', async () => {
  const app = await open('?category=ui')
  expect(app.at()).toBe(`/projects/${PROJECT}/review/click`)
  expect(app.search()).toEqual({ category: 'ui' })
  expect(cues()).toEqual(['menu_click'])
})

test('where nothing matches it is said, with a way to all', async () => {
  const app = openApp(`/projects/${PROJECT}/review?q=nothing`)
  expect(await screen.findByRole('heading', { name: 'No cues match this filter' })).toBeVisible()
  await userEvent.click(screen.getByRole('link', { name: 'Show all' }))
  await waitFor(() => expect(app.at()).toBe(`/projects/${PROJECT}/review/shield`))
  expect(app.search()).toEqual({})
})

test('a view of the team is opened', async () => {
  const app = await open('/shield')
  await userEvent.keyboard('f')
  await userEvent.click(await screen.findByRole('button', { name: 'Views' }))
  await userEvent.click(await screen.findByRole('menuitem', { name: 'Music only' }))
  await waitFor(() => expect(app.search()).toEqual({ category: 'music' }))
  expect(screen.queryByRole('menuitem', { name: 'Of the list' })).toBeNull()
})
