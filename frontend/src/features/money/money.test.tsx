import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { aContract, anInvoice, DRAFT, faults, opened, PAGE, serveMoney, serveMoneyPage, server } from '@/test/moneyPage'
import { openApp } from '@/test/openApp'
import { aMe, PROJECT } from '@/test/review'
import { answer, type Asked, refusal } from '@/test/server'

beforeAll(() => import('./MoneyPage'))
serveMoneyPage()

const WORKED = {
  id: 'day-1',
  worked_on: '2026-11-12',
  quarters: 2,
  minutes: null,
  cue: null,
  note: 'Servo recordings',
  state: 'waiting',
  amount_minor: 20_000,
  agreed_at: null,
  refused_at: null,
  refusal: '',
}
const byTheDay = () =>
  serveMoney({
    contracts: [
      {
        ...aContract('effects', 'Effects'),
        by_day: { day_rate_minor: 40_000, days_cap: 10, agreed_minor: 40_000, cap_minor: 400_000 },
      },
    ],
    totals: [],
  })

test.each([
  ['producer', 'You pay for accepted cues'],
  ['designer', 'You are paid for accepted cues'],
] as const)('a %s reads who pays', async (part, words) => {
  if (part === 'designer') server.on('GET /v1/me', aMe({ part, is_liaison: false, is_approver: false }))
  await opened()
  expect(screen.getByText(new RegExp(`^${words}`))).toBeVisible()
})

describe('a producer', () => {
  test('downloads an electronic invoice, and reads what it lacks and who can enter it', async () => {
    const address = 'GET /v1/invoices/invoice-effects/electronic-invoice.pdf'
    const fix = 'Sound designer enters theirs on the page Account, under Invoice details'
    server.on(address, refusal(409, 'invoice-details-missing', 'the electronic invoice lacks city', { fix }))
    const createObjectURL = vi.fn(() => 'blob:1')
    vi.stubGlobal('URL', Object.assign(URL, { createObjectURL, revokeObjectURL: vi.fn() }))
    await opened()
    const effects = within(screen.getByRole('region', { name: 'Effects, Sound designer' }))
    const button = effects.getByRole('button', { name: 'Download E-invoice 1' })
    await userEvent.click(button)
    expect(await effects.findByRole('alert')).toHaveTextContent(fix)
    expect(createObjectURL).not.toHaveBeenCalled()
    server.on(address, answer('%PDF'))
    await userEvent.click(button)
    await waitFor(() => expect(createObjectURL).toHaveBeenCalledOnce())
    expect(effects.queryByRole('alert')).not.toBeInTheDocument()
    expect(screen.getByRole('link', { name: 'Journal (CSV)' })).toHaveAttribute(
      'href',
      `/v1/projects/${PROJECT}/journal.csv`,
    )
  })

  test('reads for each contract what is due, and which cue, clause and person a line is of', async () => {
    await opened()
    const creatures = within(screen.getByRole('region', { name: 'Creatures, Sound designer' }))
    const row = creatures.getByRole('row', { name: /Accepted radar_ping/ })
    expect(row).toHaveTextContent('payment plan')
    expect(row).toHaveTextContent('Audio director')
    expect(row).toHaveTextContent('180.00')
    expect(screen.getByText('$540.00')).toBeVisible()
  })

  test('records a payment with its reference, and none without', { tags: ['slow'] }, async () => {
    server.on('POST /v1/invoices/invoice-effects/payments', anInvoice('effects'))
    await opened()
    const effects = within(screen.getByRole('region', { name: 'Effects, Sound designer' }))
    await userEvent.click(effects.getByRole('button', { name: 'Record payment on invoice 1' }))
    const form = within(effects.getByRole('form', { name: 'Payment on invoice 1, Effects' }))
    await userEvent.click(form.getByRole('button', { name: 'Record payment' }))
    expect(form.getByText('Reference is required.')).toBeVisible()
    expect(await faults()).toEqual([])
    await userEvent.type(form.getByLabelText('Reference'), 'TX 41')
    await userEvent.click(form.getByRole('button', { name: 'Record payment' }))
    await waitFor(() =>
      expect(server.of('POST /v1/invoices/invoice-effects/payments')[0]?.body).toMatchObject({
        amount_minor: 36_000,
        reference: 'TX 41',
      }),
    )
  })

  test('records what of a payment went back, and sees what of it stands', async () => {
    const paid = anInvoice('effects', {
      paid_minor: 36_000,
      open_minor: 0,
      state: 'paid',
      payments: [
        {
          id: 'p1',
          amount_minor: 36_000,
          reference: 'TX 41',
          paid_on: '2026-11-12',
          refund_of_id: null,
          left_minor: 26_000,
        },
        { id: 'p2', amount_minor: -10_000, reference: 'R 1', paid_on: '2026-11-13', refund_of_id: 'p1', left_minor: 0 },
      ],
    })
    server.on('GET /v1/contracts/effects/invoices', [paid]).on('POST /v1/payments/p1/refunds', paid)
    await opened()
    const effects = within(screen.getByRole('region', { name: 'Effects, Sound designer' }))
    expect(await effects.findByText(/TX 41, 260.00 after refunds/)).toBeVisible()
    expect(effects.queryByRole('button', { name: /refund of R 1/ })).toBeNull()
    await userEvent.click(effects.getByRole('button', { name: 'Record refund of TX 41, invoice 1' }))
    const form = within(effects.getByRole('form', { name: 'Refund of TX 41, invoice 1' }))
    const typed = form.getByLabelText('Amount, USD')
    expect(typed).toHaveFocus()
    await userEvent.clear(typed)
    await userEvent.type(typed, '60')
    expect(form.getByText('Partial: $200.00 remains.')).toBeVisible()
    await userEvent.type(form.getByLabelText('Reference'), 'R 2')
    await userEvent.click(form.getByRole('button', { name: 'Record refund' }))
    await waitFor(() =>
      expect(server.of('POST /v1/payments/p1/refunds')[0]?.body).toMatchObject({
        amount_minor: 6_000,
        reference: 'R 2',
      }),
    )
  })

  test('agrees to logged days, with what is left of the cap in view', async () => {
    byTheDay()
    server
      .on('GET /v1/contracts/effects/worked-days', [WORKED])
      .on('POST /v1/worked-days/day-1/agree', () => refusal(409, 'cap-exceeded', 'the 10 days agreed to are used up'))
    openApp(PAGE)
    const card = within(await screen.findByRole('region', { name: 'Days, Effects' }))
    expect(card.getByText(/400.00 of \$4,000.00; \$400.00 a day, 10 at most/)).toBeVisible()
    expect(await card.findByText(/half day, Servo recordings, waiting for the studio/)).toBeVisible()
    await userEvent.click(card.getByRole('button', { name: /Agree to half day on .*12 November.*, 200.00/ }))
    expect(await card.findByRole('alert')).toHaveTextContent('The 10 days agreed to are used up')
    expect(card.queryByRole('form')).toBeNull()
  })

  test('is told what a refusal says', async () => {
    server.on(`GET /v1/projects/${PROJECT}/money`, () => refusal(403, 'team-needed', 'Only the team sees this.'))
    openApp(PAGE)
    expect(await screen.findByRole('alert')).toHaveTextContent('Only the team sees this.')
  })

  test('axe finds nothing where two contracts stand below each other', { tags: ['slow'] }, async () => {
    await opened()
    expect(await faults()).toEqual([])
  })
})

test('who only reviews is told that prices are not theirs, and nothing is asked', async () => {
  server.on('GET /v1/me', aMe({ is_liaison: false, is_approver: false }))
  openApp(PAGE)
  expect(await screen.findByRole('heading', { name: /You don’t have access to money/ })).toBeVisible()
  expect(server.of(`GET /v1/projects/${PROJECT}/money`)).toHaveLength(0)
})

describe('a designer', () => {
  beforeEach(() => {
    server.on('GET /v1/me', aMe({ part: 'designer', is_liaison: false, is_approver: false }))
  })

  test('issues the next invoice, with its tax; axe finds nothing', { tags: ['slow'] }, async () => {
    server.on('POST /v1/contracts/effects/invoices', anInvoice('effects', { number: 2 }))
    await opened()
    const effects = within(screen.getByRole('region', { name: 'Effects, Sound designer' }))
    const form = within(await effects.findByRole('form', { name: 'New invoice, Effects' }))
    expect(form.getByText('Tax, 19 %')).toBeVisible()
    expect(form.getByText('$214.20')).toBeVisible()
    expect(await faults()).toEqual([])
    await userEvent.click(form.getByRole('button', { name: 'Issue invoice INV-2026-015' }))
    await waitFor(() => expect(server.of('POST /v1/contracts/effects/invoices')).toHaveLength(1))
    expect(server.of('POST /v1/contracts/effects/invoices')[0]?.body).toMatchObject({ full_number: 'INV-2026-015' })
  })

  test('numbers invoices in a series of their own; a gap is said, and a used number cannot be issued', async () => {
    server.on('GET /v1/contracts/effects/invoice-draft', ({ query }: Asked) => {
      const number = query.get('full_number')
      if (number === '15') return { ...DRAFT, full_number: '15', number_advice: '13 to 14 are left out.' }
      if (number !== '12') return DRAFT
      return { ...DRAFT, number_advice: 'You have issued an invoice 12 already.', is_number_taken: true }
    })
    await opened()
    const effects = within(screen.getByRole('region', { name: 'Effects, Sound designer' }))
    const form = within(await effects.findByRole('form', { name: 'New invoice, Effects' }))
    const number = form.getByLabelText('Invoice number')
    expect(number).toHaveValue('INV-2026-015')
    await userEvent.clear(number)
    await userEvent.type(number, '15')
    expect(await form.findByText('13 to 14 are left out.')).toBeVisible()
    expect(form.getByRole('button', { name: 'Issue invoice 15' })).toBeEnabled()
    await userEvent.clear(number)
    await userEvent.type(number, '12')
    expect(await form.findByText('You have issued an invoice 12 already.')).toBeVisible()
    expect(form.getByRole('button', { name: 'Issue invoice 12' })).toBeDisabled()
  })

  test('logs a day in quarters, and takes one back', { tags: ['slow'] }, async () => {
    byTheDay()
    server
      .on('GET /v1/contracts/effects/worked-days', [WORKED])
      .on('POST /v1/contracts/effects/worked-days', WORKED)
      .on('DELETE /v1/worked-days/day-1', answer(null, 204))
    openApp(PAGE)
    const card = within(await screen.findByRole('region', { name: 'Days, Effects' }))
    const form = within(card.getByRole('form', { name: 'Log a day, Effects' }))
    await userEvent.selectOptions(form.getByLabelText('How much'), 'Three quarters of a day')
    await userEvent.type(form.getByLabelText('Description'), 'Doors')
    await userEvent.click(form.getByRole('button', { name: 'Log day' }))
    await waitFor(() =>
      expect(server.of('POST /v1/contracts/effects/worked-days')[0]?.body).toMatchObject({
        quarters: 3,
        note: 'Doors',
      }),
    )
    await userEvent.click(await card.findByRole('button', { name: /^Remove half day on .*12 November/ }))
    await waitFor(() => expect(server.of('DELETE /v1/worked-days/day-1')).toHaveLength(1))
    expect(await faults()).toEqual([])
  })

  test('is told where nothing is agreed yet; axe finds nothing', async () => {
    serveMoney({ contracts: [], totals: [] })
    openApp(PAGE)
    expect(await screen.findByRole('heading', { name: 'No signed contract yet' })).toBeVisible()
    expect(await faults()).toEqual([])
  })
})
