import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import type { Bonus, ContractMoney, Figures, Invoice, ProjectMoney } from '@/money/api'
import { openApp } from '@/test/openApp'
import { aMe, aServer, PROJECT } from '@/test/review'
import { answer, type Asked, refusal } from '@/test/server'

beforeAll(() => import('./MoneyPage'))

const AT = '2026-11-20T10:00:00Z'
const PING = { id: 'ping', label: 'SW-005', name: 'radar_ping' }
const LAUNCH = { id: 'launch', label: 'SW-019', name: 'missile_launch' }
const figures = (more: Partial<Figures> = {}): Figures => ({
  agreed_minor: 324_000,
  accepted_minor: 198_000,
  paid_minor: 144_000,
  due_minor: 54_000,
  open_minor: 126_000,
  saved_minor: 0,
  ...more,
})

function anInvoice(contractId: string, more: Partial<Invoice> = {}): Invoice {
  return {
    id: `invoice-${contractId}`,
    contract_id: contractId,
    number: 1,
    full_number: '1',
    currency: 'USD',
    issued_on: '2026-11-10',
    due_on: '2026-11-24',
    seller: 'Sound designer',
    buyer: 'Studio',
    po_number: '',
    note: '',
    reverse_charge: false,
    lines: [{ text: 'Deposit', amount_minor: 36_000, tax_bp: null }],
    taxes: [],
    net_minor: 36_000,
    total_minor: 36_000,
    paid_minor: 0,
    open_minor: 36_000,
    state: 'open',
    days_to_pay: null,
    late_interest_minor: 0,
    late_interest_charged_minor: 0,
    payments: [],
    ...more,
  }
}

function aContract(id: string, title: string): ContractMoney {
  return {
    contract_id: id,
    title,
    designer: { id: 'designer', name: 'Sound designer' },
    currency: 'USD',
    release: 'per_cue',
    kill_fee_in_work_bp: 5_000,
    by_day: null,
    by_hour: null,
    figures: figures(),
    milestones: [
      {
        id: `alpha-${id}`,
        name: 'Alpha',
        is_deposit: false,
        amount_minor: 180_000,
        left_minor: 126_000,
        owed_minor: 54_000,
        paid_minor: 0,
        due_on: '2026-11-23',
        tax_bp: null,
        accepted: 3,
        wanted: 10,
        done_at: null,
        cues: [],
      },
    ],
    slips: [],
    slip_growth_days: null,
    proposed_rounds: [
      {
        id: `round-${id}`,
        contract_id: id,
        cue: LAUNCH,
        number: 3,
        included: 2,
        amount_minor: 7_875,
        currency: 'USD',
        state: 'proposed',
        proposed_at: AT,
      },
    ],
    billable_minor: 18_000,
    next_invoice: 2,
    open_invoices: [],
    last_days_to_pay: null,
  }
}

const LINE = {
  id: 'line-1',
  at: AT,
  kind: 'accepted',
  amount_minor: 18_000,
  clause: 'payment_plan',
  cue: PING,
  milestone: 'Alpha',
  round_number: null,
  tax_bp: null,
  by: 'Audio director',
  about_id: null,
  invoice_number: null,
  reference: null,
}
const HABIT = { pairs: 3, mean_percent: 12.5, spread_points: 4, habit: 'steady' }
const DRAFT = {
  number: 2,
  full_number: 'INV-2026-015',
  number_advice: '',
  is_number_taken: false,
  currency: 'USD',
  seller: 'Sound designer',
  buyer: 'Studio',
  po_number: '',
  payment_days: 14,
  reverse_charge: false,
  lines: [{ text: 'radar_ping, Alpha', amount_minor: 18_000, tax_bp: null }],
  taxes: [{ tax_bp: 1_900, amount_minor: 3_420 }],
  net_minor: 18_000,
  total_minor: 21_420,
}

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
  tell({
    contracts: [
      {
        ...aContract('effects', 'Effects'),
        by_day: { day_rate_minor: 40_000, days_cap: 10, agreed_minor: 40_000, cap_minor: 400_000 },
      },
    ],
    totals: [],
  })

let server: ReturnType<typeof aServer>
const PAGE = `/projects/${PROJECT}/money`
const tell = (money: ProjectMoney) => server.on(`GET /v1/projects/${PROJECT}/money`, money)
const opened = async () => {
  openApp(PAGE)
  await waitFor(() => expect(screen.getAllByRole('table')).toHaveLength(2))
}

beforeEach(() => {
  server = aServer()
    .on('GET /v1/me', aMe({ is_producer: true }))
    .on('GET /v1/review-queue/count', { cues: 0, is_all: true })
  for (const id of ['effects', 'creatures']) {
    server
      .on(`GET /v1/contracts/${id}/invoices`, [anInvoice(id)])
      .on(`GET /v1/contracts/${id}/invoice-draft`, DRAFT)
      .on(`GET /v1/contracts/${id}/ledger`, {
        contract_id: id,
        currency: 'USD',
        figures: figures(),
        tax_minor: 0,
        open_tax_minor: 0,
        bonus: null,
        lines: [LINE],
      })
      .on(`GET /v1/contracts/${id}/estimates`, {
        cues: [{}],
        milestones: [],
        cue_habit: HABIT,
        milestone_habit: { ...HABIT, pairs: 0, mean_percent: null, spread_points: null },
        forecasts: [{ milestone: 'Alpha', due_on: '2026-11-23', forecast_on: '2026-11-25' }],
        warning: null,
      })
  }
  tell({
    contracts: [aContract('effects', 'Effects'), aContract('creatures', 'Creatures')],
    totals: [{ currency: 'USD', figures: figures() }],
  })
})

const faults = async () => {
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  return violations.map(({ id, nodes }) => [id, nodes[0]?.html])
}

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
    expect(await effects.findByText(new RegExp(fix))).toBeVisible()
    expect(createObjectURL).not.toHaveBeenCalled()
    server.on(address, answer('%PDF'))
    await userEvent.click(button)
    await waitFor(() => expect(createObjectURL).toHaveBeenCalledOnce())
    expect(effects.queryByText(new RegExp(fix))).not.toBeInTheDocument()
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

  test('records a payment with its reference, and none without', async () => {
    server.on('POST /v1/invoices/invoice-effects/payments', anInvoice('effects'))
    await opened()
    const effects = within(screen.getByRole('region', { name: 'Effects, Sound designer' }))
    await userEvent.click(effects.getByRole('button', { name: 'Record payment on invoice 1' }))
    const form = within(effects.getByRole('form', { name: 'Payment on invoice 1, Effects' }))
    await userEvent.click(form.getByRole('button', { name: 'Record payment' }))
    expect(form.getByText('Enter the bank reference.')).toBeVisible()
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
    expect(await card.findByRole('alert')).toHaveTextContent('the 10 days agreed to are used up')
    expect(card.queryByRole('form')).toBeNull()
  })

  test('is told what a refusal says', async () => {
    server.on(`GET /v1/projects/${PROJECT}/money`, () => refusal(403, 'team-needed', 'Only the team sees this.'))
    openApp(PAGE)
    expect(await screen.findByRole('alert')).toHaveTextContent('Only the team sees this.')
  })

  test('axe finds nothing where two contracts stand below each other', async () => {
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

  test('issues the next invoice, with its tax; axe finds nothing', async () => {
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

  test('logs a day in quarters, and takes one back', async () => {
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
    tell({ contracts: [], totals: [] })
    openApp(PAGE)
    expect(await screen.findByRole('heading', { name: 'No signed contract yet' })).toBeVisible()
    expect(await faults()).toEqual([])
  })
})

describe('a bonus', () => {
  const aLedger = (bonus: Bonus) => ({
    contract_id: 'effects',
    currency: 'USD',
    figures: figures(),
    tax_minor: 0,
    open_tax_minor: 0,
    bonus,
    lines: [LINE],
  })
  const shipping: Bonus = {
    amount_minor: 30_000,
    when: 'shipped',
    state: 'possible',
    because: 'the studio has not said yet that the game has shipped',
  }
  const bonusCard = () => screen.findByRole('region', { name: 'Bonus, Effects' })

  test.each<[Bonus['state'], string, string]>([
    ['earned', 'Earned', 'every cue was accepted by the date of its milestone'],
    ['missed', 'Missed', 'SW-005 radar_ping was not accepted by 20 November 2026'],
  ])('says that it is %s, and why', async (state, word, because) => {
    server.on('GET /v1/contracts/effects/ledger', aLedger({ ...shipping, when: 'on_time', state, because }))
    await opened()
    const card = within(await bonusCard())
    expect(card.getByText('$300.00')).toBeVisible()
    expect(card.getByText(word)).toBeVisible()
    expect(card.getByText(`${because.charAt(0).toUpperCase()}${because.slice(1)}.`)).toBeVisible()
    expect(card.queryByRole('button')).toBeNull()
    expect(screen.queryByRole('region', { name: 'Bonus, Creatures' })).toBeNull()
  })

  test('a producer says when the game shipped; a refusal keeps the day', async () => {
    server.on('GET /v1/contracts/effects/ledger', aLedger(shipping))
    server.on('POST /v1/contracts/effects/shipped', refusal(422, 'day-in-future', 'that day lies ahead'))
    await opened()
    const card = within(await bonusCard())
    const field = card.getByLabelText('Shipped on')
    fireEvent.change(field, { target: { value: '2026-11-20' } })
    await userEvent.click(card.getByRole('button', { name: 'The game has shipped' }))
    expect(await card.findByText(/that day lies ahead/i)).toBeVisible()
    expect(field).toHaveValue('2026-11-20')

    const earned = aLedger({ ...shipping, state: 'earned', because: 'the game shipped on 20 November 2026' })
    server.on('POST /v1/contracts/effects/shipped', earned).on('GET /v1/contracts/effects/ledger', earned)
    await userEvent.click(card.getByRole('button', { name: 'The game has shipped' }))
    expect(await card.findByText('Earned')).toBeVisible()
    expect(await screen.findByText('The bonus of $300.00 is due.')).toBeVisible()
    expect(card.queryByRole('button')).toBeNull()
    expect(await faults()).toEqual([])
  })

  test('a designer waits for the studio, and words of their own stay the parties’', async () => {
    server.on('GET /v1/me', aMe({ part: 'designer', is_liaison: false, is_approver: false }))
    server.on('GET /v1/contracts/effects/ledger', aLedger(shipping))
    server.on(
      'GET /v1/contracts/creatures/ledger',
      aLedger({ ...shipping, when: 'other', state: null, because: 'it sells' }),
    )
    await opened()
    expect(within(await bonusCard()).queryByRole('button')).toBeNull()
    const other = within(await screen.findByRole('region', { name: 'Bonus, Creatures' }))
    expect(other.getByText('It sells.')).toBeVisible()
    expect(other.queryByText('Still possible')).toBeNull()
  })
})
