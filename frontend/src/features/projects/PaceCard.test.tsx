import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aPace, inProject } from '@/test/project'
import { serve, wrote } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

const COSTS = {
  currency: 'USD',
  budget_minor: 30_000,
  committed_minor: 37_500,
  spent_minor: 27_500,
  paid_minor: 10_000,
  due_minor: 17_500,
  kept: 2,
  per_kept_minor: 13_750,
  to_finish_minor: 10_000,
  ordered: 4,
  churned: 2,
  churn: 0.5,
  churned_minor: 20_000,
}

const valueOf = (card: HTMLElement, word: string) => within(card).getByText(word).nextElementSibling

test('what both sides had better talk about stands out, with the figures', async () => {
  serve({
    ...inProject(),
    'GET /v1/projects/p1/pace': aPace({
      accepted: 1,
      first_pass: 0.75,
      first_pass_lately: 0.5,
      first_pass_before: 1,
      rounds_per_cue: 1.5,
      days_late: 2,
      overdue: 1,
      finish_on: '2026-12-09',
      needed_on: '2026-12-05',
      worn: [{ cue_id: 'c1', label: 'SW-001', name: 'shield_hit', rounds: 4 }],
      studio: {
        review_hours: 70,
        waiting_reviews: 3,
        longest_review_wait_hours: 100,
        answer_hours: 3,
        open_questions: 1,
        longest_answer_wait_hours: 1 / 60,
        days_to_pay: 12,
        late_invoices: 1,
      },
      costs: [COSTS, { ...COSTS, currency: 'EUR', budget_minor: null, churn: null }],
      estimates: { cues: 3, estimated_min: 300, logged_min: 390, error_percent: 30 },
      over_estimate: { cues: 1, over_min: 90 },
    }),
  })
  openApp('/projects/p1/progress')
  const card = await screen.findByRole('region', { name: 'Pace' })
  expect(await within(card).findByText('75 %; 50 % in four weeks, 100 % before')).toHaveClass('tone-warn')
  expect(valueOf(card, 'Against the due day')).toHaveTextContent('2 days late')
  expect(valueOf(card, 'Done at this pace')).toHaveTextContent('9 December; needed by 5 December')
  expect(valueOf(card, 'Time to a verdict')).toHaveTextContent('3 days')
  expect(valueOf(card, 'Time to an answer')).toHaveTextContent('3 hours')
  expect(valueOf(card, 'Waiting for a verdict')).toHaveTextContent('3 versions, the longest for 4 days')
  expect(valueOf(card, 'Waiting for an answer')).toHaveTextContent('1 question, for 1 min')
  expect(valueOf(card, 'Time to pay')).toHaveTextContent('12 days')
  expect(valueOf(card, 'Over estimate already')).toHaveTextContent('1 open cue by 1 h 30 min')
  expect(within(card).getByText('$300.00; $75.00 over')).toHaveClass('tone-warn')
  expect(within(card).getByText('$275.00; $175.00 due')).toBeVisible()
  expect(within(card).getByText('$137.50; 2 kept')).toBeVisible()
  expect(within(card).getByText('50 %, 2 of 4 cues; $200.00')).toHaveClass('tone-warn')
  expect(within(card).getByText('€375.00')).toBeVisible()
  expect(within(card).getAllByText('Budget')).toHaveLength(1)
  expect(valueOf(card, 'Against estimates')).toHaveTextContent('30 % longer')
  expect(valueOf(card, 'Logged, estimated')).toHaveTextContent('6 h 30 min, 5 h; 3 cues')
  expect(within(card).getByRole('link', { name: 'SW-001 shield_hit' })).toHaveAttribute(
    'href',
    '/projects/p1/sound-list/cues/c1',
  )
})

test('small figures are neither rounded up to a unit nor down to none', async () => {
  serve({
    ...inProject(),
    'GET /v1/projects/p1/pace': aPace({
      first_pass: 0.996,
      rounds_per_cue: 0.04,
      days_late: 0.5,
      finish_on: '2029-01-20',
      studio: { ...aPace().studio, review_hours: 8 / 3600, answer_hours: 0.5, days_to_pay: 0 },
      estimates: { cues: 3, estimated_min: 30_000, logged_min: 30_090, error_percent: 0.3 },
    }),
  })
  openApp('/projects/p1/progress')
  const card = await screen.findByRole('region', { name: 'Pace' })
  expect(await within(card).findByText('over 99 %')).toBeVisible()
  expect(valueOf(card, 'Rounds per cue')).toHaveTextContent('under 0.1')
  expect(valueOf(card, 'Against the due day')).toHaveTextContent('0.5 days late')
  expect(valueOf(card, 'Done at this pace')).toHaveTextContent('20 January 2029')
  expect(valueOf(card, 'Time to a verdict')).toHaveTextContent('8 s')
  expect(valueOf(card, 'Time to an answer')).toHaveTextContent('30 min')
  expect(valueOf(card, 'Time to pay')).toHaveTextContent('the same day')
  expect(valueOf(card, 'Against estimates')).toHaveTextContent('under 1 % longer')
})

test('what has no figure yet has no line, and nothing warns', async () => {
  serve({ ...inProject('designer'), 'GET /v1/projects/p1/pace': aPace() })
  openApp('/projects/p1/progress')
  const card = await screen.findByRole('region', { name: 'Pace' })
  expect(await within(card).findByText('0 of 2')).toBeVisible()
  expect(within(card).getAllByRole('definition')).toHaveLength(1)
  expect(within(card).queryByText(/Three rounds/)).not.toBeInTheDocument()
})

test('a producer sets a budget, and a mistyped amount stays to be put right', async () => {
  const { asked } = serve({
    ...inProject(),
    'PUT /v1/projects/p1/budget': [{ currency: 'EUR', amount_minor: 1_200_000 }],
  })
  openApp('/projects/p1/progress')
  await userEvent.click(await screen.findByRole('button', { name: 'Set a budget' }))
  const form = within(screen.getByRole('form', { name: 'Budget' }))
  await userEvent.clear(form.getByLabelText('Currency'))
  await userEvent.type(form.getByLabelText('Currency'), 'eur')
  await userEvent.type(form.getByLabelText('Budget'), 'much')
  await userEvent.click(form.getByRole('button', { name: 'Save budget' }))
  expect(form.getByText('An amount above zero, such as 12000.')).toBeVisible()
  expect(form.getByLabelText('Budget')).toHaveValue('much')
  await userEvent.clear(form.getByLabelText('Budget'))
  await userEvent.type(form.getByLabelText('Budget'), '12,000')
  await userEvent.click(form.getByRole('button', { name: 'Save budget' }))
  await waitFor(() =>
    expect(wrote(asked, 'PUT /v1/projects/p1/budget').map(({ body }) => body)).toEqual([
      { currency: 'EUR', amount_minor: 1_200_000 },
    ]),
  )
  expect(await screen.findByText('The budget is €12,000.00.')).toBeVisible()
})

test('a designer sets no budget', async () => {
  serve({ ...inProject('designer'), 'GET /v1/projects/p1/pace': aPace() })
  openApp('/projects/p1/progress')
  const card = await screen.findByRole('region', { name: 'Pace' })
  expect(await within(card).findByText('0 of 2')).toBeVisible()
  expect(within(card).queryByRole('button', { name: 'Set a budget' })).toBeNull()
})
