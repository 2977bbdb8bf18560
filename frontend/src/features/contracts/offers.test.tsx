import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { amendmentAnswers, DIFFERENCE, ME, ORDERS, SHA } from '@/test/amendments'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

const DESCRIBED = {
  offer: 'described:mine_arm:7',
  kind: 'described',
  text: 'SW-001 mine_arm changed after work on it began: length 2 s instead of 0.8 s.',
  who: 'Producer',
  at: '2026-11-16T09:00:00Z',
  change: { kind: 'reprice_cue', cue_id: 'mine_arm', milestone_id: null, text: '', due_on: null },
  dismissed: null,
}
const ROUND = {
  ...DESCRIBED,
  offer: 'round:mine_arm:3',
  kind: 'round',
  text: 'Round 3 of SW-001 mine_arm was sent; the price includes 2.',
  change: { ...DESCRIBED.change, kind: 'add_round' },
  dismissed: { party: 'studio', by: 'Producer', at: '2026-11-17T09:00:00Z', reason: 'It was our mistake' },
}
const OFFERED = { ...ORDERS, orders: [], offers: [DESCRIBED, ROUND] }
const opened = () => {
  const served = serve(amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': OFFERED }))
  served.answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  served.answers['POST /v1/contracts/c1/change-orders'] = ORDERS
  openApp('/projects/p1/contracts/c1/changes')
  return served
}
const offerOf = async (text: string) => {
  const card = await screen.findByRole('region', { name: 'Something changed since you signed' })
  const found = within(card)
    .getAllByRole('listitem')
    .find((row) => row.textContent.includes(text))
  if (!found) throw new Error(`no offer says ${text}`)
  return found
}

test(
  'what changed since the signature begins a change order, which names the price that is asked',
  { tags: ['slow'] },
  async () => {
    const { asked } = opened()
    const offer = await offerOf('changed after work')
    expect(offer).toHaveTextContent('Producer')
    expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
    await userEvent.click(within(offer).getByRole('button', { name: 'Propose a change order' }))
    const price = await screen.findByLabelText('Price in USD')
    expect(price).toHaveFocus()
    expect(screen.getByLabelText('Change')).toHaveValue('reprice_cue')
    expect(screen.getByLabelText('Cue')).toHaveValue('mine_arm')
    expect(screen.getByLabelText('Reason')).toHaveValue(DESCRIBED.text)
    await userEvent.type(price, '225')
    await userEvent.click(screen.getByRole('button', { name: 'Add this change' }))
    await userEvent.click(screen.getByRole('button', { name: 'Propose' }))
    expect(await screen.findByRole('region', { name: 'Change order 1' })).toBeVisible()
    expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
      reason: DESCRIBED.text,
      begins_at_once: false,
      changes: [{ kind: 'reprice_cue', cue_id: 'mine_arm', price_minor: 22_500 }],
      offers: [DESCRIBED.offer],
    })
  },
)

test(
  'an offer that says all is looked at at once; what was typed stays, and a removed change takes its offer along',
  { tags: ['slow'] },
  async () => {
    const { asked } = opened()
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
  },
)

test('an offer is dismissed with a reason', async () => {
  const { asked, answers } = serve(amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': OFFERED }))
  const path = 'POST /v1/contracts/c1/change-offers/dismiss'
  answers[path] = refusal(409, 'offer-settled', 'this is offered no more')
  openApp('/projects/p1/contracts/c1/changes')
  const offer = await offerOf('changed after work')
  await userEvent.click(within(offer).getByRole('button', { name: 'Dismiss' }))
  const send = within(offer).getByRole('button', { name: 'Dismiss with this reason' })
  await userEvent.click(send)
  expect(within(offer).getByText('Enter a reason.')).toBeVisible()
  await userEvent.type(within(offer).getByLabelText('Why no change order is needed'), 'It is no more work')
  await userEvent.click(send)
  expect(await screen.findByText('This is offered no more.')).toBeVisible()
  answers[path] = { ...OFFERED, offers: [] }
  await userEvent.click(send)
  expect(await screen.findByText('Dismissed. The record keeps the reason.')).toBeVisible()
  expect(screen.queryByRole('region', { name: 'Something changed since you signed' })).toBeNull()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
    offer: DESCRIBED.offer,
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
  joint: [],
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
    amendmentAnswers({
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
