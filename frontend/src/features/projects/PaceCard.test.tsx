import { screen, within } from '@testing-library/react'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aPace, inProject } from '@/test/project'
import { serve } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

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
      studio: { review_hours: 70, answer_hours: 3, open_questions: 2, days_to_pay: 12, late_invoices: 1 },
      costs: [{ currency: 'USD', accepted_minor: 4500, per_kept_minor: 4500, to_finish_minor: 63000 }],
    }),
  })
  openApp('/projects/p1')
  const card = await screen.findByRole('region', { name: 'Pace' })
  expect(await within(card).findByText('75 %; 50 % in four weeks, 100 % before')).toHaveClass('tone-warn')
  expect(valueOf(card, 'Against the due day')).toHaveTextContent('2 days late')
  expect(valueOf(card, 'Done at this pace')).toHaveTextContent('9 December; needed by 5 December')
  expect(valueOf(card, 'Time to a verdict')).toHaveTextContent('3 days')
  expect(valueOf(card, 'Time to an answer')).toHaveTextContent('3 hours')
  expect(valueOf(card, 'Cost of a kept sound')).toHaveTextContent('$45.00')
  expect(within(card).getByRole('link', { name: 'SW-001 shield_hit' })).toHaveAttribute(
    'href',
    '/projects/p1/sound-list/cues/c1',
  )
})

test('what has no figure yet has no line, and nothing warns', async () => {
  serve({ ...inProject('designer'), 'GET /v1/projects/p1/pace': aPace() })
  openApp('/projects/p1')
  const card = await screen.findByRole('region', { name: 'Pace' })
  expect(await within(card).findByText('0 of 2')).toBeVisible()
  expect(within(card).getAllByRole('definition')).toHaveLength(1)
  expect(within(card).queryByText(/Three rounds/)).not.toBeInTheDocument()
})
