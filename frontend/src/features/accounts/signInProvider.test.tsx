import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, AT_ONCE, NOBODY, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

import { domainOf } from './providerApi'

const GUEST = { 'GET /v1/session': NOBODY, 'GET /v1/sign-up': AT_ONCE }

describe('the sign-in provider of a studio', () => {
  test.each([
    ['ada@Studio.Example', 'studio.example'],
    ['ada@studio', ''],
    ['ada@', ''],
    ['', ''],
  ])('%s is of the domain "%s"', (email, domain) => {
    expect(domainOf(email)).toBe(domain)
  })

  test('its button appears once an address of its domain is typed, and names what stands in the way', async () => {
    const server = serve({
      ...GUEST,
      'GET /v1/sign-in/provider': { studio_id: 's1', studio_name: 'Night Studio' },
      'POST /v1/sign-in/oidc/start': refusal(404, 'provider-not-found', 'no sign-in provider of a studio s1'),
    })
    const user = userEvent.setup()
    openApp('/sign-in?next=/account')
    await user.type(await screen.findByLabelText('Email'), 'ada@studio.example')
    await user.click(await screen.findByRole('button', { name: 'Sign in with Night Studio' }))
    expect(await screen.findByText('No sign-in provider of a studio s1.')).toBeVisible()
    const lookups = server.asked.filter(({ path }) => path === '/v1/sign-in/provider')
    expect(lookups.at(-1)?.query.get('domain')).toBe('studio.example')
    const begun = server.asked.find(({ path }) => path === '/v1/sign-in/oidc/start')
    expect(begun?.body).toEqual({ studio_id: 's1', next_path: '/account' })
  })

  test('its answer is sent once and leads to the page that was wanted', async () => {
    const server = serve({
      ...GUEST,
      'POST /v1/sign-in/oidc/callback': () => {
        Object.assign(server.answers, asPerson(PRODUCER))
        return { second_factor_needed: false, next_path: '/account' }
      },
    })
    openApp('/sign-in/provider?code=c1&state=s-t&iss=https%3A%2F%2Flogin.example')
    expect(await screen.findByRole('heading', { name: 'Account' })).toBeVisible()
    const sent = server.asked.filter(({ path }) => path === '/v1/sign-in/oidc/callback')
    expect(sent.map(({ body }) => body)).toEqual([{ code: 'c1', state: 's-t', iss: 'https://login.example' }])
  })

  test('the second factor of the account is asked for after it', async () => {
    const server = serve({
      ...GUEST,
      'POST /v1/sign-in/oidc/callback': { second_factor_needed: true, next_path: '/account' },
      'POST /v1/sign-in/oidc/code': () => {
        Object.assign(server.answers, asPerson(PRODUCER))
        return { second_factor_needed: false, next_path: '/account' }
      },
    })
    const user = userEvent.setup()
    openApp('/sign-in/provider?code=c1&state=s-t')
    await user.type(await screen.findByLabelText('Code'), '123456')
    await user.click(screen.getByRole('button', { name: 'Sign in' }))
    expect(await screen.findByRole('heading', { name: 'Account' })).toBeVisible()
    expect(server.asked.find(({ path }) => path === '/v1/sign-in/oidc/code')?.body).toEqual({ code: '123456' })
  })

  test('a refusal is said, with a way back', async () => {
    serve({
      ...GUEST,
      'POST /v1/sign-in/oidc/callback': refusal(403, 'provider-sign-in-refused', 'the sign-in took too long'),
    })
    openApp('/sign-in/provider?code=c1&state=s-t')
    expect(await screen.findByText('The sign-in took too long.')).toBeVisible()
    expect(screen.getByRole('link', { name: 'Back to Sign in' })).toBeVisible()
  })

  test('what the provider refuses itself is said too', async () => {
    serve(GUEST)
    openApp('/sign-in/provider?error=access_denied&state=s-t')
    expect(await screen.findByText('The provider did not sign you in.')).toBeVisible()
  })

  test('a producer sets it and removes it', async () => {
    const path = '/v1/studios/s1/sign-in-provider'
    const none = { issuer: null, client_id: null, domains: ['studio.example'], redirect_uri: 'https://s.example/p' }
    const server = serve(
      asPerson(PRODUCER, {
        [`GET ${path}`]: none,
        [`PUT ${path}`]: { ...none, issuer: 'https://login.studio.example', client_id: 'soundlist' },
        [`DELETE ${path}`]: null,
      }),
    )
    const user = userEvent.setup()
    openApp('/studio')
    const card = within(await screen.findByRole('region', { name: 'Sign-in provider' }))
    expect(await card.findByText(/Signs in addresses of studio.example/)).toBeVisible()
    await user.type(card.getByLabelText('Issuer'), 'https://login.studio.example')
    await user.type(card.getByLabelText('Client ID'), 'soundlist')
    await user.type(card.getByLabelText('Client secret'), 'secret')
    await user.click(card.getByRole('button', { name: 'Save provider' }))
    expect(await card.findByText('https://login.studio.example')).toBeVisible()
    expect(server.asked.find(({ method }) => method === 'PUT')?.body).toEqual({
      issuer: 'https://login.studio.example',
      client_id: 'soundlist',
      client_secret: 'secret',
    })
    await user.click(card.getByRole('button', { name: 'Remove provider' }))
    await waitFor(() => expect(card.getByLabelText('Issuer')).toBeVisible())
  })
})
