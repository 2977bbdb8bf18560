import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, AT_ONCE, DESIGNER, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

describe('the security of an account', () => {
  test('an address that is not verified says why it should be, and sends the link', async () => {
    const byMail = { open: true, by_mail: true }
    const server = serve(asPerson(DESIGNER, { 'GET /v1/sign-up': byMail, 'POST /v1/me/email-verifications': null }))
    const user = userEvent.setup()
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Email' }))
    expect(card.getByText('Not verified')).toBeInTheDocument()
    await user.click(await card.findByRole('button', { name: 'Send a verification link' }))
    expect(await screen.findByText(`We have sent a link to ${DESIGNER.email}.`)).toBeInTheDocument()
    expect(await card.findByRole('button', { name: 'Send the link again' })).toBeInTheDocument()
    expect(server.asked.filter(({ path }) => path === '/v1/me/email-verifications')).toHaveLength(1)
  })

  test('without a mail server an address that is not verified says who has the link', async () => {
    serve(asPerson(DESIGNER, { 'GET /v1/sign-up': AT_ONCE, 'POST /v1/me/email-verifications': null }))
    const user = userEvent.setup()
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Email' }))
    expect(await card.findByText(`soundlist mails ${DESIGNER.email}`)).toBeInTheDocument()
    expect(card.getByText(/^You can sign contracts without it/)).toBeInTheDocument()
    await user.click(card.getByRole('button', { name: 'Create a verification link' }))
    expect(await screen.findByText('The link is ready. Ask the server’s administrator for it.')).toBeInTheDocument()
    expect(card.getByRole('button', { name: 'Create a new link' })).toBeInTheDocument()
  })

  test('a verified address asks for nothing', async () => {
    serve(asPerson(PRODUCER))
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Email' }))
    expect(card.getByText('Verified')).toBeInTheDocument()
    expect(card.queryByRole('button')).toBeNull()
  })

  test('every browser is listed, and another one is signed out', async () => {
    const server = serve(asPerson(PRODUCER, { 'DELETE /v1/me/sign-ins/n2': null, 'DELETE /v1/me/sign-ins': null }))
    const user = userEvent.setup()
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Active sessions' }))
    const rows = await card.findAllByRole('listitem')
    expect(rows[0]).toHaveTextContent(/Firefox on Linux.*192\.0\.2\.7.*This browser/)
    expect(rows[2]).toHaveTextContent(/Unknown browser/)
    expect(within(rows[0] as HTMLElement).queryByRole('button')).toBeNull()
    await user.click(card.getByRole('button', { name: 'Sign out Safari on iOS, 192.0.2.8' }))
    await user.click(card.getByRole('button', { name: 'Sign out all others' }))
    await waitFor(() =>
      expect(server.asked.filter(({ method }) => method === 'DELETE').map(({ path }) => path)).toEqual([
        '/v1/me/sign-ins/n2',
        '/v1/me/sign-ins',
      ]),
    )
  })

  test('a designer creates a desk token, whose secret is shown once, and revokes another', async () => {
    const token = {
      id: 'd1',
      name: 'Laptop',
      created_at: '2026-11-20T09:00:00Z',
      last_used_at: null,
      expires_at: '2027-11-20T09:00:00Z',
    }
    const server = serve(
      asPerson(DESIGNER, {
        'GET /v1/me/desk-tokens': [token],
        'POST /v1/me/desk-tokens': { ...token, id: 'd2', name: 'Studio computer', secret: 'sld_secret' },
        'DELETE /v1/me/desk-tokens/d1': null,
      }),
    )
    const user = userEvent.setup()
    openApp('/account/tokens')
    const card = within(await screen.findByRole('region', { name: 'Desk tokens' }))
    expect(await card.findByRole('listitem')).toHaveTextContent(/Laptop.*never used/)
    await user.clear(card.getByLabelText('Token name'))
    await user.type(card.getByLabelText('Token name'), 'Studio computer')
    await user.selectOptions(card.getByLabelText('Works for'), '90 days')
    await user.click(card.getByRole('button', { name: 'Create token' }))
    expect(await card.findByText('sld_secret')).toBeInTheDocument()
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: 'Studio computer', days: 90 })
    await user.click(card.getByRole('button', { name: 'I’ve saved it' }))
    expect(card.queryByText('sld_secret')).toBeNull()
    await user.click(card.getByRole('button', { name: 'Revoke Laptop' }))
    await waitFor(() => expect(server.asked.some(({ method }) => method === 'DELETE')).toBe(true))
  })

  test('where the sign-in is old, the password is asked for in place, and what was done is repeated', async () => {
    let isRecent = false
    const made = {
      id: 'd2',
      name: 'My computer',
      created_at: '2026-11-20T09:00:00Z',
      last_used_at: null,
      expires_at: '2126-11-20T09:00:00Z',
      secret: 'sld_secret',
    }
    const server = serve(
      asPerson(DESIGNER, {
        'GET /v1/me/desk-tokens': [],
        'POST /v1/me/desk-tokens': () =>
          isRecent ? made : refusal(403, 'recent-sign-in-needed', 'this gives access; nothing was done'),
        'POST /v1/sign-in': () => {
          isRecent = true
          return { ...DESIGNER.person, email: DESIGNER.email, email_verified_at: null }
        },
      }),
    )
    const user = userEvent.setup()
    openApp('/account/tokens')
    const card = within(await screen.findByRole('region', { name: 'Desk tokens' }))
    await user.click(await card.findByRole('button', { name: 'Create token' }))
    const declined = await screen.findByRole('dialog', { name: 'Confirm your password' })
    await user.click(within(declined).getByRole('button', { name: 'Close' }))
    expect(await card.findByText(/nothing was done/)).toBeVisible()
    await user.click(card.getByRole('button', { name: 'Create token' }))
    const dialog = within(await screen.findByRole('dialog', { name: 'Confirm your password' }))
    expect(dialog.getByLabelText('Email')).toHaveValue(DESIGNER.email)
    expect(dialog.getByLabelText('Email')).toHaveAttribute('readonly')
    await user.type(dialog.getByLabelText('Password'), 'a few words of mine')
    await user.click(dialog.getByRole('button', { name: 'Confirm' }))
    expect(await card.findByText('sld_secret')).toBeInTheDocument()
    expect(server.asked.filter(({ path }) => path === '/v1/sign-in').map(({ body }) => body)).toEqual([
      { email: DESIGNER.email, password: 'a few words of mine' },
    ])
  })

  test('a changed password says that the desk tokens have ended', async () => {
    serve(asPerson(DESIGNER, { 'PUT /v1/me/password': null }))
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Password' }))
    expect(card.getByText(/ends your desk tokens/)).toBeVisible()
    const user = userEvent.setup()
    await user.type(card.getByLabelText('Current password'), 'a few words of mine')
    await user.type(card.getByLabelText('New password'), 'four words of music')
    await user.click(card.getByRole('button', { name: 'Change password' }))
    expect(await screen.findByText(/your desk tokens have ended/)).toBeVisible()
    expect(card.getByLabelText('New password')).toHaveValue('')
  })

  test('the game team has no desk tokens', async () => {
    serve(asPerson(PRODUCER))
    openApp('/account')
    await screen.findByRole('region', { name: 'Active sessions' })
    expect(screen.queryByRole('region', { name: 'Desk tokens' })).toBeNull()
  })

  test('the mailed link verifies by a press', async () => {
    const server = serve(
      asPerson(DESIGNER, { 'POST /v1/email-verifications/s3cret': { id: 'x3', name: 'x', email: 'x' } }),
    )
    const user = userEvent.setup()
    openApp('/verify-address/s3cret')
    const press = await screen.findByRole('button', { name: 'Verify designer@sound.example' })
    expect(server.asked.filter(({ method }) => method === 'POST')).toEqual([])
    await user.click(press)
    expect(await screen.findByRole('heading', { name: 'Email verified' })).toBeInTheDocument()
  })

  test('a link of another account says so', async () => {
    serve(
      asPerson(DESIGNER, {
        'POST /v1/email-verifications/s3cret': refusal(
          404,
          'verification-not-found',
          'this link is used, older than a day, or for another account',
          { fix: 'sign in with the account that asked for it' },
        ),
      }),
    )
    const user = userEvent.setup()
    openApp('/verify-address/s3cret')
    await user.click(await screen.findByRole('button', { name: /^Verify / }))
    expect(await screen.findByRole('alert')).toHaveTextContent('Sign in with the account that asked for it.')
  })
})
