import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test } from 'vitest'

import type { ContractMoney, Hours, WorkedDay } from '@/money/api'
import { openApp } from '@/test/openApp'
import { aMe, aServer, PROJECT } from '@/test/review'
import { refusal } from '@/test/server'

beforeAll(() => import('./MoneyPage'))

const PAGE = `/projects/${PROJECT}/money`
const FIGURES = {
  agreed_minor: 40_000,
  accepted_minor: 0,
  paid_minor: 0,
  due_minor: 0,
  open_minor: 40_000,
  saved_minor: 0,
}
const TERMS: Hours = {
  rate_minor: 6_000,
  cap_min: 300,
  month_cap_min: 240,
  paid_min: 60,
  retainer_minor: 90_000,
  included_min: 120,
  retainer_months: 3,
  months: [{ number: 1, begins_on: '2026-11-02', is_retained: true, approved_min: 180, waiting_min: 90, left_min: 90 }],
}
const CONTRACT: ContractMoney = {
  contract_id: 'effects',
  title: 'Effects',
  designer: { id: 'designer', name: 'Sound designer' },
  currency: 'USD',
  release: 'per_cue',
  kill_fee_in_work_bp: 5_000,
  by_day: null,
  by_hour: TERMS,
  figures: FIGURES,
  milestones: [],
  slips: [],
  slip_growth_days: null,
  proposed_rounds: [],
  billable_minor: 0,
  next_invoice: 1,
  open_invoices: [],
  last_days_to_pay: null,
}
const WAITING: WorkedDay = {
  id: 'entry-1',
  worked_on: '2026-11-12',
  quarters: null,
  minutes: 90,
  cue: { id: 'ping', label: 'SW-005', name: 'radar_ping' },
  note: 'Directing',
  state: 'waiting',
  amount_minor: 9_000,
  agreed_at: null,
  refused_at: null,
  refusal: '',
}
const REFUSED: WorkedDay = {
  ...WAITING,
  state: 'refused',
  refused_at: '2026-11-13T10:00:00Z',
  refusal: 'It was cancelled.',
}

let server: ReturnType<typeof aServer>
const DAYS = 'GET /v1/contracts/effects/worked-days'
const opened = async () => {
  openApp(PAGE)
  return within(await screen.findByRole('region', { name: 'Hours, Effects' }))
}
const faults = async () => {
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  return violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`)
}

beforeEach(() => {
  server = aServer()
    .on('GET /v1/me', aMe({ is_producer: true }))
    .on('GET /v1/review-queue/count', { cues: 0, is_all: true })
    .on(`GET /v1/projects/${PROJECT}/money`, { contracts: [CONTRACT], totals: [] })
    .on('GET /v1/contracts/effects/invoices', [])
    .on('GET /v1/contracts/effects/invoice-draft', () => refusal(409, 'nothing-to-invoice', 'nothing is due'))
    .on('GET /v1/contracts/effects/ledger', {
      contract_id: 'effects',
      currency: 'USD',
      figures: FIGURES,
      tax_minor: 0,
      open_tax_minor: 0,
      bonus: null,
      lines: [],
    })
    .on('GET /v1/contracts/effects/estimates', () => refusal(404, 'contract-not-found', 'no estimates'))
    .on(`GET /v1/projects/${PROJECT}/sound-list`, {
      revision: 1,
      cues: [{ id: 'ping', label: 'SW-005', name: 'radar_ping', state: 'wanted', category: '' }],
      next: null,
    })
    .on(DAYS, [WAITING])
})

describe('a producer', () => {
  test('reads terms and months, and agrees to hours; axe finds nothing', async () => {
    server.on('POST /v1/worked-days/entry-1/agree', { ...WAITING, state: 'agreed' })
    const card = await opened()
    expect(
      card.getByText(
        '$900.00 a month for 3 months with 2 h; $60.00 an hour, 4 h a month and 5 h in all at most, 1 h used',
      ),
    ).toBeVisible()
    const months = within(card.getByRole('region', { name: 'Hours by month, Effects' }))
    expect(months.getAllByRole('cell').map(({ textContent }) => textContent)).toEqual([
      '3 h',
      '1 h 30 min',
      '1 h 30 min',
    ])
    expect(await card.findByText(/1 h 30 min, radar_ping, Directing, waiting for the studio/)).toBeVisible()
    expect(await faults()).toEqual([])
    await userEvent.click(card.getByRole('button', { name: /Agree to 1 h 30 min on .*12 November.*, 90.00/ }))
    await waitFor(() => expect(server.of('POST /v1/worked-days/entry-1/agree')).toHaveLength(1))
    expect(card.queryByRole('form')).toBeNull()
  })

  test('refuses hours with words, and only with words', async () => {
    server.on('POST /v1/worked-days/entry-1/refuse', REFUSED)
    const card = await opened()
    await userEvent.click(await card.findByRole('button', { name: /^Refuse 1 h 30 min/ }))
    const form = within(card.getByRole('form', { name: /^Refuse 1 h 30 min/ }))
    await userEvent.click(form.getByRole('button', { name: 'Refuse' }))
    expect(form.getByLabelText('Why')).toHaveAccessibleDescription(/Say why\./)
    expect(server.of('POST /v1/worked-days/entry-1/refuse')).toHaveLength(0)
    await userEvent.type(form.getByLabelText('Why'), 'It was cancelled.')
    expect(await faults()).toEqual([])
    await userEvent.click(form.getByRole('button', { name: 'Refuse' }))
    await waitFor(() =>
      expect(server.of('POST /v1/worked-days/entry-1/refuse')[0]?.body).toEqual({ reason: 'It was cancelled.' }),
    )
  })
})

describe('a designer', () => {
  beforeEach(() => {
    server.on('GET /v1/me', aMe({ part: 'designer', is_liaison: false, is_approver: false }))
  })

  test('logs hours on a cue; a refusal names the way out, and nothing typed is lost', async () => {
    server.on('POST /v1/contracts/effects/worked-days', () =>
      refusal(409, 'cap-exceeded', '2 h on 2026-11-12 is more than the contract pays for'),
    )
    const card = await opened()
    const form = within(card.getByRole('form', { name: 'Log hours, Effects' }))
    await userEvent.click(form.getByRole('button', { name: 'Log hours' }))
    expect(form.getByLabelText('Hours')).toHaveAccessibleDescription(/Enter hours as in 1\.5/)
    await userEvent.type(form.getByLabelText('Hours'), '2')
    await userEvent.click(form.getByRole('button', { name: 'Log hours' }))
    expect(form.getByLabelText('Work')).toHaveAccessibleDescription(/Choose a cue, or say/)
    expect(server.of('POST /v1/contracts/effects/worked-days')).toHaveLength(0)
    await userEvent.selectOptions(form.getByLabelText('Cue'), 'SW-005 radar_ping')
    await userEvent.click(form.getByRole('button', { name: 'Log hours' }))
    expect(await form.findByText('2 h on 2026-11-12 is more than the contract pays for.')).toBeVisible()
    expect(server.of('POST /v1/contracts/effects/worked-days')[0]?.body).toMatchObject({ minutes: 120, cue_id: 'ping' })
    expect(form.getByLabelText('Hours')).toHaveValue('2')
    expect(await faults()).toEqual([])
  })

  test('reads why hours were refused, corrects them and sends them again', async () => {
    server.on(DAYS, [REFUSED]).on('PUT /v1/worked-days/entry-1', WAITING)
    const card = await opened()
    expect(
      await card.findByText(/The studio refused it: It was cancelled\. Correct it to send it again\./),
    ).toBeVisible()
    await userEvent.click(card.getByRole('button', { name: /^Correct 1 h 30 min/ }))
    const form = within(card.getByRole('form', { name: /^Correct hours on .*12 November/ }))
    expect(form.getByLabelText('Hours')).toHaveValue('1 h 30 min')
    await userEvent.clear(form.getByLabelText('Hours'))
    await userEvent.type(form.getByLabelText('Hours'), '0:45')
    await userEvent.click(form.getByRole('button', { name: 'Send again' }))
    await waitFor(() =>
      expect(server.of('PUT /v1/worked-days/entry-1')[0]?.body).toEqual({
        worked_on: '2026-11-12',
        minutes: 45,
        cue_id: 'ping',
        note: 'Directing',
      }),
    )
    expect(await card.findByRole('form', { name: 'Log hours, Effects' })).toBeVisible()
  })
})
