import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { aDraft, aMe, anItem, aReview, aTake, PROJECT } from '@/test/review'
import { opened, server, serveReview, serveReviewPage, walk } from '@/test/reviewPage'
import { answer } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

describe('what a pick makes due', () => {
  const MONEY = {
    contract_id: 'contract',
    currency: 'USD',
    milestone: 'Alpha',
    amount_minor: 18_000,
    would_owe_minor: 18_000,
    would_take_back_minor: 0,
    accepted: 3,
    accepted_then: 4,
    wanted: 10,
    rounds_included: 2,
    extra_round_minor: 4_500,
    extra_rounds: [],
  }
  const bar = () => screen.getByRole('region', { name: 'Verdict' })
  const asked = () => server.of('GET /v1/cues/shield/money')

  test('is said to a producer', async () => {
    server.on('GET /v1/me', aMe({ is_producer: true })).on('GET /v1/cues/shield/money', MONEY)
    await opened()
    await waitFor(() => expect(bar()).toHaveTextContent('$180.00 is due then, and Alpha is 4 of 10.'))
  })

  test('is no sum where it is due once the milestone is whole', async () => {
    server
      .on('GET /v1/me', aMe({ is_producer: true }))
      .on('GET /v1/cues/shield/money', { ...MONEY, would_owe_minor: 0 })
    await opened()
    await waitFor(() => expect(bar()).toHaveTextContent('Alpha is 4 of 10 then.'))
    expect(bar()).not.toHaveTextContent('$')
  })

  test('is nothing more for a cue that is accepted already, or that no contract covers', async () => {
    const settled = { ...MONEY, would_owe_minor: 0, accepted_then: 3 }
    server.on('GET /v1/me', aMe({ is_producer: true })).on('GET /v1/cues/shield/money', settled)
    server.on('GET /v1/cues/walk/money', answer(null))
    await opened()
    await waitFor(() => expect(asked()).toHaveLength(1))
    expect(bar()).not.toHaveTextContent('Alpha')
    await userEvent.keyboard('j')
    await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })
    await waitFor(() => expect(server.of('GET /v1/cues/walk/money')).toHaveLength(1))
    expect(bar()).toHaveTextContent('Approves all 2 variations at once.')
    expect(bar()).not.toHaveTextContent('due')
  })

  test('waits for the whole set', async () => {
    const one = aReview({ ...walk, takes: walk.takes.slice(0, 1) })
    serveReview(one)
    server.on('GET /v1/me', aMe({ is_producer: true })).on('GET /v1/cues/walk/money', MONEY)
    await opened('/walk')
    await waitFor(() => expect(server.of('GET /v1/cues/walk/money')).toHaveLength(1))
    expect(await screen.findByText('1 variation of the set is missing.')).toBeVisible()
    expect(bar()).not.toHaveTextContent('due')
  })

  test('is not even asked for by who decides without sight of money', async () => {
    server.on('GET /v1/cues/shield/money', MONEY)
    await opened()
    expect(bar()).toHaveTextContent('Your call.')
    expect(bar()).not.toHaveTextContent('$')
    expect(asked()).toEqual([])
  })
})

describe('a change of an approved version', () => {
  const approved = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a', { state: 'approved' })])
  const TAKEN = {
    contract_id: 'contract',
    currency: 'USD',
    milestone: 'Alpha',
    amount_minor: 18_000,
    would_owe_minor: 0,
    would_take_back_minor: 36_000,
    accepted: 4,
    accepted_then: 4,
    wanted: 10,
    rounds_included: 2,
    extra_round_minor: 4_500,
    extra_rounds: [],
  }
  const SAYS =
    'shield_hit version 1 is approved. Sending this change takes the approval back, and $360.00 is no longer due.'

  test('says what it takes back before it is noted, by a text and by a reason', async () => {
    server.on('GET /v1/cues/shield/money', TAKEN)
    serveReview(aReview(approved, { approved_variations: [1], accepted: true }))
    await opened()
    await userEvent.keyboard('r')
    expect(await screen.findByText(SAYS)).toBeVisible()
    await userEvent.keyboard('{Escape}')
    expect(screen.queryByText(SAYS)).toBeNull()
    await userEvent.keyboard('{Shift>}r{/Shift}')
    expect(await screen.findByText(SAYS)).toBeVisible()
  })

  test('says so without a sum where there is none, and nothing of a version that waits', async () => {
    server.on('GET /v1/cues/shield/money', answer(null))
    serveReview(aReview(approved, { approved_variations: [1], accepted: true }))
    await opened()
    await userEvent.keyboard('r')
    expect(await screen.findByText(/takes the approval back\./)).toBeVisible()
    await userEvent.keyboard('{Escape}j')
    await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })
    await userEvent.keyboard('r')
    expect(await screen.findByRole('form', { name: /What to change in foot_deck_walk/ })).toBeVisible()
    expect(screen.queryByText(/takes the approval back/)).toBeNull()
  })

  test('says it again where drafts are sent', async () => {
    const [take] = approved.takes
    if (!take) throw new Error('there is one version')
    const draft = { ...aDraft(take, approved.cue, 'Too loud.'), reverses: true }
    server
      .on('GET /v1/cues/shield/money', TAKEN)
      .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [draft], next: null })
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: '1 change to send' }))
    expect(await screen.findAllByText(SAYS)).not.toHaveLength(0)
  })
})
