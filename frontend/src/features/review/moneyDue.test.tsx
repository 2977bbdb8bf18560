import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { aMe, aReview } from '@/test/review'
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
