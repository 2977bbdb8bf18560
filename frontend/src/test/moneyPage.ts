import { screen, waitFor } from '@testing-library/react'
import axe from 'axe-core'
import { beforeEach, expect } from 'vitest'

import type { ContractMoney, Figures, Invoice, ProjectMoney } from '@/money/api'

import { openApp } from './openApp'
import { aMe, aServer, PROJECT } from './review'

const AT = '2026-11-20T10:00:00Z'
const PING = { id: 'ping', label: 'SW-005', name: 'radar_ping' }
const LAUNCH = { id: 'launch', label: 'SW-019', name: 'missile_launch' }
export const figures = (more: Partial<Figures> = {}): Figures => ({
  agreed_minor: 324_000,
  accepted_minor: 198_000,
  paid_minor: 144_000,
  due_minor: 54_000,
  open_minor: 126_000,
  saved_minor: 0,
  ...more,
})

export function anInvoice(contractId: string, more: Partial<Invoice> = {}): Invoice {
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

export function aContract(id: string, title: string): ContractMoney {
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

export const LINE = {
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
export const DRAFT = {
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

export let server: ReturnType<typeof aServer>
export const PAGE = `/projects/${PROJECT}/money`
export const serveMoney = (money: ProjectMoney) => server.on(`GET /v1/projects/${PROJECT}/money`, money)
export const opened = async () => {
  openApp(PAGE)
  await waitFor(() => expect(screen.getAllByRole('table')).toHaveLength(2))
}

/** Before each test: a server with two contracts as a producer reads them. */
export function serveMoneyPage() {
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
    serveMoney({
      contracts: [aContract('effects', 'Effects'), aContract('creatures', 'Creatures')],
      totals: [{ currency: 'USD', figures: figures() }],
    })
  })
}

export const faults = async () => {
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  return violations.map(({ id, nodes }) => [id, nodes[0]?.html])
}
