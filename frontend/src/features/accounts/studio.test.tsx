import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { asPerson, PRODUCER, STUDIO } from '@/test/account'
import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

describe('the projects that members see', () => {
  test('a producer limits members to the projects they are in', async () => {
    const path = '/v1/studios/s1/members-see'
    const { asked, answers } = serve(
      asPerson(PRODUCER, {
        [`GET ${path}`]: { members_see: 'all' },
        [`PUT ${path}`]: { members_see: 'own' },
      }),
    )
    openApp('/studio')
    const card = within(await screen.findByRole('region', { name: 'Projects' }))
    const box = await card.findByRole('checkbox', { name: 'Only the projects they are in' })
    expect(box).not.toBeChecked()
    answers[`GET ${path}`] = { members_see: 'own' }
    await userEvent.click(box)
    await waitFor(() => expect(box).toBeChecked())
    expect(asked.find(({ method }) => method === 'PUT')?.body).toEqual({ members_see: 'own' })
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
    asPerson(PRODUCER, {
      'GET /v1/studios/s1/people': PEOPLE,
      'GET /v1/studios/s1/invitations': [],
      'GET /v1/studios/s1/outbox': { can_send: false, mails: [MAIL] },
      'GET /v1/studios/s1/quotas': QUOTAS,
      'GET /v1/studios/s1/members-see': { members_see: 'all' },
      'GET /v1/studios/s1/calendar': { time_zone: 'Europe/Berlin', holidays: [CHRISTMAS] },
      ...more,
    })

  test('a producer gives the studio its name, which an account without one has from its person', async () => {
    const { asked } = serve(studio({ 'PUT /v1/studios/s1': { id: 's1', name: 'Blue Hull' } }))
    openApp('/studio')
    const name = await screen.findByRole('textbox', { name: 'Studio name' })
    await userEvent.clear(name)
    await userEvent.type(name, 'Blue Hull{Enter}')
    await waitFor(() => expect(asked.find(({ method }) => method === 'PUT')?.body).toEqual({ name: 'Blue Hull' }))
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

  const ENDING = [
    { kind: 'approver', id: 'p1', name: 'Shield Wing', project_id: 'p1', project_name: 'Shield Wing' },
    { kind: 'category_approver', id: 'c1', name: 'ui', project_id: 'p1', project_name: 'Shield Wing' },
    { kind: 'token', id: 't1', name: 'CI', project_id: 'p1', project_name: 'Shield Wing' },
    { kind: 'webhook', id: 'w1', name: 'https://hooks.example/in', project_id: null, project_name: null },
  ]

  test(
    'who leaves hands over, and what they made is revoked or kept, seen before it happens',
    { tags: ['slow'] },
    async () => {
      const { asked } = serve(
        studio({
          'GET /v1/studios/s1/people/x2/departure': ENDING,
          'DELETE /v1/studios/s1/people/x2': null,
        }),
      )
      const user = userEvent.setup()
      openApp('/studio')
      await user.click(await screen.findByRole('button', { name: 'Roles of Audio director: Audio lead' }))
      await user.click(await screen.findByRole('menuitem', { name: 'Remove from the studio…' }))
      const dialog = within(await screen.findByRole('dialog', { name: 'Remove Audio director from the studio' }))
      expect(await dialog.findByText('Audio director approves Shield Wing.')).toBeInTheDocument()
      expect(dialog.getByRole('combobox', { name: 'Who approves from now on' })).toHaveDisplayValue('Producer')
      const rows = dialog.getAllByRole('listitem').map((row) => row.textContent)
      expect(rows).toEqual([
        'uiApprover of a category, Shield Wingends',
        'CIBuild token, Shield Wingrevoked',
        'https://hooks.example/inWebhookgoes on in your name',
      ])
      await user.click(dialog.getByRole('checkbox', { name: 'Keep their build tokens' }))
      await user.click(dialog.getByRole('button', { name: 'Remove from the studio' }))
      expect(await screen.findByText(/Audio director was removed from the studio/)).toBeInTheDocument()
      const removed = asked.find(({ method }) => method === 'DELETE')
      expect(removed?.query.getAll('keep')).toEqual(['tokens', 'webhooks'])
      expect(removed?.query.get('hand_over_to')).toBe('x1')
    },
  )

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

  test('who is not a producer sees the people and nothing to change', async () => {
    const me = { ...PRODUCER, studios: [{ ...STUDIO, roles: ['reviewer'] }] }
    const { asked } = serve(asPerson(me, { 'GET /v1/studios/s1/people': PEOPLE }))
    openApp('/studio')
    expect(await screen.findByText('Audio director')).toBeInTheDocument()
    expect(screen.queryByRole('region', { name: 'Sent emails' })).not.toBeInTheDocument()
    expect(asked.some(({ path }) => /(outbox|invitations|quotas)$/.test(path))).toBe(false)
  })
})
