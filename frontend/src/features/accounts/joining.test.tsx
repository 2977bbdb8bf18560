import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, AT_ONCE, NOBODY, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

describe('a link into a studio', () => {
  const INVITED = {
    studio_name: 'Shield Wing studio',
    email: 'new@studio.example',
    roles: ['reviewer'],
    invited_by_name: 'Producer',
    has_account: false,
    expires_at: '2027-01-02T09:00:00Z',
  }

  test('makes an account of a name and a password, and signs in', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'GET /v1/studio-invitations/s3cret': INVITED,
      'POST /v1/studio-invitations/s3cret/accept': () => {
        Object.assign(server.answers, asPerson(PRODUCER))
        return { person: { id: 'x9', name: 'Composer', email: INVITED.email }, studio: { id: 's1', name: 'x' } }
      },
    })
    const user = userEvent.setup()
    const app = openApp('/join/s3cret')
    await screen.findByRole('heading', { name: 'Join Shield Wing studio' })
    await user.type(screen.getByLabelText('Your name'), 'Composer')
    await user.type(screen.getByLabelText('Password'), 'four words of music')
    await user.click(screen.getByRole('button', { name: 'Join Shield Wing studio' }))
    await waitFor(() => expect(app.at()).not.toBe('/join/s3cret'))
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({
      name: 'Composer',
      password: 'four words of music',
    })
  })

  test('one that is withdrawn says so, and what to do', async () => {
    serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'GET /v1/studio-invitations/s3cret': refusal(404, 'studio-invitation-not-found', 'this invitation is not there'),
    })
    openApp('/join/s3cret')
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'This invitation is not there. Ask the person who invited you for a new link.',
    )
  })
})

describe('signing up', () => {
  test('a server that takes people by invitation says so, and asks for nothing', async () => {
    serve({ 'GET /v1/session': NOBODY, 'GET /v1/sign-up': { open: false, by_mail: true } })
    openApp('/sign-up')
    expect(await screen.findByText(/Sign-up is by invitation only/)).toBeInTheDocument()
    expect(screen.queryByRole('textbox')).toBeNull()
  })

  test.each([
    { by_mail: false, action: 'Create account', path: '/v1/sign-up' },
    { by_mail: true, action: 'Email me a link', path: '/v1/sign-ups' },
  ])('the first account of a server needs its set-up code (by mail: $by_mail)', async ({ by_mail, action, path }) => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': { open: true, by_mail, setup_code: true },
      [`POST ${path}`]: refusal(403, 'setup-code-needed', 'this is not the set-up code of this server', {
        errors: [{ where: 'setup_code', message: 'this is not the set-up code of this server' }],
      }),
    })
    const user = userEvent.setup()
    openApp('/sign-up')
    const code = await screen.findByLabelText('Set-up code')
    expect(screen.getByText(/soundlist serve prints the code/)).toBeInTheDocument()
    for (const field of screen.queryAllByRole('textbox')) await user.type(field, 'a@hull.example')
    await user.clear(code)
    await user.type(code, 'ABCD-EFGH')
    if (!by_mail) await user.type(screen.getByLabelText('Password'), 'four words of music')
    await user.click(screen.getByRole('button', { name: action }))
    expect(await screen.findByText('This is not the set-up code of this server.')).toBeInTheDocument()
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toMatchObject({ setup_code: 'ABCD-EFGH' })
  })

  test('with a mail server it asks for the address alone, and says to look into the mail', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': { open: true, by_mail: true },
      'POST /v1/sign-ups': null,
    })
    const user = userEvent.setup()
    openApp('/sign-up')
    await user.type(await screen.findByLabelText('Work email'), 'p@hull.example')
    await user.click(screen.getByRole('button', { name: 'Email me a link' }))
    expect(await screen.findByRole('heading', { name: 'Check your inbox' })).toBeInTheDocument()
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({ email: 'p@hull.example' })
  })

  test('the mailed link asks for the rest, the address being known', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-ups/s3cret': { email: 'p@hull.example' },
      'POST /v1/sign-ups/s3cret': () => {
        Object.assign(server.answers, asPerson(PRODUCER))
        return { id: 'x1', name: 'Producer', email: 'p@hull.example', email_verified_at: '2026-11-23T09:00:00Z' }
      },
    })
    const user = userEvent.setup()
    const app = openApp('/sign-up/s3cret')
    expect(await screen.findByLabelText('Work email')).toHaveValue('p@hull.example')
    expect(screen.getByLabelText('Work email')).toHaveAttribute('readonly')
    await user.type(screen.getByLabelText('Your name'), 'Producer')
    await user.type(screen.getByLabelText('Password'), 'four words of music')
    await user.click(screen.getByRole('button', { name: 'Create account' }))
    await waitFor(() => expect(app.at()).not.toBe('/sign-up/s3cret'))
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({
      name: 'Producer',
      password: 'four words of music',
    })
  })
})
