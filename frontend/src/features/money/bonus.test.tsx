import { fireEvent, screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import type { Bonus } from '@/money/api'
import { faults, figures, LINE, opened, serveMoneyPage, server } from '@/test/moneyPage'
import { aMe } from '@/test/review'
import { refusal } from '@/test/server'

beforeAll(() => import('./MoneyPage'))
serveMoneyPage()

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
    await userEvent.click(card.getByRole('button', { name: 'Record release date' }))
    expect(await card.findByText(/that day lies ahead/i)).toBeVisible()
    expect(field).toHaveValue('2026-11-20')

    const earned = aLedger({ ...shipping, state: 'earned', because: 'the game shipped on 20 November 2026' })
    server.on('POST /v1/contracts/effects/shipped', earned).on('GET /v1/contracts/effects/ledger', earned)
    await userEvent.click(card.getByRole('button', { name: 'Record release date' }))
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
