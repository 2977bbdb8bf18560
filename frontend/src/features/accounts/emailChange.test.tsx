import { screen } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, NOBODY, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

const PENDING = {
  new_email: 'new@studio.example',
  old_confirmed: true,
  new_confirmed: false,
  expires_at: '2026-11-24T09:00:00Z',
}
const SHOWN = {
  new_email: 'new@studio.example',
  is_new_end: true,
  is_confirmed: false,
  expires_at: '2026-11-24T09:00:00Z',
}

describe('changing the email of an account', () => {
  test('it is asked for on Account, which shows what it waits for and stops it', async () => {
    let pending: typeof PENDING | null = null
    const server = serve(
      asPerson(PRODUCER, {
        'GET /v1/me/email-change': () => pending,
        'POST /v1/me/email-change': () => (pending = PENDING),
        'DELETE /v1/me/email-change': () => (pending = null),
      }),
    )
    const user = userEvent.setup()
    openApp('/account')
    await user.type(await screen.findByLabelText('New email'), 'new@studio.example')
    await user.click(screen.getByRole('button', { name: 'Change email' }))
    expect(await screen.findByText('Change to new@studio.example')).toBeVisible()
    expect(screen.getByText(/sent to new@studio\.example, within a day/)).toBeVisible()
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({ email: 'new@studio.example' })
    await user.click(screen.getByRole('button', { name: 'Stop the change' }))
    expect(await screen.findByLabelText('New email')).toBeVisible()
  })

  test('a link stops it without signing in', async () => {
    serve({ 'GET /v1/session': NOBODY, 'GET /v1/email-changes/s3cret': SHOWN, 'DELETE /v1/email-changes/s3cret': null })
    const user = userEvent.setup()
    openApp('/change-email/s3cret')
    expect(await screen.findByRole('link', { name: 'Sign in to confirm' })).toBeVisible()
    await user.click(screen.getByRole('button', { name: 'Stop the change' }))
    expect(await screen.findByRole('heading', { name: 'Change stopped' })).toBeVisible()
  })

  test('a link confirms one end, and says when it is refused', async () => {
    const path = 'POST /v1/email-changes/s3cret/confirm'
    const server = serve(
      asPerson(PRODUCER, {
        'GET /v1/email-changes/s3cret': SHOWN,
        [path]: refusal(409, 'address-taken', 'new@studio.example has an account already', {
          fix: 'use another email',
        }),
      }),
    )
    const user = userEvent.setup()
    openApp('/change-email/s3cret')
    await user.click(await screen.findByRole('button', { name: 'Confirm' }))
    expect(await screen.findByText('New@studio.example has an account already.')).toBeVisible()
    server.answers[path] = { id: 'x1', name: 'Producer', email: PRODUCER.email }
    await user.click(screen.getByRole('button', { name: 'Confirm' }))
    expect(await screen.findByRole('heading', { name: 'Confirmed' })).toBeVisible()
  })
})
