import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { aMe, APPROVER, aServer, PROJECT } from '@/test/review'

beforeAll(() => import('./ReasonsPage'))

const DESIGNER = { id: 'designer', name: 'Sound designer' }
const found = (id: string, more: object = {}) => ({
  verdict_id: id,
  take_id: `take-${id}`,
  cue_id: 'shield',
  cue_label: 'SW-007',
  cue_name: 'shield_hit',
  variation: 1,
  number: 2,
  label: null,
  designer: DESIGNER,
  given_by: APPROVER,
  on_behalf_of: null,
  given_at: '2026-11-20T10:00:00Z',
  reasons: ['Too loud'],
  text: 'Too loud. 3 dB less.',
  start_s: 0.25,
  ...more,
})
const COUNTS = {
  change: [
    { reason: 'Too loud', versions: 3 },
    { reason: 'Off style', versions: 1 },
  ],
  pick: [{ reason: 'Cleanest', versions: 2 }],
  designers: [DESIGNER],
  categories: ['', 'weapon'],
}

let server: ReturnType<typeof aServer>

beforeEach(() => {
  server = aServer()
    .on('GET /v1/me', aMe())
    .on(`GET /v1/projects/${PROJECT}/reasons`, COUNTS)
    .on(`GET /v1/projects/${PROJECT}/reasons/versions`, ({ query }: { query: URLSearchParams }) =>
      query.get('cursor') === 'more'
        ? { items: [found('3')], next: null }
        : { items: [found('1'), found('2', { text: '', label: 'wild', start_s: null })], next: 'more' },
    )
})

const opened = async (search = '') => {
  openApp(`/projects/${PROJECT}/reasons${search}`)
  await screen.findByRole('heading', { name: 'Reasons', level: 1 })
}
const reason = (name: RegExp) => screen.findByRole('link', { name })
const asked = (path: string) => server.of(`GET /v1/projects/${PROJECT}/${path}`).map(({ query }) => query.toString())

test('j, k and Enter open a reason, whose versions lead to their places', async () => {
  await opened()
  const loud = await reason(/Too loud/)
  expect(loud).toHaveTextContent('3 versions')
  await userEvent.keyboard('jj')
  expect(await reason(/Off style/)).toHaveFocus()
  await userEvent.keyboard('k{Enter}')
  const list = await screen.findByRole('region', { name: 'Too loud' })
  const [first, second] = await within(list).findAllByRole('link')
  expect(first).toHaveTextContent('Too loud. 3 dB less.')
  expect(first).toHaveAttribute('href', '/takes/take-1?at=0.25')
  expect(second).toHaveTextContent('version 2, wild')
  expect(second).toHaveAttribute('href', '/takes/take-2')
  await userEvent.click(within(list).getByRole('button', { name: 'More versions' }))
  await waitFor(() => expect(within(list).getAllByRole('link')).toHaveLength(3))
  const { violations } = await axe.run(document.body, {
    rules: { 'color-contrast': { enabled: false }, region: { enabled: false } },
  })
  expect(violations).toEqual([])
})

test('filters stand in the address and in what is asked', async () => {
  await opened('?kind=pick&reason=Cleanest&category=weapon')
  await screen.findByRole('region', { name: 'Cleanest' })
  expect(asked('reasons')).toEqual(['category=weapon'])
  expect(asked('reasons/versions')).toEqual(['kind=pick&reason=Cleanest&category=weapon'])
  await userEvent.selectOptions(await screen.findByLabelText('Sound designer'), 'Sound designer')
  await waitFor(() => expect(asked('reasons')).toContain('designer_id=designer&category=weapon'))
  await userEvent.selectOptions(screen.getByLabelText('Category'), 'All')
  await waitFor(() => expect(asked('reasons')).toContain('designer_id=designer'))
  await userEvent.selectOptions(screen.getByLabelText('Category'), 'None')
  await waitFor(() => expect(asked('reasons')).toContain('designer_id=designer&category='))
})

test('nothing was given yet, or nothing under the filter', async () => {
  server.on(`GET /v1/projects/${PROJECT}/reasons`, { ...COUNTS, change: [], pick: [] })
  await opened('?category=weapon')
  await userEvent.click(await screen.findByRole('button', { name: 'Show all' }))
  expect(await screen.findByText('No reasons yet')).toBeVisible()
})
