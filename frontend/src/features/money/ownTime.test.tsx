import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, expect, test } from 'vitest'

import { serveMoney, serveMoneyPage, server } from '@/test/moneyPage'
import { openApp } from '@/test/openApp'
import { aMe, PROJECT } from '@/test/review'

beforeAll(() => import('./MoneyPage'))
serveMoneyPage()

const OWN_TIME = `/v1/projects/${PROJECT}/own-time`
const TIME = { id: 'time-1', cue: null, minutes: 90, worked_on: '2026-11-12', note: 'Test work' }

async function ownTime() {
  let times: (typeof TIME)[] = []
  serveMoney({ contracts: [], totals: [] })
  server
    .on('GET /v1/me', aMe({ part: 'designer', is_liaison: false, is_approver: false }))
    .on(`GET ${OWN_TIME}`, () => ({ times, categories: [{ category: 'ui', cues: 3, low_min: 90, high_min: 180 }] }))
    .on(`POST ${OWN_TIME}`, () => (times = [TIME])[0])
    .on('DELETE /v1/own-time/time-1', () => {
      times = []
      return null
    })
  openApp(`/projects/${PROJECT}/money`)
  return within(await screen.findByRole('region', { name: 'Your time without a contract' }))
}

test('a designer without a contract logs time, reads how long a cue takes, and removes it', async () => {
  const card = await ownTime()
  expect(card.getByText('visible to you only')).toBeVisible()
  expect(card.getByText(/ui: 1\.5 h to 3 h a cue|ui: 1 h 30 min to 3 h a cue/)).toBeVisible()
  await userEvent.click(card.getByRole('button', { name: 'Log time' }))
  expect(card.getByText('Enter minutes.')).toBeVisible()
  await userEvent.type(card.getByLabelText('Minutes'), '90')
  await userEvent.type(card.getByLabelText('What it was'), 'Test work')
  await userEvent.click(card.getByRole('button', { name: 'Log time' }))
  expect(await card.findByText('Test work')).toBeVisible()
  expect(server.of(`POST ${OWN_TIME}`)[0]?.body).toMatchObject({ cue_id: null, minutes: 90, note: 'Test work' })
  await userEvent.click(card.getByRole('button', { name: /^Remove/ }))
  await waitFor(() => expect(card.queryByText('Test work')).toBeNull())
})
