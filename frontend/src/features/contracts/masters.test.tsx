import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { CONTRACT, contractAnswers, NO_MASTERS, PAGE } from '@/test/contract'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

const AGREED = { ...CONTRACT, agreed_at: '2026-11-20T11:00:00Z', state: 'agreed', my_party: 'studio' }
const KEPT = { ...NO_MASTERS, last_delivery_on: '2026-12-01', masters: 12, ends_on: '2031-12-01' }
const READ = 'GET /v1/contracts/c1/master-retention'
const SET = 'PUT /v1/contracts/c1/master-retention'

const open = (retention: unknown, contract: object = AGREED) => {
  const served = serve(contractAnswers({ 'GET /v1/contracts/c1': contract, [READ]: retention }))
  openApp(PAGE)
  return served
}
const card = async () => within(await screen.findByRole('region', { name: 'Masters' }))

test('a producer reads the day of deletion, and keeps masters longer or not by one press each', async () => {
  const { asked, answers } = open({ ...KEPT, obstacles: ['money is open in Effects'] })
  const masters = await card()
  expect(
    masters.getByText(/^12 masters of this designer in the project, kept until .*2031, 5 years after/),
  ).toBeVisible()
  expect(masters.getByText('Not deleted while money is open in Effects.')).toBeVisible()
  answers[SET] = { ...KEPT, ends_on: null, kept_by: 'Ada' }
  await userEvent.click(masters.getByRole('button', { name: 'Keep longer' }))
  expect(await masters.findByText('12 masters of this designer in the project, kept longer by Ada.')).toBeVisible()
  answers[SET] = KEPT
  await userEvent.click(masters.getByRole('button', { name: 'Stop keeping longer' }))
  await waitFor(() => expect(asked.filter(({ method }) => method === 'PUT')).toHaveLength(2))
  expect(asked.filter(({ method }) => method === 'PUT').map(({ body }) => body)).toEqual([
    { keep: true },
    { keep: false },
  ])
})

test('a designer reads that they will be deleted, and presses nothing', async () => {
  open({ ...KEPT, announced_at: '2031-11-01T03:00:00Z' }, { ...AGREED, my_party: 'designer' })
  const masters = await card()
  expect(masters.getByText(/to be deleted on .*2031.*Download what you need before; game files stay\.$/)).toBeVisible()
  expect(masters.queryByRole('button')).toBeNull()
})

test('deleted masters show their day', async () => {
  open({ ...NO_MASTERS, deleted_at: '2031-12-01T03:00:00Z' })
  expect((await card()).getByText(/^Deleted on .*2031, after the contract’s years\. Game files stay\.$/)).toBeVisible()
})

test('without years in the contracts there is no end', async () => {
  open({ ...KEPT, years: null, ends_on: null })
  const masters = await card()
  expect(masters.getByText(/kept without an end: a contract names no years\.$/)).toBeVisible()
  expect(masters.queryByRole('button')).toBeNull()
})

test('a refusal stands under the button', async () => {
  const { answers } = open(KEPT)
  const masters = await card()
  answers[SET] = refusal(403, 'producer-needed', 'only a producer of the studio can do this')
  await userEvent.click(masters.getByRole('button', { name: 'Keep longer' }))
  expect(await masters.findByText(/only a producer of the studio can do this/i)).toBeVisible()
})
