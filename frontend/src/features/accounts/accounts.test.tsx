import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, type Answers, refusal, serve } from '@/test/server'

import { ownPath } from './SignInPage'

const STUDIO = { id: 's1', name: 'Shield Wing studio', roles: ['producer'] }
const PROJECT = {
  id: 'p1',
  name: 'Shield Wing',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  cue_prefix: 'SW',
  part: 'team',
  is_producer: true,
  is_liaison: false,
  is_approver: false,
  engagement_kind: null,
}
const PRODUCER = {
  person: { id: 'x1', name: 'Producer' },
  email: 'producer@studio.example',
  email_verified_at: '2026-11-20T09:00:00Z' as string | null,
  studios: [STUDIO],
  projects: [PROJECT],
}
const DESIGNER = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  email_verified_at: null as string | null,
  studios: [],
  projects: [{ ...PROJECT, part: 'designer', is_producer: false, engagement_kind: 'contract' }],
}
const EMPTY_DESK = {
  came_back: [],
  to_make: [],
  with_approver: [],
  with_approver_files: 0,
  accepted: 0,
  cues: 0,
  unmatched: 0,
  checking: 0,
  questions: [],
}
const SIGN_INS = [
  {
    id: 'n1',
    device: 'Firefox on Linux',
    place: '192.0.2.7',
    is_current: true,
    created_at: '2026-11-20T09:00:00Z',
    last_seen_at: '2026-11-23T09:00:00Z',
    expires_at: '2026-12-20T09:00:00Z',
  },
  {
    id: 'n2',
    device: 'Safari on iOS',
    place: '192.0.2.8',
    is_current: false,
    created_at: '2026-11-19T09:00:00Z',
    last_seen_at: '2026-11-22T09:00:00Z',
    expires_at: '2026-12-19T09:00:00Z',
  },
  {
    id: 'n3',
    device: '',
    place: '192.0.2.9',
    is_current: false,
    created_at: '2026-11-18T09:00:00Z',
    last_seen_at: '2026-11-21T09:00:00Z',
    expires_at: '2026-12-18T09:00:00Z',
  },
]
const AT_ONCE = { open: true, by_mail: false }
const NOBODY = { signed_in: false, demo: false, person: null }
const signedIn = (me: typeof PRODUCER | typeof DESIGNER, demo = false) => ({ signed_in: true, demo, person: me.person })

/** The answers that every page of a signed-in person requests. */
const as = (me: typeof PRODUCER | typeof DESIGNER, more: Answers = {}, demo = false): Answers => ({
  'GET /v1/session': signedIn(me, demo),
  'GET /v1/me': me,
  'GET /v1/review-queue/count': { cues: 0, is_all: true },
  'GET /v1/projects/p1/desk': EMPTY_DESK,
  'GET /v1/me/sign-ins': SIGN_INS,
  'GET /v1/me/desk-tokens': [],
  ...more,
})

describe('the guard', () => {
  test('a page asks nobody in: sign in first, then the page that was wanted', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/sign-in': () => {
        Object.assign(server.answers, as(PRODUCER))
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

  test('a weak password of a new studio is said at its field', async () => {
    serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/sign-up': refusal(422, 'password-too-weak', 'choose a password of At least 10 characters', {
        errors: [{ where: 'password', message: 'choose a password of At least 10 characters' }],
      }),
    })
    const user = userEvent.setup()
    openApp('/sign-up')
    await user.type(await screen.findByLabelText('Studio name'), 'Blue Hull')
    await user.type(screen.getByLabelText('Your name'), 'Producer')
    await user.type(screen.getByLabelText('Email'), 'p@hull.example')
    await user.type(screen.getByLabelText('Password'), 'short')
    await user.click(screen.getByRole('button', { name: 'Create studio' }))
    await waitFor(() =>
      expect(screen.getByLabelText('Password')).toHaveAccessibleDescription(
        expect.stringContaining('Choose a password of At least 10 characters.'),
      ),
    )
    expect(screen.getByLabelText('Studio name')).toHaveValue('Blue Hull')
  })

  test('a forgotten password: the page says the same whoever asks', async () => {
    const { asked } = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': AT_ONCE,
      'POST /v1/password-resets': answer(null, 202),
    })
    const user = userEvent.setup()
    openApp('/forgotten-password')
    await user.type(await screen.findByLabelText('Email'), 'who@sound.example')
    await user.click(screen.getByRole('button', { name: 'Email me a link' }))
    expect(await screen.findByText(/If who@sound\.example has an account/)).toBeInTheDocument()
    expect(asked.at(-1)?.body).toEqual({ email: 'who@sound.example' })
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
      as(
        PRODUCER,
        {
          'PUT /v1/demo/part/designer': () => {
            Object.assign(server.answers, as(DESIGNER, {}, true))
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
    serve(as(PRODUCER))
    const user = userEvent.setup()
    openApp('/account')
    await user.click(await screen.findByRole('button', { name: 'Producer: account and settings' }))
    await screen.findByRole('menuitem', { name: 'Account' })
    expect(screen.queryByText('View the demo as')).not.toBeInTheDocument()
  })
})

describe('the studio', () => {
  const PEOPLE = [
    { person: PRODUCER.person, email: PRODUCER.email, roles: ['producer'], since: '2026-11-01T09:00:00Z' },
    {
      person: { id: 'x2', name: 'Audio director' },
      email: 'director@studio.example',
      roles: ['liaison'],
      since: '2026-11-01T09:00:00Z',
    },
  ]
  const MAIL = {
    id: 'm1',
    recipient: 'director@studio.example',
    subject: 'Shield Wing: sounds to review',
    text: 'Three sounds wait.',
    link: 'http://127.0.0.1:8000/projects/p1/review',
    created_at: '2026-11-17T09:00:00Z',
    sent_at: null,
    failure: null,
  }
  const QUOTAS = [
    { kind: 'master_bytes', used: 1_900_000_000_000, limit: 2_000_000_000_000, default: 2_000_000_000_000 },
    { kind: 'cues', used: 412, limit: 500_000, default: 500_000 },
    { kind: 'tokens', used: 5, limit: 5, default: 1_000 },
  ]
  const CHRISTMAS = { day: '2026-12-25', name: 'Christmas Day', created_at: '2026-01-01T00:00:00Z' }
  const studio = (more: Answers = {}) =>
    as(PRODUCER, {
      'GET /v1/studios/s1/people': PEOPLE,
      'GET /v1/studios/s1/invitations': [],
      'GET /v1/studios/s1/outbox': { can_send: false, mails: [MAIL] },
      'GET /v1/studios/s1/quotas': QUOTAS,
      'GET /v1/studios/s1/calendar': { time_zone: 'Europe/Berlin', holidays: [CHRISTMAS] },
      ...more,
    })

  test('a holiday is added to the calendar, and the others are kept', async () => {
    const { asked } = serve(
      studio({ 'PUT /v1/studios/s1/calendar': { time_zone: 'Europe/Berlin', holidays: [CHRISTMAS] } }),
    )
    openApp('/studio')
    const card = within(await screen.findByRole('region', { name: 'Calendar' }))
    expect(await card.findByText('Christmas Day')).toBeInTheDocument()
    fireEvent.change(card.getByLabelText(/^Holiday\b/), { target: { value: '2026-12-26' } })
    fireEvent.change(card.getByLabelText(/^Name\b/), { target: { value: 'Boxing Day' } })
    fireEvent.click(card.getByRole('button', { name: 'Add holiday' }))
    await waitFor(() => expect(asked.some(({ method }) => method === 'PUT')).toBe(true))
    expect(asked.find(({ method }) => method === 'PUT')?.body).toEqual({
      time_zone: 'Europe/Berlin',
      holidays: [
        { day: '2026-12-25', name: 'Christmas Day' },
        { day: '2026-12-26', name: 'Boxing Day' },
      ],
    })
  })

  test('roles are given by one press, and a refusal stays in the card', async () => {
    const { asked } = serve(
      studio({
        'PUT /v1/studios/s1/people/x1': refusal(409, 'last-producer', 'a studio always has a producer', {
          fix: 'make somebody else a producer first',
        }),
      }),
    )
    const user = userEvent.setup()
    openApp('/studio')
    await user.click(await screen.findByRole('button', { name: 'Roles of Producer: Producer' }))
    await user.click(await screen.findByRole('menuitemcheckbox', { name: /^Reviewer/ }))
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'A studio always has a producer. Make somebody else a producer first.',
    )
    expect(asked.find(({ method }) => method === 'PUT')?.body).toEqual({ roles: ['producer', 'reviewer'] })
  })

  test('the last role cannot be taken away by a slip', async () => {
    serve(studio())
    const user = userEvent.setup()
    openApp('/studio')
    await user.click(await screen.findByRole('button', { name: 'Roles of Audio director: Audio lead' }))
    expect(await screen.findByRole('menuitemcheckbox', { name: /^Audio lead/ })).toBeDisabled()
  })

  test('an invitation is sent with its roles; an address that is there already is said at the field', async () => {
    const taken = { where: 'email', message: 'director@studio.example is a member already' }
    const { asked } = serve(
      studio({
        'POST /v1/studios/s1/invitations': refusal(409, 'already-member', taken.message, { errors: [taken] }),
      }),
    )
    const user = userEvent.setup()
    openApp('/studio')
    const card = await screen.findByRole('region', { name: 'Invite a team member' })
    await user.type(within(card).getByLabelText('Email'), 'director@studio.example')
    await user.click(within(card).getByLabelText('Implementer'))
    await user.click(within(card).getByRole('button', { name: 'Invite' }))
    expect(await within(card).findByText('Director@studio.example is a member already.')).toBeInTheDocument()
    expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({
      email: 'director@studio.example',
      roles: ['reviewer', 'implementer'],
    })
  })

  test('without a mail server the links are there to copy', async () => {
    serve(studio())
    const user = userEvent.setup()
    openApp('/studio')
    await user.click(await screen.findByRole('button', { name: /^Copy link of “Shield Wing: sounds to review”/ }))
    await expect(navigator.clipboard.readText()).resolves.toBe(MAIL.link)
    expect(await screen.findByText('Link copied.')).toBeInTheDocument()
  })

  test('a producer sees how near each limit is, and what happens there', async () => {
    serve(studio())
    openApp('/studio')
    const card = await screen.findByRole('region', { name: 'Limits' })
    await within(card).findByText('1.9 TB of 2.0 TB')
    const [masters, cues, tokens] = within(card).getAllByRole('listitem')
    expect(masters).toHaveTextContent('Almost full New uploads are refused. Finished uploads are never refused.')
    expect(cues).toHaveTextContent('Cues412 of 500,000 At the limit: no cue can be added or imported.')
    expect(tokens).toHaveTextContent('5 of 5Limit reached Revoke a token to create another.')
    expect(within(card).getByRole('img', { name: 'Tokens: 5 of 5' })).toBeInTheDocument()
  })

  test('who is no producer sees the people and nothing to change', async () => {
    const me = { ...PRODUCER, studios: [{ ...STUDIO, roles: ['reviewer'] }] }
    const { asked } = serve(as(me, { 'GET /v1/studios/s1/people': PEOPLE }))
    openApp('/studio')
    expect(await screen.findByText('Audio director')).toBeInTheDocument()
    expect(screen.queryByRole('region', { name: 'Sent emails' })).not.toBeInTheDocument()
    expect(asked.some(({ path }) => /(outbox|invitations|quotas)$/.test(path))).toBe(false)
  })
})

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
        Object.assign(server.answers, as(PRODUCER))
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

  test('with a mail server it asks for the address alone, and says to look into the mail', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-up': { open: true, by_mail: true },
      'POST /v1/sign-ups': null,
    })
    const user = userEvent.setup()
    openApp('/sign-up')
    await user.type(await screen.findByLabelText('Email'), 'p@hull.example')
    await user.click(screen.getByRole('button', { name: 'Email me a link' }))
    expect(await screen.findByRole('heading', { name: 'Check your inbox' })).toBeInTheDocument()
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({ email: 'p@hull.example' })
  })

  test('the mailed link asks for the rest, the address being known', async () => {
    const server = serve({
      'GET /v1/session': NOBODY,
      'GET /v1/sign-ups/s3cret': { email: 'p@hull.example' },
      'POST /v1/sign-ups/s3cret': () => {
        Object.assign(server.answers, as(PRODUCER))
        return { id: 'x1', name: 'Producer', email: 'p@hull.example', email_verified_at: '2026-11-23T09:00:00Z' }
      },
    })
    const user = userEvent.setup()
    const app = openApp('/sign-up/s3cret')
    expect(await screen.findByLabelText('Email')).toHaveValue('p@hull.example')
    expect(screen.getByLabelText('Email')).toHaveAttribute('readonly')
    await user.type(screen.getByLabelText('Studio name'), 'Blue Hull')
    await user.type(screen.getByLabelText('Your name'), 'Producer')
    await user.type(screen.getByLabelText('Password'), 'four words of music')
    await user.click(screen.getByRole('button', { name: 'Create studio' }))
    await waitFor(() => expect(app.at()).not.toBe('/sign-up/s3cret'))
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({
      studio_name: 'Blue Hull',
      name: 'Producer',
      password: 'four words of music',
    })
  })
})

describe('the security of an account', () => {
  test('an address that is not verified says why it should be, and sends the link', async () => {
    const byMail = { open: true, by_mail: true }
    const server = serve(as(DESIGNER, { 'GET /v1/sign-up': byMail, 'POST /v1/me/email-verifications': null }))
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
    serve(as(DESIGNER, { 'GET /v1/sign-up': AT_ONCE, 'POST /v1/me/email-verifications': null }))
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
    serve(as(PRODUCER))
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Email' }))
    expect(card.getByText('Verified')).toBeInTheDocument()
    expect(card.queryByRole('button')).toBeNull()
  })

  test('every browser is listed, and another one is signed out', async () => {
    const server = serve(as(PRODUCER, { 'DELETE /v1/me/sign-ins/n2': null, 'DELETE /v1/me/sign-ins': null }))
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
      as(DESIGNER, {
        'GET /v1/me/desk-tokens': [token],
        'POST /v1/me/desk-tokens': { ...token, id: 'd2', name: 'Studio computer', secret: 'sld_secret' },
        'DELETE /v1/me/desk-tokens/d1': null,
      }),
    )
    const user = userEvent.setup()
    openApp('/account')
    const card = within(await screen.findByRole('region', { name: 'Desk tokens' }))
    expect(await card.findByRole('listitem')).toHaveTextContent(/Laptop.*never used/)
    await user.clear(card.getByLabelText('Token name'))
    await user.type(card.getByLabelText('Token name'), 'Studio computer')
    await user.click(card.getByRole('button', { name: 'Create token' }))
    expect(await card.findByText('sld_secret')).toBeInTheDocument()
    expect(server.asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: 'Studio computer' })
    await user.click(card.getByRole('button', { name: 'I’ve saved it' }))
    expect(card.queryByText('sld_secret')).toBeNull()
    await user.click(card.getByRole('button', { name: 'Revoke Laptop' }))
    await waitFor(() => expect(server.asked.some(({ method }) => method === 'DELETE')).toBe(true))
  })

  test('the game team has no desk tokens', async () => {
    serve(as(PRODUCER))
    openApp('/account')
    await screen.findByRole('region', { name: 'Active sessions' })
    expect(screen.queryByRole('region', { name: 'Desk tokens' })).toBeNull()
  })

  test('the mailed link verifies by a press', async () => {
    const server = serve(as(DESIGNER, { 'POST /v1/email-verifications/s3cret': { id: 'x3', name: 'x', email: 'x' } }))
    const user = userEvent.setup()
    openApp('/verify-address/s3cret')
    const press = await screen.findByRole('button', { name: 'Verify designer@sound.example' })
    expect(server.asked.filter(({ method }) => method === 'POST')).toEqual([])
    await user.click(press)
    expect(await screen.findByRole('heading', { name: 'Email verified' })).toBeInTheDocument()
  })

  test('a link of another account says so', async () => {
    serve(
      as(DESIGNER, {
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
