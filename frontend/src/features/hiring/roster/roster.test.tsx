import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, type Answers, type Asked, refusal, serve, wrote } from '@/test/server'

import type { Entry, Figures, Roster, RosterRow } from './api'
import { weeksInWords } from './Weeks'
import type { Week } from './words'

const FREE = Array.from({ length: 12 }, (): Week => 'free')
const person = { id: 'me', name: 'Producer' }

const aRow = (id: string, name: string, more: Partial<RosterRow> = {}): RosterRow => ({
  id,
  name,
  email: `${id}@studio.example`,
  specialities: ['weapons'],
  services: ['composes'],
  languages: [],
  exclusivity: 'unknown',
  weekly_hours: null,
  free_from_on: '2020-01-01',
  weeks: FREE,
  clashes: [],
  rate: null,
  reel: [],
  works_here: false,
  ...more,
})

const aRoster = (items: RosterRow[], more: Partial<Roster> = {}): Roster => ({
  items,
  next: null,
  found: items.length,
  total: items.length,
  first_week_on: '2026-11-23',
  specialities: [{ value: 'weapons', count: 2 }],
  services: [{ value: 'composes', count: 1 }],
  languages: [],
  ...more,
})

const anEntry = (more: Partial<Entry> = {}): Entry => ({
  id: 'e1',
  studio_id: 's1',
  name: 'Designer A',
  email: 'a@studio.example',
  specialities: ['weapons'],
  services: [],
  languages: [],
  equipment: '',
  credits: '',
  referees: '',
  links: [{ title: 'Reel', url: 'https://reel.example/a' }],
  exclusivity: 'unknown',
  weekly_hours: null,
  available_from_on: null,
  notes: '',
  rate: { amount_minor: 4500, currency: 'USD', unit: 'hour' },
  may_see_rate: true,
  revision: 3,
  free_from_on: '2020-01-01',
  first_week_on: '2026-11-23',
  weeks: FREE,
  busy: [],
  calendar_name: null,
  calendar_read_at: null,
  calendar_to_on: null,
  loans: [],
  reel: [],
  designer: null,
  added_at: '2026-11-20T10:00:00Z',
  changed_at: '2026-11-20T10:00:00Z',
  ...more,
})

const FIGURES: Figures = {
  studio_id: 's1',
  studio_name: 'Test studio',
  projects: [{ id: 'p1', name: 'Shield Wing', since: '2026-01-01T00:00:00Z', accepted: 12 }],
  accepted: 12,
  on_time: 0.75,
  days_late: -1,
  first_pass: 0.5,
  rounds_per_cue: 0.6,
  revision_hours: 30,
  estimates: { pairs: 5, mean_percent: 12.4, spread_points: 8, habit: 'steady' },
}

function served(answers: Answers, roles: string[] = ['producer']) {
  return serve({
    'GET /v1/session': { signed_in: true, demo: false, person },
    'GET /v1/me': {
      person,
      email: 'me@studio.example',
      studios: roles.length > 0 ? [{ id: 's1', name: 'Test studio', roles }] : [],
      projects: [],
    },
    'GET /v1/review-queue/count': { cues: 0, is_all: true },
    ...answers,
  })
}

beforeEach(() => localStorage.clear())

test('the search stands in the address, and every row says when a person is free', { tags: ['slow'] }, async () => {
  const { asked } = served({
    'GET /v1/studios/s1/roster': ({ query }: Asked) =>
      query.get('speciality') === 'weapons'
        ? aRoster([aRow('e1', 'Designer A')], { total: 2 })
        : aRoster([aRow('e1', 'Designer A'), aRow('e2', 'Designer B', { free_from_on: '2999-01-11' })]),
  })
  const app = openApp('/roster')
  expect(await screen.findByRole('link', { name: 'Designer B' })).toBeVisible()
  expect(screen.getByText('free now')).toBeVisible()
  expect(screen.getAllByRole('img', { name: 'Next 12 weeks: free for 12 weeks' })).toHaveLength(2)
  await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Speciality' }), 'weapons')
  await waitFor(() => expect(screen.queryByRole('link', { name: 'Designer B' })).not.toBeInTheDocument())
  expect(app.search()).toEqual({ speciality: 'weapons' })
  expect(screen.getByText('1 of 2')).toBeVisible()
  expect(wrote(asked, 'GET /v1/studios/s1/roster').at(-1)?.query.get('speciality')).toBe('weapons')
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
})

test('a search from an address asks for its words and its days, and names a clash', async () => {
  const { asked } = served({
    'GET /v1/studios/s1/roster': aRoster([
      aRow('e1', 'Designer A', {
        clashes: [{ from_on: '2026-11-30', to_on: '2026-12-11', kind: 'booked', note: 'another game' }],
      }),
      aRow('e2', 'Designer B'),
    ]),
  })
  openApp('/roster?q=laser&from=2026-11-30&to=2026-12-20')
  expect(await screen.findByText(/another game/)).toHaveTextContent(/30 Nov.*to.*11 Dec.*another game/)
  expect(screen.getByText('free in these days')).toBeVisible()
  const query = wrote(asked, 'GET /v1/studios/s1/roster')[0]?.query
  expect(Object.fromEntries(query ?? [])).toEqual({ q: 'laser', free_from: '2026-11-30', free_to: '2026-12-20' })
})

test('by keys: move, play the reel, open', async () => {
  const play = vi.spyOn(HTMLMediaElement.prototype, 'play').mockResolvedValue()
  const sound = { id: 'r1', title: 'Lasers', file_name: 'l.wav', media_type: 'audio/wav', file_bytes: 100 }
  served({
    'GET /v1/studios/s1/roster': aRoster([aRow('e1', 'Designer A'), aRow('e2', 'Designer B', { reel: [sound] })]),
    'GET /v1/roster/e2': anEntry({ id: 'e2', name: 'Designer B' }),
    'GET /v1/roster/e2/postings': [],
  })
  const app = openApp('/roster')
  await screen.findByRole('link', { name: 'Designer B' })
  await userEvent.keyboard('jj')
  expect(screen.getByRole('link', { name: 'Designer B' })).toHaveFocus()
  await userEvent.click(screen.getByRole('button', { name: 'Play Lasers by Designer B' }))
  expect(play).toHaveBeenCalledTimes(1)
  expect(await screen.findByRole('button', { name: 'Pause Lasers by Designer B' })).toBeVisible()
  screen.getByRole('link', { name: 'Designer B' }).focus()
  await userEvent.keyboard('{Enter}')
  await waitFor(() => expect(app.at()).toBe('/roster/e2'))
})

test('an empty roster says what it is for, and a first person is put on file', async () => {
  const { asked } = served({
    'GET /v1/studios/s1/roster': aRoster([], { specialities: [], services: [] }),
    'POST /v1/studios/s1/roster': answer(anEntry(), 201),
    'GET /v1/roster/e1': anEntry(),
    'GET /v1/roster/e1/postings': [],
  })
  const app = openApp('/roster')
  expect(await screen.findByRole('heading', { name: 'Nobody on file yet' })).toBeVisible()
  await userEvent.type(screen.getByRole('textbox', { name: 'Name' }), 'Designer A')
  fireEvent.change(screen.getByRole('textbox', { name: 'Email' }), { target: { value: 'a@studio.example' } })
  await userEvent.click(screen.getByRole('button', { name: 'Add designer' }))
  await waitFor(() => expect(app.at()).toBe('/roster/e1'))
  expect(wrote(asked, 'POST /v1/studios/s1/roster')[0]?.body).toMatchObject({ name: 'Designer A' })
})

test('who only reviews or designs is shown the way to their own work', async () => {
  const { asked } = served({}, ['reviewer'])
  openApp('/roster')
  expect(await screen.findByRole('heading', { name: 'The roster is for producers and audio leads' })).toBeVisible()
  expect(screen.getByRole('link', { name: 'Your work' })).toBeVisible()
  expect(wrote(asked, 'GET /v1/studios/s1/roster')).toEqual([])
})

test(
  'an entry is changed with the revision that was read, and what was typed survives a refusal',
  { tags: ['slow'] },
  async () => {
    const { asked, answers } = served({
      'GET /v1/roster/e1': anEntry(),
      'GET /v1/roster/e1/postings': [],
      'PUT /v1/roster/e1': refusal(409, 'roster-entry-changed', 'someone changed this entry since you read it'),
    })
    openApp('/roster/e1')
    const credits = await screen.findByRole('textbox', { name: 'Credits' })
    fireEvent.change(credits, { target: { value: 'Two shipped games' } })
    await userEvent.click(screen.getByRole('checkbox', { name: 'Composes music' }))
    await userEvent.click(screen.getByRole('button', { name: 'Save' }))
    expect(await screen.findByText(/Someone changed this entry/)).toBeVisible()
    expect(credits).toHaveValue('Two shipped games')
    answers['PUT /v1/roster/e1'] = anEntry({ revision: 4, credits: 'Two shipped games', services: ['composes'] })
    await userEvent.click(screen.getByRole('button', { name: 'Save' }))
    await waitFor(() => expect(wrote(asked, 'PUT /v1/roster/e1')).toHaveLength(2))
    expect(wrote(asked, 'PUT /v1/roster/e1')[1]?.body).toMatchObject({
      revision: 3,
      credits: 'Two shipped games',
      services: ['composes'],
      links: [{ title: 'Reel', url: 'https://reel.example/a' }],
      rate: { amount_minor: 4500, currency: 'USD', unit: 'hour' },
    })
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id }) => id)).toEqual([])
  },
)

test('an audio lead sees no rate and sends none', { tags: ['slow'] }, async () => {
  const lead = anEntry({ may_see_rate: false, rate: null })
  const { asked } = served({ 'GET /v1/roster/e1': lead, 'GET /v1/roster/e1/postings': [], 'PUT /v1/roster/e1': lead }, [
    'liaison',
  ])
  openApp('/roster/e1')
  await userEvent.type(await screen.findByRole('textbox', { name: 'Notes' }), 'Called.')
  expect(screen.queryByRole('textbox', { name: /Rate/ })).not.toBeInTheDocument()
  await userEvent.click(screen.getByRole('button', { name: 'Save' }))
  await waitFor(() => expect(wrote(asked, 'PUT /v1/roster/e1')[0]?.body).toMatchObject({ rate: null }))
})

test('busy days are typed, and a calendar file is sent by its bytes', { tags: ['slow'] }, async () => {
  const { asked } = served({
    'GET /v1/roster/e1': anEntry(),
    'GET /v1/roster/e1/postings': [],
    'PUT /v1/roster/e1/busy': anEntry(),
    'PUT /v1/roster/e1/calendar': anEntry({
      calendar_name: 'mine.ics',
      calendar_read_at: '2026-11-26T10:00:00Z',
      calendar_to_on: '2027-11-27',
      busy: [{ from_on: '2026-12-01', to_on: '2026-12-04', kind: 'booked', note: '', is_from_calendar: true }],
    }),
  })
  openApp('/roster/e1')
  await userEvent.click(await screen.findByRole('button', { name: 'Add busy days' }))
  await userEvent.click(screen.getByRole('button', { name: 'Save dates' }))
  expect(screen.getAllByText('Enter a date.')).toHaveLength(2)
  await userEvent.type(screen.getByLabelText('Busy from'), '2026-12-01')
  await userEvent.type(screen.getByLabelText('to'), '2026-12-11')
  await userEvent.click(screen.getByRole('button', { name: 'Save dates' }))
  await waitFor(() =>
    expect(wrote(asked, 'PUT /v1/roster/e1/busy')[0]?.body).toEqual({
      ranges: [{ from_on: '2026-12-01', to_on: '2026-12-11', kind: 'booked', note: '' }],
    }),
  )
  await userEvent.upload(screen.getByLabelText('Calendar file', { selector: 'input' }), new File(['BEGIN'], 'mine.ics'))
  expect(await screen.findByText(/mine.ics, read/)).toHaveTextContent('1 busy range')
  expect(wrote(asked, 'PUT /v1/roster/e1/calendar')[0]?.body).toEqual({
    file_name: 'mine.ics',
    content_base64: btoa('BEGIN'),
  })
})

test('a posting is asked about once, with what is taken of its days', async () => {
  const posting = {
    id: 'p1',
    project_id: 'x1',
    project_name: 'Shield Wing',
    title: 'Effects for Alpha',
    state: 'open',
    work_from_on: '2026-12-01',
    work_to_on: '2026-12-20',
    clashes: [{ from_on: '2026-12-01', to_on: '2026-12-04', kind: 'half_days', note: '' }],
    is_asked: false,
  }
  const { asked, answers } = served({
    'GET /v1/roster/e1': anEntry({ designer: { id: 'd1', name: 'Designer A' } }),
    'GET /v1/roster/e1/work': FIGURES,
    'GET /v1/roster/e1/postings': [posting],
    'POST /v1/postings/p1/roster-candidates': answer({ id: 'p1', project_id: 'x1' }, 201),
  })
  openApp('/roster/e1')
  const ask = await screen.findByRole('button', { name: 'Ask Designer A for a bid on Effects for Alpha' })
  expect(screen.getByText(/Busy.*half days/)).toBeVisible()
  const work = await screen.findByRole('region', { name: 'Track record with us' })
  expect(work).toHaveTextContent('Accepted on time75 %')
  expect(work).toHaveTextContent('Work against estimates+12 % over 5 cues, steady')
  answers['GET /v1/roster/e1/postings'] = [{ ...posting, is_asked: true }]
  await userEvent.click(ask)
  expect(await screen.findByText('asked')).toBeVisible()
  expect(wrote(asked, 'POST /v1/postings/p1/roster-candidates')[0]?.body).toEqual({ entry_ids: ['e1'] })
})

test('a sheet is shown row by row, and is not imported while a row has an error', async () => {
  const plan = {
    header_row: 1,
    columns: [
      { name: 'Name', samples: ['A'], field: 'name' },
      { name: 'Shoe size', samples: ['42'], field: 'ignore' },
    ],
    rows: [{ row: 2, action: 'add', name: 'A', email: 'a@studio.example', changed: [] }],
    errors: [{ row: 3, column: 'Mail', message: 'wanted an email such as name@studio.example, found "none"' }],
    added: 1,
    changed: 0,
    same: 0,
    imported: false,
  }
  const { asked, answers } = served({
    'POST /v1/studios/s1/roster/import': plan,
    'GET /v1/studios/s1/roster': aRoster([aRow('e1', 'A')]),
  })
  const app = openApp('/roster/import')
  await userEvent.click(await screen.findByRole('textbox', { name: 'Pasted rows' }))
  await userEvent.paste('Name\tMail\nA\ta@studio.example')
  expect(await screen.findByRole('row', { name: /Error/ })).toHaveTextContent('Mail: wanted an email')
  expect(screen.getByRole('button', { name: 'Import 1 person' })).toBeDisabled()
  answers['POST /v1/studios/s1/roster/import'] = ({ body }: Asked) => ({
    ...plan,
    errors: [],
    imported: !(body as { dry_run: boolean }).dry_run,
  })
  await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Map Shoe size to' }), 'notes')
  await waitFor(() => expect(screen.getByRole('button', { name: 'Import 1 person' })).toBeEnabled())
  await userEvent.click(screen.getByRole('button', { name: 'Import 1 person' }))
  await waitFor(() => expect(app.at()).toBe('/roster'))
  expect(wrote(asked, 'POST /v1/studios/s1/roster/import').at(-1)?.body).toMatchObject({
    dry_run: false,
    mapping: { 'Shoe size': 'notes' },
  })
})

test('a mapped column that the pasted rows no longer have is named, with those they have', async () => {
  served({
    'POST /v1/studios/s1/roster/import': refusal(
      422,
      'column-unknown',
      'the sheet has no column "Shoe size"; it has Name, Mail',
    ),
  })
  openApp('/roster/import')
  await userEvent.click(await screen.findByRole('textbox', { name: 'Pasted rows' }))
  await userEvent.paste('Name\tMail\nA\ta@studio.example')
  expect(await screen.findByRole('alert')).toHaveTextContent('The sheet has no column "Shoe size"; it has Name, Mail.')
})

test('a designer sees credit, people and playlists of each project', async () => {
  const project = {
    project_id: 'p1',
    project_name: 'Shield Wing',
    studio_name: 'Test studio',
    credit_name: 'Quay Sound',
    is_left_out: false,
    credit_roles: ['Sound design'],
    agreed_line: 'Sounds by Quay Sound',
    shown_from: '1 May 2027',
    people: [{ person: { id: 'a', name: 'Audio director', picture: null }, role: 'Audio direction' }],
    playlists: [{ id: 'l1', name: 'Trailer', takes: 2 }],
  }
  served({ 'GET /v1/me/work': [], 'GET /v1/me/own-projects': [project] }, [])
  openApp('/work')
  const card = await screen.findByRole('region', { name: 'Shield Wing' })
  expect(card).toHaveTextContent('CreditQuay Sound, Sound design.')
  expect(card).toHaveTextContent('As the contract saysSounds by Quay Sound')
  expect(card).toHaveTextContent('May be shown from1 May 2027')
  expect(within(card).getByText('Audio director')).toBeVisible()
  expect(within(card).getByRole('link', { name: 'Trailer' })).toHaveAttribute('href', '/projects/p1/playlists/l1')
  expect(within(card).getByRole('link', { name: 'Change the credit in Shield Wing' })).toHaveAttribute(
    'href',
    '/projects/p1/credits',
  )
})

test('a designer sees what each studio knows of their work', async () => {
  served({ 'GET /v1/me/work': [FIGURES], 'GET /v1/me/own-projects': [] }, [])
  openApp('/work')
  const card = await screen.findByRole('region', { name: 'Test studio' })
  expect(card).toHaveTextContent('Accepted as first sent50 %')
  expect(within(card).queryByRole('link')).not.toBeInTheDocument()
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
})

test('weeks are read out as runs with their Mondays', () => {
  const weeks: Week[] = ['booked', 'booked', 'free', 'half_days']
  expect(weeksInWords(weeks, '2026-11-23')).toMatch(/^booked from .*23.*, free from .*7.*, half days from .*14/)
  expect(weeksInWords(['free', 'free'], '2026-11-23')).toBe('free for 2 weeks')
  expect(weeksInWords(['free'], '2026-11-23')).toBe('free for 1 week')
})

test('equipment is lent, and recorded as returned', { tags: ['slow'] }, async () => {
  const lent = { item: 'Field recorder', lent_on: '2026-11-01', due_on: '2026-11-20', returned_on: null }
  const { asked } = served({
    'GET /v1/roster/e1': anEntry({ loans: [lent] }),
    'GET /v1/roster/e1/postings': [],
    'PUT /v1/roster/e1/loans': anEntry(),
  })
  openApp('/roster/e1')
  const card = await screen.findByRole('region', { name: /Equipment on loan/ })
  expect(within(card).getByText(/due back/)).toBeVisible()
  await userEvent.type(within(card).getByLabelText('Item'), 'Microphone')
  await userEvent.click(within(card).getByRole('button', { name: 'Lend' }))
  await waitFor(() => expect(wrote(asked, 'PUT /v1/roster/e1/loans')).toHaveLength(1))
  expect(wrote(asked, 'PUT /v1/roster/e1/loans')[0]?.body).toMatchObject({
    loans: [lent, { item: 'Microphone', due_on: null, returned_on: null }],
  })
})

test('a loan that is returned says when', async () => {
  const lent = { item: 'Field recorder', lent_on: '2026-11-01', due_on: '2026-11-20', returned_on: null }
  const { asked } = served({
    'GET /v1/roster/e1': anEntry({ loans: [lent] }),
    'GET /v1/roster/e1/postings': [],
    'PUT /v1/roster/e1/loans': anEntry({ loans: [{ ...lent, returned_on: '2026-11-18' }] }),
  })
  openApp('/roster/e1')
  await userEvent.click(await screen.findByRole('button', { name: 'Record that Field recorder is returned' }))
  expect(await screen.findByText(/returned .*18/)).toBeVisible()
  expect(wrote(asked, 'PUT /v1/roster/e1/loans')[0]?.body).toMatchObject({
    loans: [{ item: 'Field recorder', returned_on: expect.stringMatching(/^20\d\d-/) as string }],
  })
})

test('a loan that was returned is removed after a question', async () => {
  const loanOf = (item: string) => ({ item, lent_on: '2026-11-01', due_on: null, returned_on: '2026-11-18' })
  const { asked } = served({
    'GET /v1/roster/e1': anEntry({ loans: [loanOf('Field recorder'), loanOf('Microphone')] }),
    'GET /v1/roster/e1/postings': [],
    'PUT /v1/roster/e1/loans': anEntry({ loans: [loanOf('Microphone')] }),
  })
  openApp('/roster/e1')
  await userEvent.click(await screen.findByRole('button', { name: 'Remove Field recorder' }))
  expect(wrote(asked, 'PUT /v1/roster/e1/loans')).toEqual([])
  await userEvent.click(screen.getByRole('button', { name: 'Remove loan' }))
  await waitFor(() => expect(screen.queryByText('Field recorder')).toBeNull())
  expect(wrote(asked, 'PUT /v1/roster/e1/loans')[0]?.body).toEqual({ loans: [loanOf('Microphone')] })
  expect(screen.getByRole('button', { name: 'Remove Microphone' })).toBeVisible()
})
