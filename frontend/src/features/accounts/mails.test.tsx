import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

const ME = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  email_verified_at: '2026-11-20T09:00:00Z',
  studios: [],
  projects: [],
}
const AT_ONCE = { sounds: 'at_once', talk: 'at_once', list: 'at_once', contracts: 'at_once', hiring: 'at_once' }
const WISHES = { cadences: AT_ONCE, time_zone: 'UTC', daily_at: '08:00:00', quiet_from: null, quiet_until: null }

const account = (more: Answers = {}): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: ME.person },
  'GET /v1/me': ME,
  'GET /v1/review-queue/count': { cues: 0, is_all: true },
  'GET /v1/me/sign-ins': [],
  'GET /v1/sign-up': { open: true, by_mail: false },
  'GET /v1/me/mail-preferences': WISHES,
  ...more,
})

const card = () => screen.findByRole('region', { name: 'Emails' })

describe('the emails of a person', () => {
  test('a kind of news is set to once a day, and the others stay', async () => {
    const daily = { ...WISHES, cadences: { ...AT_ONCE, talk: 'daily' } }
    const server = serve(account({ 'PUT /v1/me/mail-preferences': daily }))
    openApp('/account/notifications')
    const user = userEvent.setup()
    await user.selectOptions(await within(await card()).findByLabelText('Questions and replies'), 'daily')
    expect(await within(await card()).findByLabelText('The day’s email at')).toHaveValue('08:00')
    const sent = server.asked.find(({ method }) => method === 'PUT')
    expect(sent?.body).toEqual(daily)
  })

  test('emails about contracts can be once a day, and are never turned off', async () => {
    serve(account())
    openApp('/account/notifications')
    const choice = await within(await card()).findByLabelText('Contracts and payments')
    expect(
      within(choice)
        .getAllByRole('option')
        .map((option) => option.textContent),
    ).toEqual(['At once', 'Once an hour', 'Once a day'])
  })

  test('quiet hours are saved with both ends', async () => {
    const server = serve(
      account({
        'PUT /v1/me/mail-preferences': { ...WISHES, quiet_from: '20:00:00', quiet_until: '07:30:00' },
      }),
    )
    openApp('/account/notifications')
    const user = userEvent.setup()
    await user.type(await within(await card()).findByLabelText('Send nothing from'), '20:00')
    const save = await within(await card()).findByRole('button', { name: 'Save quiet hours' })
    expect(save).toBeDisabled()
    await user.type(await within(await card()).findByLabelText('until'), '07:30')
    await user.click(save)
    await within(await card()).findByRole('button', { name: 'No quiet hours' })
    const sent = server.asked.find(({ method }) => method === 'PUT')
    expect(sent?.body).toEqual({ ...WISHES, quiet_from: '20:00', quiet_until: '07:30' })
  })

  test('a refusal stands in the card, and the choice stays as it was', async () => {
    serve(
      account({
        'PUT /v1/me/mail-preferences': refusal(422, 'time-zone-unknown', 'there is no time zone "UTC"'),
      }),
    )
    openApp('/account/notifications')
    const user = userEvent.setup()
    await user.selectOptions(await within(await card()).findByLabelText('Sounds'), 'never')
    expect(await within(await card()).findByText(/no time zone/)).toBeInTheDocument()
    expect(await within(await card()).findByLabelText('Sounds')).toHaveValue('at_once')
  })
})

describe('the link at the end of an email', () => {
  const CHOICE = { email: ME.email, news: ['talk'], cadence: 'at_once', can_stop: true }
  const guest = (more: Answers): Answers => ({
    'GET /v1/session': { signed_in: false, demo: false, person: null },
    ...more,
  })

  test('turns them off by one press, without signing in, and opening it changes nothing', async () => {
    const server = serve(
      guest({
        'GET /v1/mail-choices/a-secret': CHOICE,
        'PUT /v1/mail-choices/a-secret': { ...CHOICE, cadence: 'never' },
      }),
    )
    openApp('/mails/a-secret')
    await screen.findByText('Questions and replies: sent at once.')
    expect(server.asked.every(({ method }) => method === 'GET')).toBe(true)
    await userEvent.setup().click(screen.getByRole('button', { name: 'Never' }))
    await screen.findByText('Saved. You get no more of these emails.')
    expect(server.asked.find(({ method }) => method === 'PUT')?.body).toEqual({ cadence: 'never' })
  })

  test('of a contract’s email offers no Never and says why', async () => {
    serve(guest({ 'GET /v1/mail-choices/a-secret': { ...CHOICE, news: ['contracts'], can_stop: false } }))
    openApp('/mails/a-secret')
    await screen.findByText(/can’t be turned off/)
    expect(screen.queryByRole('button', { name: 'Never' })).toBeNull()
  })

  test('that was cut short says so and leads to the account', async () => {
    serve(guest({ 'GET /v1/mail-choices/a-sec': refusal(404, 'mail-link-not-found', 'this link is not whole') }))
    openApp('/mails/a-sec')
    await waitFor(() => expect(screen.getByRole('heading', { name: 'This link is incomplete' })).toBeInTheDocument())
    expect(screen.getByRole('link', { name: 'Go to your account' })).toHaveAttribute('href', '/account')
  })
})
