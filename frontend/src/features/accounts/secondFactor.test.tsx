import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, AT_ONCE, NOBODY, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

const SETUP = {
  secret: 'GEZDGNBVGY3TQOJQ',
  uri: 'otpauth://totp/Soundlist:me?secret=GEZDGNBVGY3TQOJQ',
  qr_svg: '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"></svg>',
}
const NEEDED = refusal(401, 'second-factor-needed', 'this account asks for a second factor', { fix: 'enter the code' })

describe('the second factor of an account', () => {
  test('an app is set up by its first code, and the recovery codes are shown once', async () => {
    let factors = { totp_since: null as string | null, recovery_codes_left: 0 }
    const server = serve(
      asPerson(PRODUCER, {
        'GET /v1/me/second-factors': () => factors,
        'POST /v1/me/totp': SETUP,
        'POST /v1/me/totp/confirm': () => {
          factors = { totp_since: '2026-11-20T09:00:00Z', recovery_codes_left: 10 }
          return { recovery_codes: ['ABCD-EFGH-IJKL-MNOP', 'QRST-UVWX-YZ23-4567'] }
        },
        'DELETE /v1/me/totp': () => {
          factors = { totp_since: null, recovery_codes_left: 0 }
          return null
        },
      }),
    )
    const user = userEvent.setup()
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Second factor' }))
    await user.click(await card.findByRole('button', { name: 'Set up authenticator app' }))
    expect(await card.findByRole('img', { name: /QR code/ })).toHaveAttribute(
      'src',
      expect.stringMatching(/^data:image/),
    )
    expect(card.getByText('GEZD GNBV GY3T QOJQ')).toBeVisible()
    await user.type(card.getByLabelText('Code'), '123456')
    await user.click(card.getByRole('button', { name: 'Turn on' }))
    expect(await card.findByText('ABCD-EFGH-IJKL-MNOP')).toBeVisible()
    expect(server.asked.find(({ path }) => path === '/v1/me/totp/confirm')?.body).toEqual({ code: '123456' })
    await user.click(card.getByRole('button', { name: 'I’ve saved them' }))
    expect(card.queryByText('ABCD-EFGH-IJKL-MNOP')).toBeNull()
    expect(await card.findByText(/^Recovery codes left: 10/)).toBeVisible()
    await user.click(card.getByRole('button', { name: 'Remove authenticator app' }))
    expect(await card.findByRole('button', { name: 'Set up authenticator app' })).toBeVisible()
  })

  test('who has none, though a studio requires one, is shown where to set it up', async () => {
    const waiting = { ...PRODUCER, second_factor_required_by: ['Shield Wing studio'] }
    serve(asPerson(waiting))
    const app = openApp('/studio')
    expect(await screen.findByText('Shield Wing studio: a second factor is required.')).toBeVisible()
    expect(app.at()).toBe('/account')
    expect(await screen.findByRole('button', { name: 'Set up authenticator app' })).toBeVisible()
  })

  test('a producer requires one of those who sign, and is told what stands in the way', async () => {
    const path = '/v1/studios/s1/second-factor'
    const server = serve(
      asPerson(PRODUCER, {
        [`GET ${path}`]: { required_for: [] },
        [`PUT ${path}`]: refusal(409, 'no-second-factor', 'you have no second factor yourself', { fix: 'set one up' }),
      }),
    )
    const user = userEvent.setup()
    openApp('/studio')
    const card = within(await screen.findByRole('region', { name: 'Second factor' }))
    await user.click(await card.findByLabelText('Signing contracts'))
    expect(await card.findByText('You have no second factor yourself.')).toBeVisible()
    server.answers[`PUT ${path}`] = { required_for: ['signing'] }
    await user.click(card.getByLabelText('Signing contracts'))
    await waitFor(() => expect(card.getByLabelText('Signing contracts')).toBeChecked())
    expect(server.asked.find(({ method }) => method === 'PUT')?.body).toEqual({ required_for: ['signing'] })
  })

  test('passkeys are listed with their last use, and removed', async () => {
    let passkeys = [
      { id: 'k1', name: 'Phone', created_at: '2026-11-20T09:00:00Z', last_used_at: null as string | null },
      { id: 'k2', name: 'Laptop', created_at: '2026-11-20T09:00:00Z', last_used_at: '2026-11-22T09:00:00Z' },
    ]
    serve(
      asPerson(PRODUCER, {
        'GET /v1/me/passkeys': () => passkeys,
        'GET /v1/me/second-factors': { totp_since: null, recovery_codes_left: 9 },
        'DELETE /v1/me/passkeys/k1': () => {
          passkeys = passkeys.filter(({ id }) => id !== 'k1')
          return null
        },
      }),
    )
    const user = userEvent.setup()
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Passkeys' }))
    expect(await card.findByText(/never used$/)).toBeVisible()
    expect(card.getByText(/last used/)).toBeVisible()
    expect(card.getByText(/they need HTTPS and a host name/)).toBeVisible() // this browser makes none
    expect(await screen.findByText(/^Recovery codes left: 9/)).toBeVisible()
    await user.click(card.getByRole('button', { name: 'Remove Phone' }))
    await waitFor(() => expect(card.queryByText('Phone')).toBeNull())
    expect(card.getByText('Laptop')).toBeVisible()
  })

  test('signing in asks for the code as a second step, and says when it is wrong', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/sign-in': NEEDED,
    })
    const user = userEvent.setup()
    openApp('/sign-in')
    await user.type(await screen.findByLabelText('Email'), PRODUCER.email)
    await user.type(screen.getByLabelText('Password'), 'a few words of mine')
    expect(screen.queryByLabelText('Code')).toBeNull()
    await user.click(screen.getByRole('button', { name: 'Sign in' }))
    const code = await screen.findByLabelText('Code')
    expect(code).toHaveFocus()
    server.answers['POST /v1/sign-in'] = refusal(403, 'wrong-second-factor', 'this code is wrong', {
      errors: [{ where: 'code', message: 'this code is wrong' }],
    })
    await user.type(code, '000000{Enter}')
    await waitFor(() => expect(code).toHaveAccessibleDescription(expect.stringContaining('This code is wrong.')))
    expect(screen.getByLabelText('Password')).toHaveValue('a few words of mine')
    expect(server.asked.filter(({ path }) => path === '/v1/sign-in').map(({ body }) => body)).toEqual([
      { email: PRODUCER.email, password: 'a few words of mine' },
      { email: PRODUCER.email, password: 'a few words of mine', code: '000000' },
    ])
  })
})
