import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Asked, refusal } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const AT = '2026-11-20T10:00:00Z'

function served() {
  const server = new ListServer([aCue(1, 'shield_hit')])
  server.revision = 3
  const author = { id: 'someone', name: 'Producer' }
  server.answers[`GET ${server.at}/sound-list/revisions`] = {
    items: [3, 2, 1].map((number) => ({ number, summary: `change ${number}`, author, created_at: AT })),
    next: null,
  }
  const line = (number: number, name: string, more = {}) => ({
    id: `c${number}`,
    number,
    label: `SW-00${number}`,
    name,
    changes: [],
    cut_reason: null,
    ...more,
  })
  server.answers[`GET ${server.at}/sound-list/revisions/compare`] = ({ query }: Asked) => ({
    from_revision: Number(query.get('from')),
    to_revision: Number(query.get('to')),
    added: [line(5, 'hatch', { changes: [{ field: 'category', before: null, after: 'foley' }] })],
    changed: [line(1, 'shield_hit', { changes: [{ field: 'duration_s', before: 0.8, after: null }] })],
    cut: query.get('from') === '0' ? [] : [line(3, 'mine_arm', { cut_reason: 'Mines left the game' })],
  })
  return server
}

test('the newest revision is compared with the one before: added, before and after, cut with its reason', async () => {
  const server = served()
  openApp(`${server.path}/compare`)
  expect(await screen.findByText('From revision 2 to 3: 1 added, 1 changed, 1 cut.')).toBeInTheDocument()
  expect(within(screen.getByRole('region', { name: 'Added' })).getByText('foley')).toBeInTheDocument()
  expect(screen.getByRole('region', { name: 'Changed' })).toHaveTextContent(/Length was 0.80 s.*none/)
  expect(screen.getByRole('region', { name: 'Cut' })).toHaveTextContent('mine_arm')
  expect(screen.getByText('Cut: “Mines left the game”')).toBeInTheDocument()
})

test('any two can be chosen, and the address says which', async () => {
  const server = served()
  const app = openApp(`${server.path}/compare`)
  await userEvent.selectOptions(await screen.findByRole('combobox', { name: 'From' }), 'Empty list')
  expect(await screen.findByText('In the list of revision 3: 1 added, 1 changed.')).toBeInTheDocument()
  expect(app.search()).toEqual({ from: 0, to: 3 })
  await userEvent.click(screen.getByRole('link', { name: /change 2/ }))
  expect(await screen.findByText('From revision 1 to 2: 1 added, 1 changed, 1 cut.')).toBeInTheDocument()
})

test('a refusal is said where it happened', async () => {
  const server = served()
  server.answers[`GET ${server.at}/sound-list/revisions/compare`] = refusal(404, 'revision-not-found', 'no revision 3')
  openApp(`${server.path}/compare`)
  expect(await screen.findByRole('alert')).toHaveTextContent('No revision 3.')
})
