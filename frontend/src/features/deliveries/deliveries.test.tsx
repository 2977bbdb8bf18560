import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject, people } from '@/test/project'
import { type Answers, type Asked, refusal, serve } from '@/test/server'

import type { Archive, Delivery, DeliveryDetail, Take } from './api'

const aDelivery = (more: Partial<Delivery> = {}): Delivery => ({
  id: 'd4',
  project_id: 'p1',
  number: 4,
  note: 'the shields, second try',
  created_at: '2026-11-10T09:00:00Z',
  closed_at: '2026-11-12T18:00:00Z',
  designer: people.designer,
  takes_count: 3,
  ...more,
})
const aTake = (id: string, more: Partial<Take> = {}): Take => ({
  id,
  project_id: 'p1',
  delivery_id: 'd4',
  designer: people.designer,
  cue: { id: 'c1', label: 'SW-001', name: 'shield_hit' },
  variation: 1,
  number: 2,
  alternate: null,
  label: null,
  verdict_reasons: [],
  state: 'approved',
  late: false,
  file_name: `${id}.wav`,
  note: '',
  fix_of_id: null,
  master_sha256: 'ab',
  master_bytes: 1_200_000,
  received_at: '2026-11-10T09:05:00Z',
  state_since: '2026-11-11T09:00:00Z',
  already_here: false,
  discarded_at: null,
  sure: null,
  guesses: [],
  ...more,
})
const ARCHIVE: Archive = {
  id: 'z1',
  delivery_id: 'd4',
  file_name: 'round two.zip',
  archive_bytes: 9_000_000,
  state: 'unpacked',
  message: '',
  entries: [
    { path: 'shield_hit.wav', taken: true, take_id: 'shield_hit', reason: null },
    { path: 'notes.txt', taken: false, take_id: null, reason: 'Not a sound.' },
  ],
  received_at: '2026-11-10T09:04:00Z',
}
const DETAIL: DeliveryDetail = {
  ...aDelivery(),
  takes: [
    aTake('shield_hit'),
    aTake('shield_down', { state: 'conforming', variation: 3, alternate: 2, late: true, note: 'wider' }),
    aTake('what_is_this', { cue: null, number: null, state: 'conforming' }),
    aTake('wrong', { discarded_at: '2026-11-11T09:00:00Z' }),
  ],
  dry_stems: [],
  archives: [ARCHIVE],
}

const DELIVERIES: Answers = {
  'GET /v1/projects/p1/deliveries': { items: [aDelivery()], next: null },
  'GET /v1/deliveries/d4': DETAIL,
}
const open = (path: string, more: Answers = {}, part: 'producer' | 'designer' = 'producer') => {
  serve(inProject(part, { ...DELIVERIES, ...more }))
  return openApp(path)
}

test('a closed delivery says what happened to each file', async () => {
  open('/deliveries/d4')
  expect(await screen.findByRole('heading', { name: 'Delivery 4' })).toBeVisible()
  expect(screen.getByText('“the shields, second try”')).toBeVisible()
  const counts = within(screen.getByRole('list', { name: 'How its files stand' })).getAllByRole('listitem')
  expect(counts.map((one) => one.textContent)).toEqual(['Unmatched 1', 'To review 1', 'Approved 1'])
  const files = within(screen.getByRole('list', { name: 'Files' })).getAllByRole('listitem')
  expect(files[1]).toHaveTextContent('version 2 B, variation 3, 1.2 MB, after it was closed')
  expect(files[1]).toHaveTextContent('“wider”')
  expect(files[2]).toHaveTextContent('Unmatched')
  expect(files[3]).toHaveTextContent('Discarded; the file is kept')
  expect(within(files[0] as HTMLElement).getByRole('link')).toHaveAttribute('href', '/takes/shield_hit')
  const left = screen.getByRole('list', { name: 'Entries of round two.zip that were left out' })
  expect(left).toHaveTextContent('notes.txtNot a sound.')
  const review = await within(screen.getByRole('main')).findByRole('link', { name: 'Review' })
  expect(review).toHaveAttribute('href', '/projects/p1/review')
})

test('a designer is led back to the desk and not to Review', async () => {
  open('/deliveries/d4', {}, 'designer')
  expect(await screen.findByRole('link', { name: 'Desk' })).toHaveAttribute('href', '/projects/p1/desk')
  expect(within(screen.getByRole('main')).queryByRole('link', { name: 'Review' })).toBeNull()
})

test('one that is not there, or not for these eyes, says so', async () => {
  open('/deliveries/d4', { 'GET /v1/deliveries/d4': refusal(404, 'delivery-not-found', 'no delivery d4') })
  expect(await screen.findByRole('heading', { name: 'Delivery not found' })).toBeVisible()
  expect(screen.getByRole('alert')).toHaveTextContent('No delivery d4.')
})

test('all deliveries are listed, earlier ones on demand, and each leads to its page', async () => {
  const earlier = aDelivery({ id: 'd1', number: 1, closed_at: null, takes_count: 1 })
  const app = open('/projects/p1/deliveries', {
    'GET /v1/projects/p1/deliveries': ({ query }: Asked) =>
      query.get('cursor') === 'more' ? { items: [earlier], next: null } : { items: [aDelivery()], next: 'more' },
  })
  const list = await screen.findByRole('list', { name: 'Deliveries' })
  expect(list).toHaveTextContent('Delivery 4the shields, second try')
  await userEvent.click(screen.getByRole('button', { name: 'Earlier deliveries' }))
  await waitFor(() => expect(within(list).getAllByRole('listitem')[1]).toHaveTextContent('1 file'))
  expect(within(list).getAllByRole('listitem')[1]).toHaveTextContent(/open$/)
  await userEvent.click(within(list).getByRole('link', { name: 'Delivery 4' }))
  await waitFor(() => expect(app.at()).toBe('/deliveries/d4'))
})

test('axe finds nothing', async () => {
  open('/deliveries/d4')
  await screen.findByRole('heading', { name: 'Delivery 4' })
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
})
