import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { asPerson, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { serve } from '@/test/server'

const EVENTS = [
  {
    id: 'e2',
    at: '2026-11-20T09:30:00Z',
    kind: 'roles',
    summary: 'changed the roles to Reviewer',
    person: PRODUCER.person,
    about: { id: 'x2', name: 'Audio director', picture: null },
    network: '203.0.113.7',
  },
  {
    id: 'e1',
    at: '2026-11-19T09:30:00Z',
    kind: 'export',
    summary: 'exported the whole studio into a file',
    person: null,
    about: null,
    network: '',
  },
]

test('the security log names person, act, day and network, page by page and by kind', async () => {
  const server = serve(
    asPerson(PRODUCER, {
      'GET /v1/studios/s1/security-events': ({ query }: { query: URLSearchParams }) =>
        query.has('cursor') ? { items: [], next: null } : { items: EVENTS, next: 'older page' },
    }),
  )
  const user = userEvent.setup()
  openApp('/studio/s1/security-log')
  const rows = await screen.findAllByRole('listitem')
  const [roles, exported] = rows.filter((row) => /roles to|whole studio/.test(row.textContent))
  if (roles === undefined || exported === undefined) throw new Error('two events are listed')
  expect(roles).toHaveTextContent('Producer · Audio director')
  expect(roles).toHaveTextContent('203.0.113.7')
  expect(within(exported).getByText('The server’s administrator')).toBeInTheDocument()

  await user.click(screen.getByRole('button', { name: 'Show earlier events' }))
  await waitFor(() => expect(server.asked.some(({ query }) => query.get('cursor') === 'older page')).toBe(true))
  await user.selectOptions(screen.getByLabelText('Show'), 'Exports')
  await waitFor(() => expect(server.asked.some(({ query }) => query.get('kind') === 'export')).toBe(true))
  expect(screen.getByRole('link', { name: 'CSV' })).toHaveAttribute(
    'href',
    '/v1/studios/s1/security-events.csv?kind=export',
  )
})
