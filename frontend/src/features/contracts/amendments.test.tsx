import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { amendmentAnswers, DIFFERENCE, ENDING, GIVEN, ORDER, ORDERS, SHA } from '@/test/amendments'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

test('before a notice the page is a forecast, and notice is given with a reason', async () => {
  const { asked, answers } = serve(amendmentAnswers({ 'GET /v1/contracts/c1/ending': ENDING }))
  answers['POST /v1/contracts/c1/ending/notice'] = () => (answers['GET /v1/contracts/c1/ending'] = GIVEN)
  openApp('/projects/p1/contracts/c1/ending')
  const statement = await screen.findByRole('region', { name: 'Statement' })
  const line = within(statement).getByRole('row', { name: /dock_clamp, mine_arm/ })
  expect(line).toHaveTextContent('50 %')
  expect(line).toHaveTextContent('180.00')
  expect(within(statement).getByRole('row', { name: /To pay/ })).toHaveTextContent('$595.00')
  expect(screen.getByText(/= paid 0.00 \+ to pay 595.00 \+ not owed 225.00/)).toBeVisible()
  expect(screen.getByText(/1 cue waits for approval. Accepted, they owe 45.00 more/)).toBeVisible()
  fireEvent.change(screen.getByLabelText('Reason'), { target: { value: 'The game is shelved.' } })
  await userEvent.click(screen.getByRole('button', { name: 'Give notice' }))
  expect(await screen.findByRole('button', { name: 'Withdraw the notice' })).toBeVisible()
  expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ reason: 'The game is shelved.', ends_on: null })
})

test('a statement is agreed to by its hash, under a name; a refusal is shown', async () => {
  const { asked, answers } = serve(amendmentAnswers({ 'GET /v1/contracts/c1/ending': GIVEN }))
  answers['POST /v1/contracts/c1/ending/agree'] = refusal(409, 'text-changed', 'the text was changed')
  openApp('/projects/p1/contracts/c1/ending')
  const agree = await screen.findByRole('button', { name: 'Agree to the statement' })
  expect(agree).toBeDisabled()
  fireEvent.change(screen.getByLabelText('Your full name'), { target: { value: 'N. Designer' } })
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
    amendmentAnswers({
      'GET /v1/contracts/c1/ending': { ...GIVEN, my_party: party, state, settled_at: '2026-11-18T09:00:00Z' },
    }),
  )
  openApp('/projects/p1/contracts/c1/ending')
  await screen.findByRole('region', { name: 'Settlement statement' })
  const links = screen.queryAllByRole('link', { name: 'Download handover pack' })
  expect(links.map((link) => link.getAttribute('href'))).toEqual(
    Array.from({ length: packs }, () => '/v1/contracts/c1/handover'),
  )
  expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
})

test('a change order shows what it changes, and is signed by its hash', { tags: ['slow'] }, async () => {
  const { asked, answers } = serve(amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': ORDERS }))
  answers['POST /v1/contracts/c1/change-orders/1/accept'] = { ...ORDERS, orders: [{ ...ORDER, may: {} }] }
  openApp('/projects/p1/contracts/c1/changes')
  const card = await screen.findByRole('region', { name: 'Change order 1' })
  expect(card).toHaveTextContent('23 cues → 24 cues')
  expect(card).toHaveTextContent('7,042.50 → $7,267.50 + 225.00')
  expect(card).toHaveTextContent('Beta moves up while work is added to it. Dates are missed.')
  expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
  fireEvent.change(within(card).getByLabelText('Your full name'), { target: { value: 'N. Designer' } })
  await userEvent.click(within(card).getByRole('button', { name: 'Sign change order 1' }))
  expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: 'N. Designer', text_sha256: SHA })
})

test('a change is put together, looked at and proposed', async () => {
  const { asked, answers } = serve(
    amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [] } }),
  )
  answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  answers['POST /v1/contracts/c1/change-orders'] = ORDERS
  openApp('/projects/p1/contracts/c1/changes')
  await userEvent.type(await screen.findByLabelText('Price in USD'), '225')
  await userEvent.click(screen.getByRole('button', { name: 'Add this change' }))
  expect(await screen.findByText('SW-025 shield_down is added to Beta at USD 225.00.')).toBeVisible()
  fireEvent.change(screen.getByLabelText('Reason'), { target: { value: 'The level grew' } })
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
    amendmentAnswers({
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
  const { asked, answers } = serve(
    amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [], caps } }),
  )
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
  fireEvent.change(screen.getByLabelText('Reason'), { target: { value: 'More sessions' } })
  await userEvent.click(screen.getByRole('button', { name: 'Propose' }))
  expect(await screen.findByRole('region', { name: 'Change order 1' })).toBeVisible()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toMatchObject({
    changes: [{ kind: 'set_caps', hours_cap: 8 }],
  })
})

test('what is typed and not added keeps the order from being proposed without it', async () => {
  const { answers } = serve(amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [] } }))
  answers['POST /v1/contracts/c1/change-order-preview'] = { difference: DIFFERENCE, problems: [] }
  openApp('/projects/p1/contracts/c1/changes')
  const price = await screen.findByLabelText('Price in USD')
  fireEvent.change(price, { target: { value: '225' } })
  await userEvent.click(screen.getByRole('button', { name: 'Add this change' }))
  fireEvent.change(screen.getByLabelText('Reason'), { target: { value: 'The level grew' } })
  const propose = screen.getByRole('button', { name: 'Propose' })
  await waitFor(() => expect(propose).toBeEnabled())
  fireEvent.change(price, { target: { value: '90' } })
  expect(propose).toBeDisabled()
  expect(screen.getByText(/^A change is typed above and not added\./)).toBeVisible()
  fireEvent.change(price, { target: { value: '' } })
  await waitFor(() => expect(propose).toBeEnabled())
})

test('a contract that pays neither by the hour nor by the day offers no caps', async () => {
  serve(amendmentAnswers({ 'GET /v1/contracts/c1/change-orders': { ...ORDERS, orders: [] } }))
  openApp('/projects/p1/contracts/c1/changes')
  const kinds = await screen.findByLabelText('Change')
  expect(within(kinds).queryByRole('option', { name: 'Set the caps of hours or days' })).toBeNull()
})
