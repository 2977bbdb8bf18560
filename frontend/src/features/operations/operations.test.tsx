import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, type Asked, refusal, serve } from '@/test/server'

import type { JobState, Lane, Scrub } from './api'
import { inOneLine, jobWords, laneLine, laneWords, scrubLine } from './words'

const AT = '2026-11-21T12:00:00Z'
const NOW = new Date('2026-11-21T12:05:00Z')
const STUDIO = { id: 's1', name: 'Shield Wing studio', roles: ['producer'] }
const ME = {
  person: { id: 'x1', name: 'Producer' },
  email: 'producer@studio.example',
  is_operator: false,
  studios: [STUDIO],
  projects: [],
}
const KEPT = {
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  size_bytes: 2_016_132,
  kept: [
    { kind: 'masters', files: 1, size_bytes: 864_044 },
    { kind: 'game_files', files: 2, size_bytes: 1_152_088 },
  ],
}
const SCRUB: Scrub = {
  started_at: AT,
  finished_at: AT,
  files: 812,
  size_bytes: 2_016_132,
  missing: 1,
  altered: 2,
  orphaned: 3,
  orphaned_bytes: 1_000_000,
}
const STUCK = {
  id: 'e1:renders.prepare_take',
  job: 'renders.prepare_take',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  state: 'parked',
  tries: 6,
  since: AT,
  reason: 'BlobMissing',
}
const LANE: Lane = {
  studio_id: null,
  studio_name: null,
  urgency: 'bulk',
  waiting: 40,
  running: 2,
  delayed: 0,
  oldest_at: AT,
}
const counted = (state: JobState, jobs: number, job = 'renders.prepare_take') => ({ job, state, jobs, oldest_at: AT })

const as = (me: typeof ME, more: Answers): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: me.person },
  'GET /v1/me': me,
  'GET /v1/studios/s1/quotas': [],
  'GET /v1/operations/quotas': { items: [], next: null },
  ...more,
})

test('a producer sees what gave up and tries it again', async () => {
  let stuck = true
  const { asked } = serve(
    as(ME, {
      'GET /v1/studios/s1/operations': () => ({
        counts: stuck ? [counted('parked', 1)] : [],
        lanes: [],
        workers: 1,
      }),
      'GET /v1/studios/s1/storage': KEPT,
      'GET /v1/studios/s1/jobs': () => ({ items: stuck ? [STUCK] : [], next: null }),
      [`POST /v1/studios/s1/jobs/${encodeURIComponent(STUCK.id)}/retry`]: () => {
        stuck = false
        return { ...STUCK, state: 'waiting' }
      },
    }),
  )
  openApp('/operations')
  expect(await screen.findByText(/1 job failed. No jobs are waiting. 1 worker running./)).toBeVisible()
  const row = within(screen.getByRole('list', { name: 'Jobs' })).getByRole('listitem')
  expect(row).toHaveTextContent('Check a version, draw its waveform and render game files')
  expect(row).toHaveTextContent('6 tries')
  expect(row).toHaveTextContent('BlobMissing')
  await userEvent.click(
    within(row).getByRole('button', { name: 'Try again: Check a version, draw its waveform and render game files' }),
  )
  expect(
    await screen.findByText('Check a version, draw its waveform and render game files is queued again.'),
  ).toBeVisible()
  expect(await screen.findByText('No jobs')).toBeVisible()
  expect(asked.filter(({ method }) => method === 'POST')).toHaveLength(1)
  expect(screen.getByText(/1 master 864.0 kB, 2 game files 1.2 MB/)).toBeVisible()
})

test('a refused try is said in the card, and the job stays', async () => {
  serve(
    as(ME, {
      'GET /v1/studios/s1/operations': { counts: [counted('parked', 1)], lanes: [], workers: 1 },
      'GET /v1/studios/s1/storage': KEPT,
      'GET /v1/studios/s1/jobs': { items: [STUCK], next: null },
      [`POST /v1/studios/s1/jobs/${encodeURIComponent(STUCK.id)}/retry`]: refusal(
        409,
        'job-not-parked',
        'this job is running; only one that gave up can be tried again',
      ),
    }),
  )
  openApp('/operations')
  await userEvent.click(
    await screen.findByRole('button', { name: 'Try again: Check a version, draw its waveform and render game files' }),
  )
  expect(await screen.findByRole('alert')).toHaveTextContent('only one that gave up can be tried again.')
})

test('an operator sees the whole server, and each studio that they produce for', async () => {
  const { asked } = serve(
    as(
      { ...ME, is_operator: true },
      {
        'GET /v1/operations': {
          counts: [counted('waiting', 3)],
          lanes: [{ ...LANE, studio_id: 's2', studio_name: 'Deep Field studio' }, LANE],
          workers: [
            { id: 'host-12-ab', beat_at: AT, is_alive: true, running: 2 },
            { id: 'host-13-cd', beat_at: AT, is_alive: false, running: 0 },
          ],
        },
        'GET /v1/operations/storage': {
          studios: [KEPT, { ...KEPT, studio_id: 's2', studio_name: 'Deep Field studio' }],
          free_bytes: 42_000_000_000,
          scrub: SCRUB,
        },
        'GET /v1/operations/jobs': { items: [{ ...STUCK, studio_id: null, studio_name: null }], next: null },
        'GET /v1/studios/s1/operations': { counts: [], lanes: [], workers: 1 },
        'GET /v1/studios/s1/storage': KEPT,
        'GET /v1/studios/s1/jobs': { items: [], next: null },
      },
    ),
  )
  openApp('/operations')
  const lanes = within(await screen.findByRole('list', { name: /Queues/ })).getAllByRole('listitem')
  expect(lanes[0]).toHaveTextContent('Deep Field studio, bulk')
  expect(lanes[1]).toHaveTextContent('the server, bulk')
  const workers = within(screen.getByRole('list', { name: /Workers/ })).getAllByRole('listitem')
  expect(workers[0]).toHaveTextContent('host-12-ab2 jobs running')
  expect(workers[1]).toHaveTextContent('last seen')
  expect(screen.getByText(/1 worker running/)).toBeVisible()
  expect(await screen.findByText(/42.0 GB free on the disk/)).toBeVisible()
  expect(screen.getByText(/812 files verified .* ago: 1 file missing, 2 altered/)).toBeVisible()
  const jobs = await screen.findByRole('list', { name: 'Jobs' })
  expect(within(jobs).getByText('the server')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Shield Wing studio' }))
  await waitFor(() => expect(asked.some(({ path }) => path === '/v1/studios/s1/jobs')).toBe(true))
  expect(await screen.findByText('No jobs')).toBeVisible()
})

test('limits show who is near, to an operator and to a producer', async () => {
  const cues = { kind: 'cues', used: 19_000, limit: 20_000, default: 500_000 }
  const people = { kind: 'people', used: 3, limit: 2_000, default: 2_000 }
  const masters = { kind: 'master_bytes', used: 2_000_000_000, limit: 2_000_000_000, default: 2_000_000_000_000 }
  serve(
    as(
      { ...ME, is_operator: true },
      {
        'GET /v1/operations': { counts: [], lanes: [], workers: [] },
        'GET /v1/operations/storage': { studios: [KEPT], free_bytes: null, scrub: null },
        'GET /v1/operations/jobs': { items: [], next: null },
        'GET /v1/operations/quotas': ({ query }: Asked) =>
          query.get('cursor') === null
            ? { items: [{ studio_id: 's2', studio_name: 'Deep Field studio', quotas: [masters, people] }], next: '50' }
            : { items: [{ studio_id: 's1', studio_name: 'Shield Wing studio', quotas: [people] }], next: null },
        'GET /v1/studios/s1/operations': { counts: [], lanes: [], workers: 1 },
        'GET /v1/studios/s1/storage': KEPT,
        'GET /v1/studios/s1/jobs': { items: [], next: null },
        'GET /v1/studios/s1/quotas': [people, cues],
      },
    ),
  )
  openApp('/operations')
  const limits = within(await screen.findByRole('list', { name: /Limits/ }))
  await userEvent.click(await screen.findByRole('button', { name: 'Show more studios' }))
  await limits.findByText('Shield Wing studio')
  const [first, second] = limits.getAllByRole('listitem')
  expect(screen.queryByRole('button', { name: 'Show more studios' })).toBeNull()
  expect(first).toHaveTextContent('Deep Field studioStorage for masters2.0 GB of 2.0 GBLimit reachedMembers')
  expect(second).toHaveTextContent('Shield Wing studioMembers')
  expect(screen.getByText('1 studio near')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Shield Wing studio' }))
  expect(await screen.findByText('Almost full')).toBeVisible()
  const own = within(screen.getByRole('list', { name: /Limits/ })).getByRole('listitem')
  expect(own).toHaveTextContent(/^Cues/)
})

test('the states filter what is asked for', async () => {
  const { asked } = serve(
    as(ME, {
      'GET /v1/studios/s1/operations': {
        counts: [counted('parked', 1), counted('waiting', 2)],
        lanes: [],
        workers: 1,
      },
      'GET /v1/studios/s1/storage': KEPT,
      'GET /v1/studios/s1/jobs': { items: [], next: null },
    }),
  )
  openApp('/operations')
  await userEvent.click(await screen.findByRole('button', { name: /Failed/ }))
  expect(await screen.findByText('No failed jobs')).toBeVisible()
  expect(asked.some(({ path, query }) => path.endsWith('/jobs') && query.get('state') === 'parked')).toBe(true)
})

test('others see who runs the server', async () => {
  serve(as({ ...ME, studios: [{ ...STUDIO, roles: ['reviewer'] }] }, {}))
  openApp('/operations')
  expect(await screen.findByText('Only producers can see jobs and storage')).toBeVisible()
})

test('one line says whether all is well', () => {
  expect(inOneLine([], 2, NOW)).toBe('None failed. No jobs are waiting. 2 workers running.')
  const waiting = counted('waiting', 3)
  expect(inOneLine([waiting, counted('delayed', 9)], 1, NOW)).toBe(
    'None failed. 3 jobs waiting, the oldest for 5 min. 1 worker running.',
  )
  expect(inOneLine([counted('parked', 1), counted('broken', 1), waiting], 0, new Date(AT))).toBe(
    '2 jobs failed. 3 jobs waiting. No worker is running. Deliveries are checked once one starts.',
  )
})

test('a lane says how much of what it has, and nothing of what it has not', () => {
  expect(laneLine(LANE, NOW)).toBe('2 running, 40 waiting, the oldest for 5 min')
  expect(laneLine({ ...LANE, waiting: 1, running: 1, delayed: 3, oldest_at: AT }, new Date(AT))).toBe(
    '1 running, 1 waiting, 3 scheduled',
  )
  expect(laneLine({ ...LANE, waiting: 0, running: 0, delayed: 3, oldest_at: null }, NOW)).toBe('3 scheduled')
  expect(laneWords(LANE, 'server')).toBe('the server, bulk')
  expect(laneWords({ ...LANE, urgency: 'urgent' }, { studioId: 's1' })).toBe('Interactive')
})

test('a job is called by what it does, and one without words by its own name', () => {
  expect(jobWords('renders.prepare_take')).toBe('Check a version, draw its waveform and render game files')
  expect(jobWords('orchards.pick_ripe_apples')).toBe('Pick ripe apples')
})

test('a pass over stored files is told in one line', () => {
  expect(scrubLine(null)).toBe('No stored file has been verified yet.')
  expect(scrubLine({ ...SCRUB, missing: 0, altered: 0 }, NOW)).toBe(
    '812 files verified 5 min ago: none missing or altered, 3 unused files of 1.0 MB.',
  )
  expect(scrubLine({ ...SCRUB, missing: 0, altered: 0, orphaned: 0, finished_at: null }, NOW)).toBe(
    '812 files verified so far: none missing or altered.',
  )
})
