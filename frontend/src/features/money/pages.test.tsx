import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test } from 'vitest'

import type { MilestoneSheet } from '@/money/api'
import { keptDraft } from '@/app/drafts'
import { openApp } from '@/test/openApp'
import { aMe, aServer, PROJECT } from '@/test/review'
import { refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./MilestonePage'), import('./PlanPage')]))

const PING = { id: 'ping', label: 'SW-005', name: 'radar_ping' }
const OATH = { id: 'oath', label: 'SW-020', name: 'vo_oath' }
const HABIT = { pairs: 0, mean_percent: null, spread_points: null, habit: 'unknown' as const }

const share = { price_minor: null, amount_minor: 15_000, estimate_min: 60, accepted_at: null, cut_in: null }
const ping = { ...share, cue: PING, owed_minor: 15_000, paid_minor: 0, accepted_at: '2026-11-20T10:00:00Z' }
const oath = { ...share, cue: OATH, owed_minor: 0, paid_minor: 0 }

function aSheet(more: Partial<MilestoneSheet> = {}): MilestoneSheet {
  const slip = { milestone_id: 'alpha', name: 'Alpha', due_on: '2026-11-16', days: 4, designer_days: 1, studio_days: 3 }
  const before = { ...slip, milestone_id: 'palette', name: 'Palette', days: 2, designer_days: 2, studio_days: 0 }
  return {
    project_id: PROJECT,
    contract_id: 'effects',
    contract_title: 'Effects',
    contract_state: 'agreed',
    designer: { id: 'designer', name: 'Sound designer' },
    currency: 'USD',
    release: 'per_cue',
    milestone: {
      id: 'alpha',
      name: 'Alpha',
      is_deposit: false,
      amount_minor: 30_000,
      left_minor: 30_000,
      owed_minor: 15_000,
      paid_minor: 0,
      due_on: '2026-11-16',
      tax_bp: null,
      accepted: 1,
      wanted: 2,
      done_at: null,
      cues: [ping, oath],
    },
    cues: [
      { ...ping, status: 'accepted' },
      { ...oath, status: 'to_review' },
    ],
    blocked_by: [],
    slip,
    slips: [before, slip],
    slip_growth_days: 2,
    estimates: {
      cues: [
        { about_id: 'ping', name: 'radar_ping', estimate: 60, so_far: 90, actual: 90, error_percent: 50 },
        { about_id: 'elsewhere', name: 'dock_clamp', estimate: 60, so_far: 0, actual: null, error_percent: null },
      ],
      milestones: [],
      cue_habit: HABIT,
      milestone_habit: HABIT,
      forecasts: [],
      warning: null,
    },
    lines: [],
    invoices: [],
    ...more,
  }
}

let server: ReturnType<typeof aServer>
const faults = async () => {
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  return violations.map(({ id, nodes }) => [id, nodes[0]?.html])
}

beforeEach(() => {
  server = aServer()
    .on('GET /v1/me', aMe({ is_producer: true }))
    .on('GET /v1/review-queue/count', { cues: 0, is_all: true })
})

describe('the page of a milestone', () => {
  const opened = async (sheet = aSheet()) => {
    server.on('GET /v1/milestones/alpha', sheet)
    openApp(`/projects/${PROJECT}/milestones/alpha`)
    await screen.findByRole('heading', { level: 1, name: 'Alpha' })
  }

  test('shows each cue with state and share, and leads to what waits for a verdict; axe finds nothing', async () => {
    await opened()
    const cues = within(screen.getByRole('region', { name: 'Cues' }))
    const [first, second] = cues.getAllByRole('listitem')
    expect(first).toHaveTextContent('SW-005radar_pingAccepted150.00 due')
    expect(second).toHaveTextContent('150.00')
    expect(cues.getByRole('link', { name: 'Review vo_oath' })).toHaveAttribute(
      'href',
      `/projects/${PROJECT}/review/oath`,
    )
    expect(within(screen.getByRole('region', { name: 'Due to the designer' })).getByText('$150.00')).toBeVisible()
    expect(await faults()).toEqual([])
  })

  test('splits late days, with their trend', async () => {
    await opened()
    const late = within(screen.getByRole('region', { name: 'Late' }))
    expect(late.getByText('4 days late: 1 with the designer, 3 with you.')).toBeVisible()
    expect(late.getByRole('row', { name: 'Palette 2 days 2 0' })).toBeVisible()
    expect(late.getByText('Each milestone is 2.0 days later than the one before.')).toBeVisible()
  })

  test('holds its own cues’ estimates against the time logged', async () => {
    await opened()
    const estimates = within(screen.getByRole('region', { name: 'Estimates' }))
    expect(estimates.getByText('1 h, logged 1 h 30 min, +50 %')).toBeVisible()
    expect(estimates.queryByText('dock_clamp')).toBeNull()
    expect(estimates.queryByRole('form')).toBeNull()
  })

  test('shows an audio lead neither lateness nor estimates', async () => {
    await opened(aSheet({ slip: null, slips: [], slip_growth_days: null, estimates: null }))
    expect(screen.queryByRole('region', { name: 'Late' })).toBeNull()
    expect(screen.queryByRole('region', { name: 'Estimates' })).toBeNull()
  })

  test('lets its designer log time on a cue', async () => {
    server
      .on('GET /v1/me', aMe({ part: 'designer', is_liaison: false, is_approver: false }))
      .on('POST /v1/contracts/effects/work-logs', () =>
        refusal(422, 'not-agreed', 'time is logged once both have agreed'),
      )
    await opened()
    const form = within(await screen.findByRole('form', { name: 'Log time' }))
    await userEvent.click(form.getByRole('button', { name: 'Log time' }))
    expect(form.getByText('Enter minutes.')).toBeVisible()
    await userEvent.selectOptions(form.getByLabelText('Cue'), 'vo_oath')
    await userEvent.type(form.getByLabelText('Minutes'), '45')
    await userEvent.click(form.getByRole('button', { name: 'Log time' }))
    expect(await form.findByRole('alert')).toHaveTextContent('Time is logged once both have agreed')
    expect(server.of('POST /v1/contracts/effects/work-logs')[0]?.body).toMatchObject({ cue_id: 'oath', minutes: 45 })
  })

  test('that is not there says so', async () => {
    openApp(`/projects/${PROJECT}/milestones/elsewhere`)
    expect(await screen.findByRole('heading', { level: 1, name: /not|nothing|nobody/i })).toBeVisible()
  })
})

describe('the plan of a draft', () => {
  const CONTRACT = {
    id: 'effects',
    title: 'Effects',
    currency: 'USD',
    state: 'draft',
    may: { change: true },
    version: { terms: { price_mode: 'flat' }, clauses: [] as { key: string; stands: boolean }[] },
  }
  const CHECK = 'POST /v1/contracts/effects/plan-check'
  const SAVE = 'PUT /v1/contracts/effects/milestones'
  const type = (field: HTMLElement, value: string) => fireEvent.change(field, { target: { value } })
  const opened = async () => {
    openApp(`/projects/${PROJECT}/contracts/effects/plan`)
    await screen.findByRole('heading', { level: 1, name: 'Plan: Effects' })
  }

  test('says what hours and a retainer pay beside it', async () => {
    const terms = { hour_rate_minor: 6_000, hours_cap: 20, retainer_minor: 90_000, retainer_months: 6 }
    const clauses = ['hours', 'retainer'].map((key) => ({ key, stands: true }))
    server.on('GET /v1/contracts/effects', { ...CONTRACT, version: { terms, clauses } })
    await opened()
    expect(
      screen.getByText(
        'Beside the milestones this contract pays a retainer of $900.00 for each of 6 months and work at $60.00 an hour, up to 20 hours.',
      ),
    ).toBeVisible()
  })

  beforeEach(() => {
    server
      .on('GET /v1/contracts/effects', CONTRACT)
      .on('GET /v1/contracts/effects/milestones', {
        contract_id: 'effects',
        currency: 'USD',
        milestones: [],
        advice: [],
      })
      .on(`GET /v1/projects/${PROJECT}/sound-list`, {
        revision: 1,
        next: null,
        cues: [PING, OATH].map((cue) => ({ ...cue, category: 'ui', state: 'locked' })),
      })
      .on(CHECK, {
        faults: [{ where: 'milestones.0', message: 'the cues of Alpha add up to $1.00' }],
        advice: [{ code: 'one-milestone', message: 'All is paid for Alpha alone.', why: 'Neither side sees early.' }],
        price: {
          total_minor: 30_000,
          deposit_minor: 0,
          bid_minor: 639_000,
          bid_currency: 'USD',
          above_bid_minor: -609_000,
        },
        concepts: { count: 1, cues: 2, amount_minor: 15_000 },
      })
  })

  test('begins empty, shows warnings while it is typed, and is saved in minor units', { tags: ['slow'] }, async () => {
    server.on(SAVE, { contract_id: 'effects', currency: 'USD', milestones: [], advice: [] })
    await opened()
    expect(screen.getByRole('heading', { name: 'No milestones yet' })).toBeVisible()
    await userEvent.keyboard('n')
    const alpha = within(screen.getByRole('group', { name: 'milestone 1' }))
    expect(screen.getByRole('button', { name: 'Save plan' })).toBeDisabled()
    type(alpha.getByLabelText('Name'), 'Alpha')
    type(alpha.getByLabelText('Amount, USD'), 'x')
    expect(screen.getByText(/“x” is not an amount in USD/)).toBeVisible()
    type(alpha.getByLabelText('Amount, USD'), '300')
    await userEvent.selectOptions(screen.getByLabelText('Assign these 2 cues to'), 'Alpha')
    type(screen.getByLabelText('Hours estimated for vo_oath'), '2')
    expect(await screen.findByText('All is paid for Alpha alone.')).toBeVisible()
    expect(screen.getByText('the cues of Alpha add up to $1.00')).toBeVisible()
    expect(screen.getByText('The bid is $6,390.00: the price is $6,090.00 below it.')).toBeVisible()
    expect(screen.getByText(/^1 of 2 cues is a concept still, for \$150.00/)).toBeVisible()
    expect(await faults()).toEqual([])
    await userEvent.click(screen.getByRole('button', { name: 'Save plan' }))
    await waitFor(() => expect(server.of(SAVE)).toHaveLength(1))
    expect(server.of(SAVE)[0]?.body).toMatchObject({
      milestones: [
        {
          name: 'Alpha',
          amount_minor: 30_000,
          cues: [
            { cue_id: 'ping', price_minor: null, estimate_min: null },
            { cue_id: 'oath', price_minor: null, estimate_min: 120 },
          ],
        },
      ],
    })
  })

  test('is proposed from dates and categories in one act, and each milestone can be changed', async () => {
    const PROPOSAL = 'GET /v1/contracts/effects/milestones/proposal'
    server.on(SAVE, { contract_id: 'effects', currency: 'USD', milestones: [], advice: [] }).on(PROPOSAL, {
      milestones: [
        { name: 'Deposit', due_on: null, is_deposit: true, amount_minor: 150_000, cue_ids: [] },
        { name: 'UI', due_on: '2026-12-04', is_deposit: false, amount_minor: 225_000, cue_ids: ['ping'] },
        { name: 'Voice', due_on: null, is_deposit: false, amount_minor: 225_000, cue_ids: ['oath'] },
      ],
    })
    await opened()
    const form = within(screen.getByRole('form', { name: 'Propose milestones' }))
    type(form.getByLabelText(/^Total price/), '6,000')
    expect(await faults()).toEqual([])
    await userEvent.click(form.getByRole('button', { name: 'Propose milestones' }))
    const voice = within(await screen.findByRole('group', { name: 'Voice' }))
    expect(server.of(PROPOSAL)[0]?.query.get('total_minor')).toBe('600000')
    type(voice.getByLabelText('Date'), '2026-12-18')
    await userEvent.click(screen.getByRole('button', { name: 'Save plan' }))
    await waitFor(() => expect(server.of(SAVE)).toHaveLength(1))
    expect(server.of(SAVE)[0]?.body).toMatchObject({
      milestones: [
        { name: 'Deposit', is_deposit: true, amount_minor: 150_000, cues: [] },
        { name: 'UI', due_on: '2026-12-04', amount_minor: 225_000, cues: [{ cue_id: 'ping' }] },
        { name: 'Voice', due_on: '2026-12-18', amount_minor: 225_000, cues: [{ cue_id: 'oath' }] },
      ],
    })
  })

  test('asks before it is left with something typed; what was typed is kept', { tags: ['slow'] }, async () => {
    const app = openApp(`/projects/${PROJECT}/contracts/effects/plan`)
    await screen.findByRole('heading', { level: 1, name: 'Plan: Effects' })
    await userEvent.keyboard('n')
    type(within(screen.getByRole('group', { name: 'milestone 1' })).getByLabelText('Name'), 'Alpha')
    const path = app.at()
    const away = screen.getAllByRole('link', { name: 'Sounds' })[0]!
    await userEvent.click(away)
    const dialog = within(await screen.findByRole('dialog', { name: 'Leave this page?' }))
    expect(await faults()).toEqual([])
    await userEvent.click(dialog.getByRole('button', { name: 'Stay' }))
    expect(app.at()).toBe(path)
    expect(screen.getByRole('group', { name: 'Alpha' })).toBeVisible()
    await userEvent.click(away)
    const again = within(await screen.findByRole('dialog', { name: 'Leave this page?' }))
    await userEvent.click(again.getByRole('button', { name: 'Leave' }))
    await waitFor(() => expect(app.at()).not.toBe(path))
    expect(JSON.stringify(keptDraft('plan:effects'))).toContain('Alpha')
  })

  test('that was agreed says where it stands', async () => {
    server.on('GET /v1/contracts/effects', { ...CONTRACT, state: 'agreed', may: { change: false } })
    openApp(`/projects/${PROJECT}/contracts/effects/plan`)
    expect(await screen.findByRole('heading', { level: 1, name: 'The plan is agreed' })).toBeVisible()
    expect(screen.getByRole('link', { name: 'Back to Effects' })).toBeVisible()
  })
})
