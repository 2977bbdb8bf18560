import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { wrote } from '@/test/server'
import { ListServer } from '@/test/soundList'

import type { ComparedBid } from './api'
import { type Sample, matchingSampleOfNextBid, verdictOf } from './samples'

const aSample = (id: string, line: string, more: Partial<Sample> = {}): Sample => ({
  id,
  line_key: line,
  file_name: `${id}.wav`,
  file_bytes: 1000,
  state: 'conforming',
  spec_version: 2,
  findings: [],
  problem: '',
  is_open: true,
  ...more,
})

const RETURNED = aSample('click', 'ui', {
  state: 'returned',
  findings: [
    {
      code: 'true-peak:over',
      severity: 'error',
      message: 'true peak 0.0 dBTP, limit -1.0 dBTP',
      fix: 'lower the level by 1.0 dB or more',
    },
  ],
})

const LINES = [
  { key: 'footsteps', label: 'Footsteps', cues: 3, files: 10, concepts: 0 },
  { key: 'ui', label: 'UI', cues: 1, files: 1, concepts: 0 },
]

const POSTING = {
  id: 'p1',
  project_id: 'shield-wing',
  project_name: 'Shield Wing',
  studio_name: 'Test studio',
  title: 'Effects for Alpha',
  state: 'open',
  takes_bids: true,
  bids_until_on: null,
  work_from_on: null,
  work_to_on: null,
  phase: 'production',
  revision: 2,
  currency: 'USD',
  nda_open: false,
  is_team: false,
  text: '',
  price_minor: null,
  budget_minor: null,
  is_budget_shown: false,
  rate_floor_minor: null,
  equipment: '',
  scope: 'all',
  categories: [],
  cue_ids: [],
  lines: LINES,
  headings: [],
  has_link: false,
  candidates: [],
  questions: [],
  bids: null,
  clashes: [],
  opened_at: null,
  closed_at: null,
  awarded_at: null,
  contract_id: null,
}

const CONTENT = {
  lines: [],
  hours_hundredths: null,
  from_on: null,
  to_on: null,
  exclusivity: 'unknown' as const,
  other_work: '',
  equipment: '',
  note: '',
}

const own = (samples: Sample[]) => ({
  id: 'b1',
  state: 'draft',
  revision: 1,
  content: CONTENT,
  total_minor: 0,
  concept_minor: 0,
  missing: [],
  sent_at: null,
  resent_at: null,
  differs: false,
  is_awarded: false,
  samples,
})

const played: string[] = []

beforeEach(() => {
  played.length = 0
  vi.spyOn(window.HTMLMediaElement.prototype, 'play').mockImplementation(function (this: HTMLMediaElement) {
    played.push(new URL(this.src).pathname)
    return Promise.resolve()
  })
  vi.spyOn(window.HTMLMediaElement.prototype, 'pause').mockImplementation(() => undefined)
})

test('a designer adds a sound for a line, sees what the check found, and removes it', { tags: ['slow'] }, async () => {
  const server = new ListServer([], {}, 'designer')
  server.answers['GET /v1/postings/p1/cues'] = []
  server.answers['GET /v1/postings/p1'] = { ...POSTING, own_bid: own([]) }
  server.answers['POST /v1/postings/p1/bid/samples'] = { ...POSTING, own_bid: own([RETURNED]) }
  server.answers['DELETE /v1/bid-samples/click'] = { ...POSTING, own_bid: own([]) }
  openApp('/postings/p1')
  await userEvent.selectOptions(await screen.findByLabelText('For'), 'UI')
  await userEvent.upload(
    screen.getByLabelText('A sound for the bid'),
    new File(['RIFF'], 'click.wav', { type: 'audio/wav' }),
  )
  expect(await screen.findByText(/does not conform: true peak 0.0 dBTP/)).toBeVisible()
  expect(screen.getByText('lower the level by 1.0 dB or more')).toBeVisible()
  expect(wrote(server.asked, 'POST /v1/postings/p1/bid/samples')[0]?.body).toEqual({
    line_key: 'ui',
    file_name: 'click.wav',
    content_base64: 'UklGRg==',
  })
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
  await userEvent.click(screen.getByRole('button', { name: 'Remove click.wav' }))
  await waitFor(() => expect(screen.queryByText('click.wav')).not.toBeInTheDocument())
})

test('a file that is too large is not sent, and the reason is shown', async () => {
  const server = new ListServer([], {}, 'designer')
  server.answers['GET /v1/postings/p1/cues'] = []
  server.answers['GET /v1/postings/p1'] = { ...POSTING, own_bid: own([]) }
  openApp('/postings/p1')
  await screen.findByRole('button', { name: 'Add a sound' })
  const large = new File([new Uint8Array(6_000_001)], 'long.wav', { type: 'audio/wav' })
  await userEvent.upload(screen.getByLabelText('A sound for the bid'), large)
  expect(await screen.findByRole('alert')).toHaveTextContent('long.wav is larger than')
  expect(wrote(server.asked, 'POST /v1/postings/p1/bid/samples')).toEqual([])
})

const bid = (id: string, name: string, samples: Sample[]): ComparedBid => ({
  id,
  designer: { id: `d-${id}`, name },
  is_shortlisted: false,
  sent_at: '2026-11-25T10:00:00Z',
  resent_at: null,
  content: CONTENT,
  amounts_minor: [],
  total_minor: 0,
  concept_minor: 0,
  missing: [],
  hourly_rate_minor: null,
  is_below_floor: false,
  over_budget_minor: null,
  days_late: null,
  roster_entry_id: null,
  busy: [],
  samples,
  own_scores: null,
  notes: [],
  others: null,
  scored_by: 0,
})

const BIDS = [
  bid('b1', 'Sound designer A', [aSample('a-steps', 'footsteps'), aSample('a-click', 'ui')]),
  bid('b2', 'Sound designer B', [
    aSample('b-click', 'ui', { state: 'unchecked', problem: 'the check could not judge this file' }),
  ]),
]

test('b plays the same sample of the next bid, and a sample that was not checked says why', async () => {
  const server = new ListServer([], {}, 'team')
  server.answers['GET /v1/postings/p1/bids'] = {
    posting_id: 'p1',
    title: 'Effects for Alpha',
    state: 'closed',
    currency: 'USD',
    budget_minor: null,
    rate_floor_minor: null,
    work_from_on: null,
    work_to_on: null,
    headings: [],
    lines: LINES,
    bids: BIDS,
    awarded_bid_id: null,
    contract_id: null,
    may_award: false,
    pending: [],
  } satisfies Record<string, unknown>
  openApp(`${server.path.replace('/sound-list', '')}/postings/p1/bids`)
  const clicks = await screen.findByRole('row', { name: /^Samples, UI/ })
  expect(clicks).toHaveTextContent('not checked: the check could not judge this file')
  expect(within(screen.getByRole('row', { name: /^Samples, Footsteps/ })).getByText('none')).toBeVisible()
  await userEvent.click(within(clicks).getByRole('button', { name: 'Play a-click.wav' }))
  await userEvent.keyboard('b')
  await waitFor(() => expect(played).toEqual(['/v1/bid-samples/a-click/file', '/v1/bid-samples/b-click/file']))
  expect(within(clicks).getByRole('button', { name: 'Pause b-click.wav' })).toBeVisible()
})

test('the next sample is for the same line; where no other bid has one, there is none', () => {
  expect(matchingSampleOfNextBid(BIDS, 'a-click')?.id).toBe('b-click')
  expect(matchingSampleOfNextBid(BIDS, 'b-click')?.id).toBe('a-click')
  expect(matchingSampleOfNextBid(BIDS, 'a-steps')).toBeNull()
  expect(matchingSampleOfNextBid(BIDS, null)?.id).toBe('a-steps')
  expect(matchingSampleOfNextBid([bid('b3', 'C', [aSample('gone', 'ui', { is_open: false })])], null)).toBeNull()
})

test('a verdict names the version of the spec; a sample that was not checked shows no result', () => {
  expect(verdictOf(aSample('x', 'ui')).words).toBe('conforms, by version 2 of the spec')
  expect(verdictOf(aSample('x', 'ui', { state: 'unchecked', problem: 'it failed' })).words).toBe(
    'not checked: it failed',
  )
  expect(verdictOf(aSample('x', 'ui', { state: 'pending' })).words).toBe('being checked')
})
