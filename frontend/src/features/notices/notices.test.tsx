import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test } from 'vitest'

import { unreadWords } from '@/app/notices'
import { openApp } from '@/test/openApp'
import { answer, type Answers, type Asked, refusal, serve, wrote } from '@/test/server'

import type { Notice } from './api'

const ME = {
  person: { id: 'me', name: 'Producer', email: 'p@studio.example' },
  studios: [],
  projects: [],
  is_operator: false,
}
const aNotice = (id: string, more: Partial<Notice> = {}): Notice => ({
  id,
  news: 'talk',
  subject: `Shield Wing: notice ${id}`,
  text: 'SW-003 hit: A drop, or a tool?',
  path: '/account',
  created_at: '2026-11-26T10:00:00Z',
  read_at: null,
  ...more,
})

let asked: Asked[]
let answers: Answers

beforeEach(() => {
  ;({ asked, answers } = serve({
    'GET /v1/session': { signed_in: true, demo: false },
    'GET /v1/me': ME,
    'GET /v1/me/notices/unread': { unread: 2 },
    'GET /v1/me/notices': {
      items: [aNotice('c'), aNotice('b'), aNotice('a', { read_at: '2026-11-26T11:00:00Z' })],
      next: null,
    },
    'POST /v1/me/notices/read': answer(null, 204),
  }))
})

test('the bell counts what is unread and leads to the list', async () => {
  openApp('/notices')
  expect(await screen.findByRole('link', { name: 'Notices, 2 unread' })).toHaveAttribute('href', '/notices')
  const list = await screen.findByRole('region', { name: 'Notices' })
  expect(within(list).getAllByRole('listitem')).toHaveLength(3)
  expect(within(list).getAllByText('Unread:')).toHaveLength(2)
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
})

test('the count ends at 99', () => {
  expect([undefined, 0, 1, 99, 100].map(unreadWords)).toEqual([undefined, undefined, '1', '99', '99+'])
})

test('one notice is marked by its button, or by opening its page', async () => {
  const user = userEvent.setup()
  openApp('/notices')
  await user.click(await screen.findByRole('button', { name: 'Mark as read: Shield Wing: notice b' }))
  await user.click(screen.getByRole('link', { name: /notice c/ }))
  const marks = () => wrote(asked, 'POST /v1/me/notices/read').map(({ body }) => body)
  await waitFor(() => expect(marks()).toEqual([{ ids: ['b'] }, { ids: ['c'] }]))
})

test('all are marked up to the newest on the screen, by key or button', async () => {
  const user = userEvent.setup()
  openApp('/notices')
  await screen.findByRole('link', { name: /notice c/ })
  await user.keyboard('{Shift>}R{/Shift}')
  await waitFor(() => expect(wrote(asked, 'POST /v1/me/notices/read')[0]?.body).toEqual({ ids: [], up_to: 'c' }))
})

test('earlier notices are fetched by their cursor', async () => {
  const user = userEvent.setup()
  answers['GET /v1/me/notices'] = ({ query }: Asked) =>
    query.get('cursor') === 'c' ? { items: [aNotice('b')], next: null } : { items: [aNotice('c')], next: 'c' }
  openApp('/notices')
  await user.click(await screen.findByRole('button', { name: 'Show earlier notices' }))
  expect(await screen.findByRole('link', { name: /notice b/ })).toBeVisible()
})

test('a refusal and an empty list are said', async () => {
  answers['GET /v1/me/notices'] = { items: [], next: null }
  openApp('/notices')
  expect(await screen.findByText('No notices yet')).toBeVisible()
  answers['GET /v1/me/notices'] = refusal(503, 'busy', 'The server is busy.')
})
