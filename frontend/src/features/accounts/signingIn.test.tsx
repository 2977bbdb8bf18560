import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, AT_ONCE, DESIGNER, NOBODY, PRODUCER, signedIn } from '@/test/account'
import { openApp } from '@/test/openApp'
import { answer, refusal, serve } from '@/test/server'

import { ownPath } from './SignInPage'

describe('the guard', () => {
  test('a page asks nobody in: sign in first, then the page that was wanted', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/sign-in': () => {
        Object.assign(server.answers, asPerson(PRODUCER))
        return { id: 'x1', name: 'Producer', email: PRODUCER.email }
      },
    })
    const user = userEvent.setup()
    const app = openApp('/account')
    await screen.findByRole('heading', { name: 'Sign in' })
    expect(app.search()).toEqual({ next: '/account' })
    await user.type(screen.getByLabelText('Email'), PRODUCER.email)
    await user.type(screen.getByLabelText('Password'), 'a few words of mine')
    await user.click(screen.getByRole('button', { name: 'Sign in' }))
    await screen.findByRole('heading', { name: 'Account' })
    const sent = server.asked.find(({ path }) => path === '/v1/sign-in')
    expect(sent?.body).toEqual({ email: PRODUCER.email, password: 'a few words of mine' })
    expect(sent?.headers.get('X-CSRF-Token')).toBe('token-of-the-page')
  })

  test('who is signed out meanwhile is asked to sign in, not shown an error', async () => {
    serve({ 'GET /v1/session': signedIn(PRODUCER), 'GET /v1/me': refusal(401, 'not-signed-in', 'sign in first') })
    const app = openApp('/studio')
    await screen.findByRole('heading', { name: 'Sign in' })
    expect(app.search()).toEqual({ next: '/studio' })
  })

  test.each([
    [undefined, '/'],
    ['/projects/p1/desk', '/projects/p1/desk'],
    ['https://elsewhere.example', '/'],
    ['//elsewhere.example', '/'],
    ['/\\elsewhere.example', '/'],
  ])('after signing in, %s leads to %s', (next, path) => {
    expect(ownPath(next)).toBe(path)
  })
})

describe('signing in', () => {
  test('a wrong password is said, and what was typed stays', async () => {
    serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/sign-in': refusal(401, 'wrong-sign-in', 'address and password do not belong together', {
        fix: 'check both, or ask for a new password',
      }),
    })
    const user = userEvent.setup()
    openApp('/sign-in')
    await user.type(await screen.findByLabelText('Email'), 'me@sound.example')
    await user.type(screen.getByLabelText('Password'), 'not it at all')
    await user.click(screen.getByRole('button', { name: 'Sign in' }))
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'Address and password do not belong together. Check both, or ask for a new password.',
    )
    expect(screen.getByLabelText('Email')).toHaveValue('me@sound.example')
    expect(screen.getByLabelText('Password')).toHaveValue('not it at all')
  })

  test('empty fields are named, the first takes the focus, and nothing is sent', async () => {
    const { asked } = serve({ 'GET /v1/session': NOBODY })
    const user = userEvent.setup()
    openApp('/sign-in')
    await user.click(await screen.findByRole('button', { name: 'Sign in' }))
    expect(await screen.findByText('Email is required.')).toBeInTheDocument()
    expect(screen.getByText('Password is required.')).toBeInTheDocument()
    expect(screen.getByLabelText('Email')).toHaveFocus()
    expect(asked.filter(({ method }) => method === 'POST')).toEqual([])
  })

  test('a weak password of a new account is said at its field', async () => {
    serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/sign-up': refusal(422, 'password-too-weak', 'choose a password of At least 10 characters', {
        errors: [{ where: 'password', message: 'choose a password of At least 10 characters' }],
      }),
    })
    const user = userEvent.setup()
    openApp('/sign-up')
    await user.type(await screen.findByLabelText('Your name'), 'Producer')
    await user.type(screen.getByLabelText('Work email'), 'p@hull.example')
    await user.type(screen.getByLabelText('Password'), 'short')
    await user.click(screen.getByRole('button', { name: 'Create account' }))
    await waitFor(() =>
      expect(screen.getByLabelText('Password')).toHaveAccessibleDescription(
        expect.stringContaining('Choose a password of At least 10 characters.'),
      ),
    )
    expect(screen.getByLabelText('Work email')).toHaveValue('p@hull.example')
    expect(screen.getByLabelText('Password')).toHaveFocus()
  })

  test.each([
    [true, 'Email me a link', /we have sent it a link/],
    [false, 'Create a link', /a link to set a new password is ready/],
  ])('a forgotten password: the page says the same for every address, by mail: %s', async (byMail, action, says) => {
    const { asked } = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': { ...AT_ONCE, by_mail: byMail },
      'POST /v1/password-resets': answer(null, 202),
    })
    const user = userEvent.setup()
    openApp('/forgotten-password')
    await user.type(await screen.findByLabelText('Email'), 'who@sound.example')
    await user.click(await screen.findByRole('button', { name: action }))
    expect(await screen.findByText(/If who@sound\.example has an account/)).toHaveTextContent(says)
    expect(asked.find(({ path }) => path === '/v1/password-resets')?.body).toEqual({ email: 'who@sound.example' })
  })

  test('a used link for a new password says so', async () => {
    serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/password-resets/s3cret': refusal(404, 'reset-not-found', 'this link was used or is too old', {
        fix: 'ask for a new one',
      }),
    })
    const user = userEvent.setup()
    openApp('/new-password/s3cret')
    await user.type(await screen.findByLabelText('New password'), 'three new words here')
    await user.click(screen.getByRole('button', { name: 'Set password' }))
    expect(await screen.findByRole('alert')).toHaveTextContent('This link was used or is too old. Ask for a new one.')
  })
})

describe('the demo', () => {
  test('its visitor changes the part, and comes to that part’s own page', async () => {
    const server = serve(
      asPerson(
        PRODUCER,
        {
          'PUT /v1/demo/part/designer': () => {
            Object.assign(server.answers, asPerson(DESIGNER, {}, true))
            return { part: 'designer', parts: ['producer', 'approver', 'designer'] }
          },
        },
        true,
      ),
    )
    const user = userEvent.setup()
    const app = openApp('/account')
    await user.click(await screen.findByRole('button', { name: 'Producer: account and settings' }))
    expect(await screen.findByRole('menuitemradio', { name: 'Producer' })).toBeChecked()
    await user.click(screen.getByRole('menuitemradio', { name: 'Sound designer' }))
    await waitFor(() => expect(app.at()).toBe('/projects/p1/desk'))
    expect(await screen.findByRole('button', { name: 'Sound designer: account and settings' })).toBeInTheDocument()
  })

  test('outside of it there is nothing to switch', async () => {
    serve(asPerson(PRODUCER))
    const user = userEvent.setup()
    openApp('/account')
    await user.click(await screen.findByRole('button', { name: 'Producer: account and settings' }))
    await screen.findByRole('menuitem', { name: 'Account' })
    expect(screen.queryByText('View the demo as')).not.toBeInTheDocument()
  })
})
