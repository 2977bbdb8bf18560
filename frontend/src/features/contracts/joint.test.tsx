import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { CONTRACT, contractAnswers, MAY, PAGE, PROJECT } from '@/test/contract'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

import { shareOf } from './JointCard'

const DRAFT = {
  ...CONTRACT,
  state: 'draft',
  my_party: 'studio',
  waits_for: ['studio'],
  may: { ...MAY, change: true, send: true },
}
const COMPOSER = { id: 'x5', name: 'Composer' }
const PARTS = [
  {
    contract_id: 'c1',
    designer: CONTRACT.designer,
    is_own: true,
    cues: 2,
    amount_minor: 60_000,
    currency: 'USD',
    share: '60 %',
  },
  {
    contract_id: 'c2',
    designer: COMPOSER,
    is_own: false,
    cues: 1,
    amount_minor: 40_000,
    currency: 'USD',
    share: '40 %',
  },
]
const engagement = (id: string, designer: object) => ({ id, kind: 'contract', ended_at: null, designer })
const cue = (id: string, name: string, category: string) => ({
  id,
  label: `SW-00${id}`,
  name,
  category,
  state: 'locked',
})
const PLAN = {
  contract_id: 'c1',
  state: 'draft',
  currency: 'USD',
  milestones: [{ cues: ['1', '2', '3'].map((id) => ({ cue: { id } })) }],
  advice: [],
  price: { total_minor: 100_000, deposit_minor: 0, bid_minor: null, bid_currency: null, above_bid_minor: null },
  concepts: { count: 0, cues: 3, amount_minor: 0 },
}

const answers = (more: object = {}) =>
  contractAnswers({
    'GET /v1/contracts/c1': DRAFT,
    'GET /v1/contracts/c1/milestones': PLAN,
    'GET /v1/projects/p1': {
      ...PROJECT,
      studio: { id: 's1', name: 'Shield Wing studio' },
      engagements: [engagement('e1', CONTRACT.designer), engagement('e2', COMPOSER)],
    },
    'GET /v1/studios/s1/people': [],
    'GET /v1/projects/p1/sound-list': {
      revision: 1,
      next: null,
      cues: [cue('1', 'shield_hit', 'weapon'), cue('2', 'laser', 'weapon'), cue('3', 'theme', 'music')],
    },
    ...more,
  })

test('a share is a percentage or an amount', () => {
  expect(shareOf('40 %', 'USD')).toEqual({ share_bp: 4_000 })
  expect(shareOf('33.33%', 'USD')).toEqual({ share_bp: 3_333 })
  expect(shareOf('33,5 %', 'USD')).toEqual({ share_bp: 3_350 })
  expect(shareOf('1,200.50', 'USD')).toEqual({ share_minor: 120_050 })
  expect(shareOf(' ', 'USD')).toBeUndefined()
  for (const wrong of ['101 %', 'half', '-5', '5.123 %']) expect(shareOf(wrong, 'USD')).toBeNull()
})

test('a designer reads the other’s part, and that a signed contract waits for the other one', async () => {
  const joint = PARTS.map((part) => (part.is_own ? part : { ...part, contract_id: null }))
  serve(answers({ 'GET /v1/contracts/c1': { ...CONTRACT, joint, waits_for: [], may: MAY } }))
  openApp(PAGE)
  const list = within(await screen.findByRole('list', { name: 'Joint work' }))
  expect(list.getByText('$400.00, 40 %')).toBeVisible()
  expect(list.queryByRole('link')).not.toBeInTheDocument()
  expect(screen.getByText('All have signed this one. It waits for the contract with Composer.')).toBeVisible()
  expect(screen.getByText('Signed, waiting for the joint contract')).toBeVisible()
})

describe('a producer', () => {
  test('divides a draft with a second designer by category and share', async () => {
    const { asked } = serve(answers({ 'POST /v1/contracts/c1/joint': { ...DRAFT, joint: PARTS } }))
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('button', { name: 'Add a second designer' }))
    const form = within(await screen.findByRole('form', { name: 'Add a second designer' }))
    expect(form.getByText(/each designer sees the other’s sounds and amount/)).toBeVisible()
    await userEvent.click(await form.findByLabelText('music, 1 cue'))
    expect(form.getByText('1 of 3 cues chosen')).toBeVisible()
    const share = form.getByLabelText('Share of Composer (optional)')
    await userEvent.click(share)
    await userEvent.paste('40 %')
    await userEvent.keyboard('{Enter}')
    const list = within(await screen.findByRole('list', { name: 'Joint work' }))
    expect(list.getByText('$600.00, 60 %')).toBeVisible()
    expect(list.getByRole('link', { name: 'Composer' })).toHaveAttribute('href', '/projects/p1/contracts/c2')
    expect(screen.getByRole('button', { name: 'Send to Sound designer and Composer' })).toBeVisible()
    expect(asked.find(({ path }) => path.endsWith('/joint'))?.body).toEqual({
      engagement_id: 'e2',
      cue_ids: ['3'],
      share_bp: 4_000,
    })
  })

  test('changes the split of a draft, and reads why it cannot be', async () => {
    const refused = refusal(422, 'bad-split', 'the share is USD 2,000.00, and both are paid USD 1,000.00')
    const draft = { ...DRAFT, joint: PARTS }
    const { asked, answers: served } = serve(
      answers({ 'GET /v1/contracts/c1': draft, 'PUT /v1/contracts/c1/joint': refused }),
    )
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('button', { name: 'Change split' }))
    const form = within(screen.getByRole('form', { name: 'Change split' }))
    const share = form.getByLabelText('Share of Sound designer')
    await userEvent.type(share, '?{Enter}')
    expect(form.getByText(/^Enter a percentage/)).toBeVisible()
    await userEvent.clear(share)
    await userEvent.type(share, '2000{Enter}')
    expect(await form.findByText(/The share is USD 2,000.00/)).toBeVisible()
    served['PUT /v1/contracts/c1/joint'] = draft
    await userEvent.clear(share)
    await userEvent.type(share, '50 %{Enter}')
    await waitFor(() => expect(screen.queryByRole('form', { name: 'Change split' })).not.toBeInTheDocument())
    expect(asked.filter(({ path }) => path.endsWith('/joint')).map(({ body }) => body)).toEqual([
      { share_minor: 200_000 },
      { share_bp: 5_000 },
    ])
  })
})
