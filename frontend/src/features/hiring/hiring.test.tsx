import { fireEvent, act, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { queryClient } from '@/api/queryClient'
import { openApp } from '@/test/openApp'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'
import { ListServer } from '@/test/soundList'

import { type ComparedBid, type Comparison, type Posting, postingQuery } from './api'
import { contentOf, hundredthsOf, totalOf, typedBid } from './bid'

const LINES = [
  { key: 'footsteps', label: 'Footsteps', cues: 3, files: 10, concepts: 0 },
  { key: 'ui', label: 'UI', cues: 1, files: 1, concepts: 0 },
]
const HEADINGS = ['Quality of work', 'Reliability']

const aPosting = (more: Partial<Posting> = {}): Posting => ({
  id: 'p1',
  project_id: 'shield-wing',
  project_name: 'Shield Wing',
  studio_name: 'Test studio',
  title: 'Effects for Alpha',
  state: 'open',
  takes_bids: true,
  bids_until_on: null,
  work_from_on: '2027-01-04',
  work_to_on: '2027-03-31',
  phase: 'production',
  revision: 2,
  currency: 'USD',
  nda_open: false,
  is_team: true,
  text: 'Three months.',
  price_minor: null,
  budget_minor: null,
  is_budget_shown: false,
  rate_floor_minor: null,
  equipment: '',
  scope: 'all',
  categories: [],
  cue_ids: [],
  lines: LINES,
  headings: HEADINGS,
  has_link: false,
  candidates: [],
  questions: [],
  bids: 0,
  own_bid: null,
  clashes: [],
  opened_at: '2026-11-25T10:00:00Z',
  closed_at: null,
  awarded_at: null,
  contract_id: null,
  ...more,
})

const aBid = (id: string, name: string, more: Partial<ComparedBid> = {}): ComparedBid => ({
  id,
  designer: { id: `d-${id}`, name },
  is_shortlisted: false,
  sent_at: '2026-11-25T10:00:00Z',
  resent_at: null,
  content: {
    lines: [
      { key: 'footsteps', kind: 'asked', unit: 'per_cue', quantity_hundredths: 300, price_minor: 27000, note: '' },
      { key: 'ui', kind: 'asked', unit: 'flat', quantity_hundredths: 100, price_minor: 15000, note: '' },
    ],
    hours_hundredths: 2400,
    from_on: null,
    to_on: null,
    exclusivity: 'unknown',
    other_work: '',
    equipment: '',
    note: '',
  },
  amounts_minor: [81000, 15000],
  total_minor: 96000,
  concept_minor: 0,
  missing: [],
  hourly_rate_minor: 4000,
  is_below_floor: false,
  over_budget_minor: 6000,
  days_late: null,
  roster_entry_id: null,
  busy: [],
  samples: [],
  own_scores: null,
  notes: [],
  others: null,
  scored_by: 1,
  ...more,
})

const compared = (bids: ComparedBid[]): Comparison => ({
  posting_id: 'p1',
  title: 'Effects for Alpha',
  state: 'closed',
  currency: 'USD',
  budget_minor: 90000,
  rate_floor_minor: 4500,
  work_from_on: '2027-01-04',
  work_to_on: '2027-03-31',
  headings: HEADINGS,
  lines: LINES,
  bids,
  awarded_bid_id: null,
  contract_id: null,
  may_award: true,
  is_roster_full: false,
  pending: [],
})

const second = aBid('b2', 'Sound designer B', {
  content: { ...aBid('', '').content, lines: aBid('', '').content.lines.slice(0, 1) },
  amounts_minor: [81000],
  total_minor: 81000,
  concept_minor: 0,
  missing: ['UI'],
  hourly_rate_minor: 3375,
  is_below_floor: true,
})

function bidsOpened() {
  const server = new ListServer([], {}, 'team')
  const path = server.path.replace('/sound-list', '')
  server.answers['GET /v1/postings/p1/bids'] = compared([aBid('b1', 'Sound designer A'), second])
  const app = openApp(`${path}/postings/p1/bids`)
  return { server, app, path }
}

test('bids stand on the same lines, and a total without a line names it', { tags: ['slow'] }, async () => {
  bidsOpened()
  expect(await screen.findByRole('heading', { name: '2 bids on Effects for Alpha' })).toBeVisible()
  const total = screen.getByRole('row', { name: /^Total/ })
  expect(total).toHaveTextContent('$960.00$60.00 over the budget')
  expect(total).toHaveTextContent('$810.00without UI: not comparable')
  expect(screen.getByRole('row', { name: /^UI, 1 cue/ })).toHaveTextContent('not offered')
  expect(screen.getByRole('row', { name: /^Hours/ })).toHaveTextContent('$33.75 an hour, your floor is $45.00')
  expect(screen.getByRole('row', { name: /^Reliability/ })).toHaveTextContent('Score it to see the team’s')
})

test('an award says before and after that a full roster takes nobody', async () => {
  const { server, app, path } = bidsOpened()
  server.answers['GET /v1/postings/p1/bids'] = { ...compared([second]), is_roster_full: true }
  server.answers['POST /v1/bids/b2/award'] = answer(
    { project_id: 'shield-wing', contract_id: 'c9', is_on_roster: false },
    201,
  )
  await userEvent.click(await screen.findByRole('button', { name: /^Award/ }))
  const dialog = await screen.findByRole('dialog')
  expect(dialog).toHaveTextContent('joins the project.Your roster is full: Sound designer B is not added to it.')
  await userEvent.click(within(dialog).getByRole('button', { name: 'Award' }))
  await waitFor(() => expect(app.at()).toBe(`${path}/contracts/c9/draft`))
  expect(await screen.findByText('Awarded. Your roster is full, so Sound designer B is not on it.')).toBeVisible()
})

test(
  'by keys: choose a bid, shortlist it, score it; an award asks first and names who is thanked',
  { tags: ['slow'] },
  async () => {
    const { server, app, path } = bidsOpened()
    await screen.findByRole('heading', { name: '2 bids on Effects for Alpha' })
    server.answers['PUT /v1/bids/b2/shortlist'] = compared([
      { ...second, is_shortlisted: true },
      aBid('b1', 'Sound designer A'),
    ])
    server.answers['PUT /v1/bids/b2/scores'] = ({ body }: Asked) =>
      compared([
        {
          ...second,
          own_scores: {
            person: { id: 'x1', name: 'Producer' },
            ...(body as { scores: Record<string, number>; note: string }),
          },
          others: [
            { person: { id: 'x2', name: 'Audio director' }, scores: { Reliability: 3 }, note: 'Slow to answer.' },
          ],
          scored_by: 2,
        },
        aBid('b1', 'Sound designer A'),
      ])
    server.answers['POST /v1/bids/b2/award'] = answer(
      { project_id: 'shield-wing', contract_id: 'c9', is_on_roster: true },
      201,
    )
    await userEvent.keyboard('2l')
    await waitFor(() =>
      expect(wrote(server.asked, 'PUT /v1/bids/b2/shortlist')[0]?.body).toEqual({ is_shortlisted: true }),
    )
    await userEvent.keyboard('s')
    const quality = screen.getByRole('combobox', { name: 'Quality of work' })
    expect(quality).toHaveFocus()
    await userEvent.selectOptions(quality, '4')
    await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Reliability' }), '5')
    await userEvent.click(screen.getByRole('button', { name: 'Save scores' }))
    expect(await screen.findByText('Slow to answer.')).toBeVisible()
    expect(screen.getByRole('row', { name: /^Reliability/ })).toHaveTextContent('4.0Producer 5, Audio director 3')
    ;(document.activeElement as HTMLElement).blur()
    await userEvent.keyboard('{Shift>}{Enter}{/Shift}')
    const dialog = await screen.findByRole('dialog')
    expect(dialog).toHaveTextContent('Sound designer A: thanked')
    expect(dialog).toHaveTextContent('A draft contract over $810.00 opens. Nothing is signed.')
    expect(dialog).toHaveTextContent('This bid is without UI.')
    expect(wrote(server.asked, 'POST /v1/bids/b2/award')).toHaveLength(0)
    await userEvent.click(within(dialog).getByRole('button', { name: 'Award' }))
    await waitFor(() => expect(app.at()).toBe(`${path}/contracts/c9/draft`))
  },
)

test('a producer writes a posting, saves it and opens it', { tags: ['slow'] }, async () => {
  const server = new ListServer([], {}, 'team')
  const path = server.path.replace('/sound-list', '')
  const at = server.at
  server.answers[`GET ${at}/postings`] = []
  server.answers[`POST ${at}/postings`] = answer(aPosting({ state: 'draft' }), 201)
  server.answers['GET /v1/postings/p1/cues'] = []
  server.answers['GET /v1/postings/p1'] = aPosting({ state: 'draft' })
  server.answers['PUT /v1/postings/p1'] = aPosting({ state: 'draft', revision: 3, budget_minor: 800000 })
  server.answers['POST /v1/postings/p1/open'] = aPosting()
  const app = openApp(`${path}/postings`)
  expect(await screen.findByRole('heading', { name: 'No posting yet' })).toBeVisible()
  fireEvent.change(screen.getByRole('textbox', { name: 'Title' }), { target: { value: 'Effects for Alpha' } })
  await userEvent.click(screen.getByRole('button', { name: 'Create posting' }))
  await waitFor(() => expect(app.at()).toBe(`${path}/postings/p1`))
  await userEvent.type(await screen.findByRole('textbox', { name: 'Budget' }), '8,000')
  await userEvent.click(screen.getByRole('button', { name: 'Save' }))
  await waitFor(() =>
    expect(wrote(server.asked, 'PUT /v1/postings/p1')[0]?.body).toMatchObject({
      budget_minor: 800000,
      scope: 'all',
      headings: HEADINGS,
      revision: 2,
    }),
  )
  await userEvent.click(await screen.findByRole('button', { name: 'Open for bids' }))
  expect(await screen.findByText('Close', { selector: 'button' })).toBeVisible() // not that of the toast
})

const draftOpened = (more: Partial<Posting> = {}) => {
  const server = new ListServer([], {}, 'team')
  server.answers['GET /v1/postings/p1/cues'] = []
  server.answers['GET /v1/projects/shield-wing/effort'] = { cues: 0 }
  server.answers['GET /v1/postings/p1'] = aPosting({ state: 'draft', opened_at: null, ...more })
  openApp(`${server.path.replace('/sound-list', '')}/postings/p1`)
  return server
}
const writes = ({ asked }: ListServer) =>
  asked.filter(({ method }) => method !== 'GET').map(({ method, path }) => `${method} ${path}`)

test(
  'a day that the work cannot keep is said before the posting opens, with the arithmetic',
  { tags: ['slow'] },
  async () => {
    const effort = {
      ...{ cues: 4, files: 11, low_h: 140.2, high_h: 190, concepts: 1, begin_on: '2027-01-04', due_on: '2027-01-20' },
      ...{ weekly_hours: 30, weekly_hours_from: 'assumed', earliest_on: '2027-02-05', latest_on: '2027-02-17' },
      fit: 'impossible',
      lines: [
        { category: 'foley', cues: 3, files: 10, low_h: 120, high_h: 160, basis: 'studio', based_on: 12 },
        { category: 'ui', cues: 1, files: 1, low_h: 20.2, high_h: 30, basis: 'usual', based_on: 0 },
      ],
    }
    const server = new ListServer([], {}, 'team')
    server.answers['GET /v1/postings/p1'] = aPosting({ state: 'draft', work_to_on: '2027-01-20' })
    server.answers['GET /v1/projects/shield-wing/effort'] = effort
    openApp(`${server.path.replace('/sound-list', '')}/postings/p1`)
    const line = await screen.findByRole('group', { name: 'Effort' })
    expect(line).toHaveTextContent(
      '4 cues, 11 files: about 140–190 h, by the hours that were logged with you and usual figures. ' +
        'At 30 h a week from 4 January 2027, done between 5 February 2027 and 17 February 2027.',
    )
    expect(within(line).getByRole('status')).toHaveTextContent('20 January 2027 is too early for this work.')
    await userEvent.click(within(line).getByText('How it is counted'))
    expect(line).toHaveTextContent(
      'foley: 3 cues, 10 files, 120–160 h, by the hours that were logged with you (12 cues)',
    )
    const weeklyHours = within(line).getByLabelText('Hours a week')
    fireEvent.change(weeklyHours, { target: { value: '' } })
    expect(weeklyHours).toHaveValue('')
    fireEvent.change(weeklyHours, { target: { value: '60' } })
    fireEvent.change(screen.getByLabelText('Work to'), { target: { value: '2027-03-01' } })
    const last = () => server.asked.filter(({ path }) => path.endsWith('/effort')).at(-1)?.query
    await waitFor(() => expect([last()?.get('weekly_hours'), last()?.get('due_on')]).toEqual(['60', '2027-03-01']))
  },
)

test('what opens a posting saves first what is typed, and publishes that', { tags: ['slow'] }, async () => {
  const server = draftOpened({ text: '' })
  server.answers['PUT /v1/postings/p1'] = aPosting({ state: 'draft', revision: 3, currency: 'EUR', text: 'Fights.' })
  server.answers['POST /v1/postings/p1/open'] = aPosting({ revision: 4, currency: 'EUR', text: 'Fights.' })
  fireEvent.change(await screen.findByRole('textbox', { name: 'Text' }), { target: { value: 'Fights.' } })
  fireEvent.change(screen.getByRole('textbox', { name: 'Currency' }), { target: { value: 'EUR' } })
  await userEvent.click(screen.getByRole('button', { name: 'Save and open for bids' }))
  await waitFor(() => expect(writes(server)).toEqual(['PUT /v1/postings/p1', 'POST /v1/postings/p1/open']))
  expect(wrote(server.asked, 'PUT /v1/postings/p1')[0]?.body).toMatchObject({ text: 'Fights.', currency: 'EUR' })
  expect(await screen.findByRole('textbox', { name: 'Currency' })).toHaveValue('EUR')
})

test('a posting whose text cannot be saved does not open, and says why beside the button', async () => {
  const server = draftOpened()
  fireEvent.change(await screen.findByRole('textbox', { name: 'Budget' }), { target: { value: 'much' } })
  await userEvent.click(screen.getByRole('button', { name: 'Save and open for bids' }))
  expect(await screen.findByRole('alert')).toHaveTextContent('Enter sums in USD, such as 1,200.00.')
  expect(writes(server)).toEqual([])
  server.answers['PUT /v1/postings/p1'] = refusal(409, 'posting-changed', 'someone changed this posting')
  fireEvent.change(screen.getByRole('textbox', { name: 'Budget' }), { target: { value: '900' } })
  await userEvent.click(screen.getByRole('button', { name: 'Save and open for bids' }))
  expect(await screen.findByText('Someone changed this posting.')).toBeVisible()
  expect(writes(server)).toEqual(['PUT /v1/postings/p1'])
})

test(
  'what was typed before a colleague opened the posting keeps what is fixed as it was opened, and can be saved',
  { tags: ['slow'] },
  async () => {
    const server = draftOpened()
    fireEvent.change(await screen.findByRole('textbox', { name: 'Text' }), { target: { value: 'Four months.' } })
    fireEvent.change(screen.getByRole('textbox', { name: 'Currency' }), { target: { value: 'EUR' } })
    act(() => void queryClient.setQueryData(postingQuery('p1').queryKey, aPosting({ revision: 4 }))) // a colleague opened it
    server.answers['PUT /v1/postings/p1'] = aPosting({ revision: 5 })
    await screen.findByText(/^Fixed: /)
    const currency = screen.getByRole('textbox', { name: 'Currency' })
    expect(currency).toHaveValue('USD')
    expect(currency).toHaveAccessibleDescription('Fixed: the posting was opened in USD, before EUR was saved.')
    await userEvent.click(screen.getByRole('button', { name: 'Save' }))
    await waitFor(() =>
      expect(wrote(server.asked, 'PUT /v1/postings/p1')[0]?.body).toMatchObject({
        ...{ text: 'Four months.', currency: 'USD', scope: 'all', categories: [] },
      }),
    )
  },
)

const RECORD = {
  studio_name: 'Two Rivers',
  review_hours: 30,
  answer_hours: null,
  days_to_pay: 12,
  rounds_per_cue: 0.5,
  bonuses_promised: 2,
  bonuses_earned: 1,
  bonuses_paid: 1,
}

test('a bidder reads how the studio reviews and pays', async () => {
  bidOpened()
  const record = await screen.findByRole('region', { name: 'Two Rivers’s record' })
  expect(
    within(record)
      .getAllByRole('listitem')
      .map(({ textContent }) => textContent),
  ).toEqual([
    'Time to a verdict: 30 hours.',
    'Time to a payment: 12 days.',
    'Rounds of changes for a cue: 0.5.',
    'Bonuses: 2 contracts with one, 1 earned, 1 paid.',
  ])
})

function bidOpened(more: Partial<Posting> = {}) {
  const server = new ListServer([], {}, 'designer')
  const seen = aPosting({ is_team: false, headings: [], bids: null, ...more })
  server.answers['GET /v1/postings/p1/cues'] = []
  server.answers['GET /v1/postings/p1'] = seen
  server.answers['GET /v1/postings/p1/studio-record'] = RECORD
  openApp('/postings/p1')
  return { server, seen }
}

test('a bid says what an hour of it earns', async () => {
  bidOpened()
  const footsteps = await screen.findByRole('group', { name: 'Footsteps' })
  await userEvent.type(within(footsteps).getByRole('textbox', { name: 'Price, USD' }), '100')
  await userEvent.type(screen.getByRole('textbox', { name: /hours/i }), '7.5')
  expect(screen.getByText('$40.00 an hour of the whole work')).toBeVisible() // 300.00 in 7.5 hours
})

test('a designer bids on the asked lines; what cannot be read is said, and what was typed is kept', async () => {
  const { server, seen } = bidOpened()
  await screen.findByRole('heading', { name: 'Your bid' })
  const footsteps = screen.getByRole('group', { name: 'Footsteps' })
  expect(within(footsteps).getByRole('textbox', { name: 'How many' })).toHaveValue('3')
  await userEvent.type(within(footsteps).getByRole('textbox', { name: 'Price, USD' }), '270')
  await userEvent.click(screen.getByRole('button', { name: /^Send/ }))
  expect(await screen.findByRole('alert')).toHaveTextContent('Enter a price in USD for ui, such as 270.00.')
  expect(wrote(server.asked, 'PUT /v1/postings/p1/bid')).toHaveLength(0)
  await userEvent.click(screen.getByRole('checkbox', { name: 'UI' }))
  expect(screen.getByText('Total $810.00')).toBeVisible()
  expect(screen.getByText('without UI')).toBeVisible()
  const own = {
    id: 'b1',
    state: 'draft' as const,
    revision: 1,
    content: { ...aBid('', '').content, lines: aBid('', '').content.lines.slice(0, 1) },
    total_minor: 81000,
    concept_minor: 0,
    missing: ['UI'],
    sent_at: null,
    resent_at: null,
    differs: false,
    samples: [],
    is_awarded: false,
  }
  server.answers['PUT /v1/postings/p1/bid'] = { ...seen, own_bid: own }
  server.answers['POST /v1/postings/p1/bid/send'] = { ...seen, own_bid: { ...own, state: 'sent' } }
  await userEvent.keyboard('{Control>}{Enter}{/Control}')
  await waitFor(() => expect(wrote(server.asked, 'POST /v1/postings/p1/bid/send')[0]?.body).toEqual({ revision: 1 }))
  expect(wrote(server.asked, 'PUT /v1/postings/p1/bid')[0]?.body).toMatchObject({
    revision: 0,
    lines: [{ key: 'footsteps', quantity_hundredths: 300, price_minor: 27000 }],
  })
  expect(await screen.findByRole('button', { name: /Send again/ })).toBeVisible()
})

test('a bid that is saved and then refused says so', async () => {
  const { server, seen } = bidOpened({ lines: [] })
  await screen.findByRole('heading', { name: 'Your bid' })
  const own = {
    ...{ id: 'b1', state: 'draft' as const, revision: 1, content: { ...aBid('', '').content, lines: [] } },
    ...{ total_minor: 0, concept_minor: 0, missing: [], sent_at: null, resent_at: null, differs: false },
    ...{ samples: [], is_awarded: false },
  }
  server.answers['PUT /v1/postings/p1/bid'] = { ...seen, own_bid: own }
  server.answers['POST /v1/postings/p1/bid/send'] = refusal(422, 'bid-invalid', 'the bid offers nothing yet')
  await userEvent.click(screen.getByRole('button', { name: /^Send/ }))
  expect(await screen.findByRole('alert')).toHaveTextContent('The bid offers nothing yet.')
})

test('a closed posting takes no bid, and an NDA leaves title, dates and studio', async () => {
  bidOpened({ takes_bids: false, state: 'closed' })
  expect(await screen.findByText('This posting takes no bids now. What you have typed is kept.')).toBeVisible()
  expect(screen.getByRole('button', { name: 'Save draft' })).toBeDisabled()
})

test('behind the NDA there is no form', async () => {
  bidOpened({ nda_open: true, lines: [], text: '', project_name: '' })
  expect(await screen.findByRole('heading', { name: 'An NDA comes first' })).toBeVisible()
  expect(screen.queryByRole('heading', { name: 'Your bid' })).not.toBeInTheDocument()
})

const linkOpened = (personal: { email: string | null; has_account: boolean }, sendsMail = true) => {
  const shown = { ...aPosting({ project_name: 'Shield Wing' }), nda_needed: false, sends_mail: sendsMail, ...personal }
  const server = serve({
    'GET /v1/session': { signed_in: false, demo: false },
    'GET /v1/posting-links/abc': shown,
  })
  openApp('/posting/abc')
  return server
}

test('the link for everyone shows the posting, and mails a link of one’s own', async () => {
  const server = linkOpened({ email: null, has_account: false })
  server.answers['POST /v1/posting-links/abc/ask'] = null
  expect(await screen.findByRole('heading', { name: 'Effects for Alpha' })).toBeVisible()
  expect(screen.getByText('3 cues, 10 files')).toBeVisible()
  const signIn = await screen.findByRole('link', { name: 'I already have an account' })
  expect(signIn).toHaveAttribute('href', '/sign-in?next=%2Fposting%2Fabc')
  await userEvent.type(screen.getByLabelText('Email'), 'ada@tones.example{Enter}')
  expect(await screen.findByText(/^We have sent an email to ada@tones.example with a link/)).toBeVisible()
  expect(wrote(server.asked, 'POST /v1/posting-links/abc/ask')[0]?.body).toEqual({ email: 'ada@tones.example' })
})

test('on a server without mail the link for everyone promises no email', async () => {
  const server = linkOpened({ email: null, has_account: false }, false)
  server.answers['POST /v1/posting-links/abc/ask'] = null
  await userEvent.type(await screen.findByLabelText('Email'), 'ada@tones.example')
  await userEvent.click(screen.getByRole('button', { name: 'Ask for a link' }))
  expect(await screen.findByRole('heading', { name: 'The studio has your address' })).toBeVisible()
  expect(
    screen.getByText(/^This server sends no email: the studio hands you a link for ada@tones\.example/),
  ).toBeVisible()
})

const candidate = (id: string, more: Partial<Posting['candidates'][number]> = {}): Posting['candidates'][number] => ({
  id,
  email: `${id}@tones.example`,
  person: null,
  is_invited: true,
  joined_at: null,
  created_at: '2026-11-25T10:00:00Z',
  ...more,
})
const mailedLink = (of: string, more: object) => ({
  of_id: of,
  mail_id: `m-${of}`,
  recipient: `${of}@tones.example`,
  created_at: '2026-11-25T10:00:00Z',
  sent_at: null,
  failure: null,
  link: null,
  ...more,
})

test('each person who is asked has the state of their email beside them, and their link where nothing sends it', async () => {
  const people = ['ada', 'bo', 'cy', 'di'].map((id) => candidate(id))
  const server = draftOpened({
    state: 'open',
    candidates: [...people, candidate('eve', { joined_at: '2026-11-25T10:00:00Z' })],
  })
  server.answers['GET /v1/projects/shield-wing/mailed-links'] = {
    can_send: true,
    links: [
      mailedLink('ada', { state: 'no_server', link: 'http://x/posting/ada' }),
      mailedLink('bo', { state: 'sent', sent_at: new Date().toISOString() }),
      mailedLink('cy', { state: 'failed', failure: 'SMTPConnectError: refused' }),
    ],
  }
  const user = userEvent.setup()
  const rows = within(await screen.findByRole('region', { name: /^Who is asked/ }))
  await rows.findByText('Emailed just now')
  const row = (name: string) => rows.getByText(`${name}@tones.example`).closest('li')
  expect(row('ada')).toHaveTextContent('Not emailed: no mail server')
  expect(row('cy')).toHaveTextContent('Email failed, is tried again')
  expect(row('di')).toHaveTextContent('Email waiting')
  expect(row('eve')).not.toHaveTextContent('Email')
  server.answers['POST /v1/mails/m-cy/link'] = refusal(403, 'producer-needed', 'only a producer can do this')
  await user.click(rows.getByRole('button', { name: 'Show link for cy@tones.example' }))
  expect(await rows.findByRole('alert')).toHaveTextContent('Only a producer can do this.')
  await user.click(rows.getByRole('button', { name: 'Copy link for ada@tones.example' }))
  expect(await navigator.clipboard.readText()).toBe('http://x/posting/ada')
})

test('a bidder reads the cues of each line that is priced', async () => {
  const { server } = bidOpened()
  const cue = {
    line: 'footsteps',
    duration_s: null,
    duration_min_s: null,
    duration_max_s: null,
    loop: false,
    is_concept: false,
  }
  server.answers['GET /v1/postings/p1/cues'] = [
    { ...cue, id: 'c1', name: 'Grass', variations: 1 },
    { ...cue, id: 'c2', name: 'Sand', variations: 6, duration_s: 0.4, loop: true, is_concept: true },
    { ...cue, id: 'c3', name: 'Snow', variations: 3 },
    { ...cue, id: 'c4', name: 'Open', line: 'ui', variations: 1 },
    { ...cue, id: 'c5', name: 'Shut', line: 'ui', variations: 2 },
  ]
  const cues = within(await screen.findByRole('list', { name: 'Cues of Footsteps', hidden: true }))
  expect(cues.getAllByRole('listitem', { hidden: true }).map(({ textContent }) => textContent)).toEqual([
    'Grass 1 file, no length yet',
    'Sand 6 files, 0.40 s each, loop, concept',
    'Snow 3 files, no length yet',
  ])
  expect(screen.getByText('The sound list has changed since: it has 2 cues for this line now.')).toBeInTheDocument()
})

test.each([
  [false, 'Create account and bid', { name: 'Ada Tones', password: 'quiet reactor hum' }],
  [true, 'Sign in and bid', { name: null, password: 'quiet reactor hum' }],
])('a personal link leads to the bid, with an account: %s', async (hasAccount, action, sent) => {
  const server = linkOpened({ email: 'ada@tones.example', has_account: hasAccount })
  server.answers['POST /v1/posting-links/abc/account'] = { id: 'd1', name: 'Ada Tones' }
  server.answers['POST /v1/posting-links/abc/join'] = refusal(409, 'link-taken', 'another account has used this link')
  if (!hasAccount) await userEvent.type(await screen.findByLabelText('Your name'), 'Ada Tones')
  fireEvent.change(await screen.findByLabelText(hasAccount ? 'Password' : 'New password'), {
    target: { value: 'quiet reactor hum' },
  })
  await userEvent.click(screen.getByRole('button', { name: action }))
  await waitFor(() => expect(wrote(server.asked, 'POST /v1/posting-links/abc/join')).toHaveLength(1))
  expect(wrote(server.asked, 'POST /v1/posting-links/abc/account')[0]?.body).toEqual(sent)
  expect(await screen.findByRole('alert')).toHaveTextContent('Another account has used this link.')
})

test('a link that was revoked says what to do', async () => {
  serve({
    'GET /v1/session': { signed_in: false, demo: false },
    'GET /v1/posting-links/abc': refusal(404, 'posting-not-found', 'this link is unknown, withdrawn or expired', {
      fix: 'Ask the studio for a new one.',
    }),
  })
  openApp('/posting/abc')
  expect(await screen.findByRole('alert')).toHaveTextContent('This link is unknown, withdrawn or expired.')
})

test('hundredths and sums are exact', () => {
  expect([
    hundredthsOf('7.5'),
    hundredthsOf('3'),
    hundredthsOf('0.05'),
    hundredthsOf('x'),
    hundredthsOf('1.005'),
  ]).toEqual([750, 300, 5, null, null])
  const typed = typedBid(LINES, null, 'USD')
  typed.lines = [
    { key: 'Oath', kind: 'voice', unit: 'per_hour', quantity: '1.5', price: '33.33', note: '', isOffered: true },
  ]
  expect(totalOf(typed, 'USD')).toBe(5000)
  expect(contentOf({ ...typed, hours: 'many' }, 'USD')).toEqual({ wrong: 'Enter the hours, such as 160.' })
})

test('the pages have no fault that a machine can find', { tags: ['slow'] }, async () => {
  bidsOpened()
  await screen.findByRole('heading', { name: '2 bids on Effects for Alpha' })
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
})

test('a posting stays on the page while the server is away', { tags: ['slow'] }, async () => {
  const server = new ListServer([], {}, 'team')
  const path = server.path.replace('/sound-list', '')
  server.answers['GET /v1/postings/p1/cues'] = []
  server.answers['GET /v1/postings/p1'] = aPosting()
  openApp(`${path}/postings/p1`)
  expect(await screen.findByRole('heading', { name: 'Effects for Alpha' })).toBeVisible()
  server.answers['GET /v1/postings/p1'] = refusal(503, 'database-unavailable', 'the database does not answer')
  await act(async () => {
    await queryClient.refetchQueries({ queryKey: postingQuery('p1').queryKey })
    await new Promise((resolve) => setTimeout(resolve)) // the page is notified one turn later
  })
  expect(queryClient.getQueryState(postingQuery('p1').queryKey)?.status).toBe('error')
  expect(screen.getByRole('heading', { name: 'Effects for Alpha' })).toBeVisible()
})

test('a call is noted on a bid, for the team', async () => {
  const { server } = bidsOpened()
  const note = { id: 'n1', kind: 'call' as const, held_on: '2026-12-01', text: 'Starts in January.' }
  const noted = { ...note, author: { id: 'someone', name: 'Producer' }, created_at: '2026-12-01T10:00:00Z' }
  server.answers['POST /v1/bids/b1/notes'] = () => {
    const bids = [aBid('b1', 'Sound designer A', { notes: [noted] }), second]
    server.answers['GET /v1/postings/p1/bids'] = compared(bids)
    return compared(bids)
  }
  const card = await screen.findByRole('region', { name: 'Notes on Sound designer A' })
  await userEvent.type(within(card).getByLabelText('Note'), 'Starts in January.')
  await userEvent.click(within(card).getByRole('button', { name: 'Add note' }))
  expect(await within(card).findByText('Starts in January.', { selector: 'p' })).toBeVisible()
  expect(server.sent('POST', '/v1/bids/b1/notes')[0]?.body).toMatchObject({ kind: 'call', text: 'Starts in January.' })
  expect(within(card).getByRole('button', { name: /^Remove the note/ })).toBeVisible()
  expect(within(card).getByLabelText('Note')).toHaveValue('')
})
