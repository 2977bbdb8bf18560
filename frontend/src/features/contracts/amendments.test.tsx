import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

const SHA = 'a'.repeat(64)
const cue = (name: string) => ({ id: name, label: 'SW-001', name })
const stated = (name: string, state: string, part: number, owed: number) => ({
  cue: cue(name),
  milestone: 'Alpha',
  state,
  was_cut: false,
  price_minor: 18_000,
  part_bp: part,
  owed_minor: owed,
  clause: 'kill_fee',
})
const ENDING = {
  project_id: 'p1',
  contract_id: 'c1',
  title: 'Effects for Alpha',
  designer: { id: 'x3', name: 'Sound designer' },
  currency: 'USD',
  my_party: 'designer',
  state: 'forecast',
  notice: null,
  notice_days: 14,
  earliest_ends_on: '2026-12-01',
  deposit_at_end: 'stays',
  cues: [
    stated('radar_ping', 'accepted', 10_000, 18_000),
    stated('dock_clamp', 'in_work', 5_000, 9_000),
    stated('mine_arm', 'in_work', 5_000, 9_000),
    stated('warp_in', 'delivered', 7_500, 13_500),
  ],
  cues_minor: 49_500,
  deposit_minor: 10_000,
  rounds_minor: 0,
  extra_minor: 0,
  days_minor: 0,
  hours_minor: 0,
  retainer_minor: 0,
  due_now_minor: 28_000,
  figures: {
    agreed_minor: 82_000,
    accepted_minor: 59_500,
    paid_minor: 0,
    due_minor: 59_500,
    open_minor: 0,
    saved_minor: 22_500,
  },
  open_points: [],
  statement_sha256: null,
  settled_at: null,
  signed: [],
  signatures_needed: 2,
  may: { give_notice: true, withdraw: false, agree: false },
}
const NOTICE = {
  number: 1,
  party: 'studio',
  given_by: 'Producer',
  given_at: '2026-11-17T09:00:00Z',
  reason: 'The game is shelved.',
  ends_on: '2026-12-01',
}
const GIVEN = {
  ...ENDING,
  state: 'notice',
  notice: NOTICE,
  statement_sha256: SHA,
  may: { give_notice: false, withdraw: true, agree: true },
}
const DIFFERENCE = {
  changes: ['SW-025 shield_down is added to Beta at USD 225.00.'],
  cues_before: 23,
  cues_after: 24,
  price_before_minor: 704_250,
  price_after_minor: 726_750,
  milestones: [
    {
      name: 'Beta',
      is_deposit: false,
      amount_before_minor: 236_250,
      amount_after_minor: 258_750,
      due_before: '2026-12-18',
      due_after: '2026-12-16',
    },
  ],
  warnings: [
    { code: 'earlier-and-more', message: 'Beta moves up while work is added to it.', why: 'Dates are missed.' },
  ],
  advice: [],
  advice_gone: [],
}
const ORDER = {
  number: 1,
  state: 'proposed',
  party: 'studio',
  proposed_by: 'Producer',
  proposed_at: '2026-11-15T09:00:00Z',
  reason: 'The level grew',
  begins_at_once: false,
  closed_at: null,
  close_reason: '',
  text_sha256: SHA,
  blocks: [],
  difference: DIFFERENCE,
  problems: [],
  signed: [],
  signatures_needed: 2,
  may: { agree: true, refuse: true, withdraw: false },
}
const ORDERS = {
  project_id: 'p1',
  contract_id: 'c1',
  title: 'Effects for Alpha',
  currency: 'USD',
  my_party: 'designer',
  may_propose: true,
  extra_round_bp: 2_500,
  orders: [ORDER],
  offers: [],
  milestones: [{ id: 'm1', name: 'Beta', due_on: '2026-12-18' }],
  cues: [{ cue: cue('mine_arm'), price_minor: 18_000, round_minor: 4_500 }],
  caps: null,
  cues_to_add: [cue('shield_down')],
}
const ME = { id: 'x3', name: 'Sound designer' }
const PROJECT = {
  id: 'p1',
  name: 'Shield Wing',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  part: 'designer',
  cue_prefix: 'SW',
  is_producer: false,
  engagement_kind: 'contract',
}
const given = (more: Answers): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: ME },
  'GET /v1/me': { person: ME, email: 'designer@sound.example', studios: [], projects: [PROJECT] },
  ...more,
})

test('before a notice the page is a forecast, and notice is given with a reason', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/ending': ENDING }))
  answers['POST /v1/contracts/c1/ending/notice'] = () => (answers['GET /v1/contracts/c1/ending'] = GIVEN)
  openApp('/projects/p1/contracts/c1/ending')
  const statement = await screen.findByRole('region', { name: 'Statement' })
  const line = within(statement).getByRole('row', { name: /dock_clamp, mine_arm/ })
  expect(line).toHaveTextContent('50 %')
  expect(line).toHaveTextContent('180.00')
  expect(within(statement).getByRole('row', { name: /To pay/ })).toHaveTextContent('$595.00')
  expect(screen.getByText(/= paid 0.00 \+ to pay 595.00 \+ not owed 225.00/)).toBeVisible()
  expect(screen.getByText(/1 cue waits for approval. Accepted, they owe 45.00 more/)).toBeVisible()
  await userEvent.type(screen.getByLabelText('Reason'), 'The game is shelved.')
  await userEvent.click(screen.getByRole('button', { name: 'Give notice' }))
  expect(await screen.findByRole('button', { name: 'Withdraw the notice' })).toBeVisible()
  expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ reason: 'The game is shelved.', ends_on: null })
})

test('a statement is agreed to by its hash, under a name; a refusal is shown', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/ending': GIVEN }))
  answers['POST /v1/contracts/c1/ending/agree'] = refusal(409, 'text-changed', 'the text was changed')
  openApp('/projects/p1/contracts/c1/ending')
  const agree = await screen.findByRole('button', { name: 'Agree to the statement' })
  expect(agree).toBeDisabled()
  await userEvent.type(screen.getByLabelText('Your full name'), 'N. Designer')
  await userEvent.click(agree)
  expect(await screen.findByText('The text was changed.')).toBeVisible()
  expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: 'N. Designer', text_sha256: SHA })
  const settled = { ...GIVEN, state: 'settled', settled_at: '2026-11-18T09:00:00Z', may: ENDING.may }
  answers['POST /v1/contracts/c1/ending/agree'] = () => (answers['GET /v1/contracts/c1/ending'] = settled)
  await userEvent.click(agree)
  expect(await screen.findByRole('heading', { name: 'Settlement' })).toBeVisible()
})

test.each([
  ['studio', 'settled', 1],
  ['designer', 'settled', 0],
  ['studio', 'notice', 0],
])('for the %s of a contract that is %s there are %i handover packs', async (party, state, packs) => {
  serve(
    given({ 'GET /v1/contracts/c1/ending': { ...GIVEN, my_party: party, state, settled_at: '2026-11-18T09:00:00Z' } }),
  )
  openApp('/projects/p1/contracts/c1/ending')
  await screen.findByRole('region', { name: 'Settlement statement' })
  const links = screen.queryAllByRole('link', { name: 'Download handover pack' })
  expect(links.map((link) => link.getAttribute('href'))).toEqual(
    Array.from({ length: packs }, () => '/v1/contracts/c1/handover'),
  )
  expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
})

test('a change order shows what it changes, and is signed by its hash', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/change-orders': ORDERS }))
  answers['POST /v1/contracts/c1/change-orders/1/accept'] = { ...ORDERS, orders: [{ ...ORDER, may: {} }] }
  openApp('/projects/p1/contracts/c1/changes')
  const card = await screen.findByRole('region', { name: 'Change order 1' })
  expect(card).toHaveTextContent('23 cues → 24 cues')
  expect(card).toHaveTextContent('7,042.50 → $7,267.50 + 225.00')
  expect(card).toHaveTextContent('Beta moves up while work is added to it. Dates are missed.')
  expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
  await userEvent.type(within(card).getByLabelText('Your full name'), 'N. Designer')
  await userEvent.click(within(card).getByRole('button', { name: 'Sign change order 1' }))
  expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: 'N. Designer', text_sha256: SHA })
})

test('a change is put together, looked at and proposed', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [] } }))
  answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  answers['POST /v1/contracts/c1/change-orders'] = ORDERS
  openApp('/projects/p1/contracts/c1/changes')
  await userEvent.type(await screen.findByLabelText('Price in USD'), '225')
  await userEvent.click(screen.getByRole('button', { name: 'Add this change' }))
  expect(await screen.findByText('SW-025 shield_down is added to Beta at USD 225.00.')).toBeVisible()
  await userEvent.type(screen.getByLabelText('Reason'), 'The level grew')
  await userEvent.click(screen.getByRole('button', { name: 'Propose' }))
  expect(await screen.findByRole('region', { name: 'Change order 1' })).toBeVisible()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
    reason: 'The level grew',
    begins_at_once: false,
    changes: [{ kind: 'add_cue', cue_id: 'shield_down', milestone_id: 'm1', price_minor: 22_500 }],
    offers: [],
  })
})

test.each(['changes', 'ending'])('a name that was drawn is shown beside the typed one on the page %s', async (page) => {
  const drawn = {
    party: 'studio',
    name: 'P. Producer',
    drawing: [
      [
        [10, 20],
        [300, 250],
      ],
    ],
    accepted_at: '2026-11-16T09:00:00Z',
  }
  const typed = { party: 'designer', name: 'N. Designer', drawing: null, accepted_at: '2026-11-16T10:00:00Z' }
  serve(
    given({
      'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [{ ...ORDER, signed: [drawn, typed] }] },
      'GET /v1/contracts/c1/ending': { ...GIVEN, signed: [drawn, typed] },
    }),
  )
  openApp(`/projects/p1/contracts/c1/${page}`)
  expect(await screen.findByText(/N. Designer, for the designer/)).toBeVisible()
  expect(screen.getByRole('img', { name: 'P. Producer, drawn by hand' })).toBeVisible()
  expect(screen.queryByRole('img', { name: 'N. Designer, drawn by hand' })).toBeNull()
  expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
})

test('the caps of hours are set where the contract pays by the hour, and what stays is not sent', async () => {
  const caps = { hours_cap: 5, hours_month_cap: 4, days_cap: null }
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [], caps } }))
  answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  answers['POST /v1/contracts/c1/change-orders'] = ORDERS
  openApp('/projects/p1/contracts/c1/changes')
  await userEvent.selectOptions(await screen.findByLabelText('Change'), 'Set the caps of hours or days')
  expect(screen.getByLabelText('Hours at most in a month')).toHaveValue('4')
  expect(screen.queryByLabelText('Days at most in all')).toBeNull()
  const add = screen.getByRole('button', { name: 'Add this change' })
  expect(add).toBeDisabled()
  const inAll = screen.getByLabelText('Hours at most in all')
  await userEvent.clear(inAll)
  await userEvent.type(inAll, '8')
  await userEvent.click(add)
  await userEvent.type(screen.getByLabelText('Reason'), 'More sessions')
  await userEvent.click(screen.getByRole('button', { name: 'Propose' }))
  expect(await screen.findByRole('region', { name: 'Change order 1' })).toBeVisible()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toMatchObject({
    changes: [{ kind: 'set_caps', hours_cap: 8 }],
  })
})

test('a contract that pays neither by the hour nor by the day offers no caps', async () => {
  serve(given({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [] } }))
  openApp('/projects/p1/contracts/c1/changes')
  const kinds = await screen.findByLabelText('Change')
  expect(within(kinds).queryByRole('option', { name: 'Set the caps of hours or days' })).toBeNull()
})

const ANEW = {
  offer: 'described:mine_arm:7',
  kind: 'described',
  text: 'SW-001 mine_arm changed after work on it began: length 2 s instead of 0.8 s.',
  who: 'Producer',
  at: '2026-11-16T09:00:00Z',
  change: { kind: 'reprice_cue', cue_id: 'mine_arm', milestone_id: null, text: '', due_on: null },
  dismissed: null,
}
const ROUND = {
  ...ANEW,
  offer: 'round:mine_arm:3',
  kind: 'round',
  text: 'Round 3 of SW-001 mine_arm was sent; the price includes 2.',
  change: { ...ANEW.change, kind: 'add_round' },
  dismissed: { party: 'studio', by: 'Producer', at: '2026-11-17T09:00:00Z', reason: 'It was our mistake' },
}
const OFFERED = { ...ORDERS, orders: [], offers: [ANEW, ROUND] }
const offerOf = async (text: string) => {
  const card = await screen.findByRole('region', { name: 'Something changed since you signed' })
  const found = within(card)
    .getAllByRole('listitem')
    .find((row) => row.textContent.includes(text))
  if (!found) throw new Error(`no offer says ${text}`)
  return found
}

test('what changed since the signature begins a change order, which names the price that is asked', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/change-orders': OFFERED }))
  answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  answers['POST /v1/contracts/c1/change-orders'] = ORDERS
  openApp('/projects/p1/contracts/c1/changes')
  const offer = await offerOf('changed after work')
  expect(offer).toHaveTextContent('Producer')
  expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
  await userEvent.click(within(offer).getByRole('button', { name: 'Propose a change order' }))
  const price = await screen.findByLabelText('Price in USD')
  expect(price).toHaveFocus()
  expect(screen.getByLabelText('Change')).toHaveValue('reprice_cue')
  expect(screen.getByLabelText('Cue')).toHaveValue('mine_arm')
  expect(screen.getByLabelText('Reason')).toHaveValue(ANEW.text)
  await userEvent.type(price, '225')
  await userEvent.click(screen.getByRole('button', { name: 'Add this change' }))
  await userEvent.click(screen.getByRole('button', { name: 'Propose' }))
  expect(await screen.findByRole('region', { name: 'Change order 1' })).toBeVisible()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
    reason: ANEW.text,
    begins_at_once: false,
    changes: [{ kind: 'reprice_cue', cue_id: 'mine_arm', price_minor: 22_500 }],
    offers: [ANEW.offer],
  })
})

test('an offer that says all is looked at at once; what was typed stays, and a removed change takes its offer along', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/change-orders': OFFERED }))
  answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  answers['POST /v1/contracts/c1/change-orders'] = ORDERS
  openApp('/projects/p1/contracts/c1/changes')
  await userEvent.type(await screen.findByLabelText('Reason'), 'As we said.')
  const offer = await offerOf('Round 3')
  expect(offer).toHaveTextContent('Producer, for the studio, wants no change order for it')
  expect(offer).toHaveTextContent('It was our mistake')
  const begin = within(offer).getByRole('button', { name: 'Propose a change order' })
  await userEvent.click(begin)
  expect(await screen.findByText('SW-025 shield_down is added to Beta at USD 225.00.')).toBeVisible()
  expect(screen.getByLabelText('Reason')).toHaveValue(`As we said. ${ROUND.text}`)
  await userEvent.click(screen.getByRole('button', { name: 'Remove the last change' }))
  expect(screen.getByRole('button', { name: 'Propose' })).toBeDisabled()
  await userEvent.click(begin)
  await userEvent.click(begin)
  await userEvent.click(screen.getByRole('button', { name: 'Propose' }))
  await screen.findByRole('region', { name: 'Change order 1' })
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
    reason: `As we said. ${ROUND.text}`,
    begins_at_once: false,
    changes: [{ kind: 'add_round', cue_id: 'mine_arm' }],
    offers: [ROUND.offer],
  })
})

test('an offer is dismissed with a reason', async () => {
  const { asked, answers } = serve(given({ 'GET /v1/contracts/c1/change-orders': OFFERED }))
  const path = 'POST /v1/contracts/c1/change-offers/dismiss'
  answers[path] = refusal(409, 'offer-settled', 'this is offered no more')
  openApp('/projects/p1/contracts/c1/changes')
  const offer = await offerOf('changed after work')
  await userEvent.click(within(offer).getByRole('button', { name: 'Dismiss' }))
  const send = within(offer).getByRole('button', { name: 'Dismiss with this reason' })
  expect(send).toBeDisabled()
  await userEvent.type(within(offer).getByLabelText('Why no change order is needed'), 'It is no more work')
  await userEvent.click(send)
  expect(await screen.findByText('This is offered no more.')).toBeVisible()
  answers[path] = { ...OFFERED, offers: [] }
  await userEvent.click(send)
  expect(await screen.findByText('Dismissed. The record keeps the reason.')).toBeVisible()
  expect(screen.queryByRole('region', { name: 'Something changed since you signed' })).toBeNull()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
    offer: ANEW.offer,
    reason: 'It is no more work',
  })
})

const CONTRACT = {
  id: 'c1',
  project_id: 'p1',
  title: 'Effects for Alpha',
  kind: 'single',
  state: 'agreed',
  designer: ME,
  studio_name: 'Shield Wing studio',
  agreed_at: '2026-11-10T09:00:00Z',
  my_party: 'designer',
  waits_for: [],
  version: { number: 1, blocks: [], clauses: [], text_sha256: SHA },
  acceptances: [],
  signers: [],
  change_requested: null,
  redlines: null,
  may: {},
}

test.each([
  ['a party', true, 1],
  ['somebody else', false, 0],
])('the page of a contract, read by %s (may amend: %s), has %i notes of what changed', async (_, amend, notes) => {
  serve(
    given({
      'GET /v1/contracts/c1': { ...CONTRACT, may: { ...CONTRACT.may, amend } },
      'GET /v1/contracts/c1/change-orders': OFFERED,
    }),
  )
  openApp('/projects/p1/contracts/c1')
  await screen.findByRole('heading', { level: 1, name: 'Effects for Alpha' })
  const links = notes
    ? [await screen.findByRole('link', { name: 'What changed' })]
    : screen.queryAllByText(/changed since you signed/)
  expect(links.map((link) => link.getAttribute('href'))).toEqual(
    Array.from({ length: notes }, () => '/projects/p1/contracts/c1/changes'),
  )
  if (notes) expect(screen.getByText('2 things changed since you signed. A change order can say so.')).toBeVisible()
})
