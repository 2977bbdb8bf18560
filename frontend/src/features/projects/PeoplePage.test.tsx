import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aProject, inProject, people } from '@/test/project'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

describe('people', () => {
  const INVITATION = {
    id: 'i1',
    email: 'foley@sound.example',
    kind: 'contract',
    note: 'Six palette sounds first.',
    inviter: people.producer,
    created_at: '2026-11-20T10:00:00Z',
    expires_at: '2099-12-20T10:00:00Z',
    accepted_at: null,
  }

  test('a designer is invited by address, kind and note', async () => {
    const { asked, answers } = serve({ ...inProject(), 'POST /v1/projects/p1/invitations': answer(INVITATION, 201) })
    openApp('/projects/p1/people')
    fireEvent.change(await screen.findByLabelText('Email'), { target: { value: 'foley@sound.example' } })
    fireEvent.change(screen.getByLabelText(/Message/), { target: { value: 'Six palette sounds first.' } })
    answers['GET /v1/projects/p1/invitations'] = [INVITATION]
    await userEvent.click(screen.getByRole('button', { name: 'Send invitation' }))
    const open = await screen.findByRole('list', { name: 'Pending invitations' })
    expect(within(open).getByText('foley@sound.example')).toBeVisible()
    expect(wrote(asked, 'POST /v1/projects/p1/invitations')[0]?.body).toEqual({
      email: 'foley@sound.example',
      kind: 'contract',
      note: 'Six palette sounds first.',
    })
    expect(screen.getByLabelText('Email')).toHaveValue('')
  })

  test('a refused address keeps what was typed, with the reason below', async () => {
    const message = 'this designer is already on the project'
    serve({
      ...inProject(),
      'POST /v1/projects/p1/invitations': refusal(409, 'already-engaged', message, {
        errors: [{ where: 'email', message }],
      }),
    })
    openApp('/projects/p1/people')
    fireEvent.change(await screen.findByLabelText('Email'), { target: { value: 'designer@sound.example' } })
    await userEvent.click(screen.getByRole('button', { name: 'Send invitation' }))
    expect(await screen.findByText('This designer is already on the project.')).toBeVisible()
    expect(screen.getByLabelText('Email')).toHaveValue('designer@sound.example')
  })

  test('without a mail server the link of an invitation is there to copy', async () => {
    serve({
      ...inProject(),
      'GET /v1/projects/p1/invitations': [INVITATION],
      'GET /v1/projects/p1/mailed-links': {
        can_send: false,
        links: [{ of_id: 'i1', recipient: 'foley@sound.example', state: 'no_server', link: 'http://x/invitation/new' }],
      },
    })
    const press = userEvent.setup()
    openApp('/projects/p1/people')
    expect(await screen.findByText(/No mail server is set/)).toBeVisible()
    await press.click(screen.getByRole('button', { name: 'Copy link for foley@sound.example' }))
    expect(await navigator.clipboard.readText()).toBe('http://x/invitation/new')
  })

  test('an invitation is revoked', async () => {
    const { asked, answers } = serve({
      ...inProject(),
      'GET /v1/projects/p1/invitations': [INVITATION],
      'DELETE /v1/projects/p1/invitations/i1': answer(null, 204),
    })
    openApp('/projects/p1/people')
    const button = await screen.findByRole('button', { name: /^Revoke the invitation to foley/ })
    answers['GET /v1/projects/p1/invitations'] = []
    await userEvent.click(button)
    await waitFor(() => expect(screen.queryByText('foley@sound.example')).toBeNull())
    expect(wrote(asked, 'DELETE /v1/projects/p1/invitations/i1')).toHaveLength(1)
  })

  test('an engagement is ended, and taken up again by Undo', { tags: ['slow'] }, async () => {
    let ended = false
    const { asked } = serve({
      ...inProject(),
      'GET /v1/projects/p1': () =>
        aProject('producer', {
          engagements: [
            {
              id: 'e1',
              designer: people.designer,
              kind: 'contract',
              created_at: '2026-11-02T10:00:00Z',
              ended_at: ended ? '2026-11-21T10:00:00Z' : null,
            },
          ],
        }),
      'PATCH /v1/projects/p1/engagements/e1': ({ body }: Asked) => {
        ended = (body as { ended: boolean }).ended
        return {}
      },
    })
    openApp('/projects/p1/people')
    await userEvent.click(await screen.findByRole('button', { name: /^End/ }))
    expect(await screen.findByRole('button', { name: /^Resume/ })).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
    expect(await screen.findByRole('button', { name: /^End/ })).toBeVisible()
    expect(wrote(asked, 'PATCH /v1/projects/p1/engagements/e1').map(({ body }) => body)).toEqual([
      { ended: true },
      { ended: false },
    ])
  })

  test('a producer takes the last word over, with a reason that is kept', { tags: ['slow'] }, async () => {
    const { asked, answers } = serve({
      ...inProject(),
      'PUT /v1/projects/p1/approver': ({ body }: Asked) => {
        const change = body as { reason: string }
        answers['GET /v1/projects/p1/approver-history'] = [
          {
            person: people.producer,
            reason: change.reason,
            changer: people.producer,
            created_at: '2026-11-21T10:00:00Z',
          },
          {
            person: people.approver,
            reason: 'Knows the game',
            changer: people.producer,
            created_at: '2026-11-01T10:00:00Z',
          },
        ]
        return aProject('producer', { approver: people.producer })
      },
    })
    openApp('/projects/p1/approvers')
    await userEvent.click(await screen.findByRole('button', { name: 'Make me the approver' }))
    fireEvent.change(screen.getByLabelText('Reason (logged)'), { target: { value: 'Away until Monday' } })
    await userEvent.click(screen.getByRole('button', { name: 'Make approver' }))
    const had = await screen.findByRole('list', { name: 'Earlier approvers' })
    await waitFor(() => expect(within(had).getAllByRole('listitem')).toHaveLength(2))
    expect(within(had).getAllByRole('listitem')[0]).toHaveTextContent('Producer took over: Away until Monday.')
    expect(within(had).getAllByRole('listitem')[1]).toHaveTextContent(
      'Audio director named by Producer: Knows the game.',
    )
    expect(wrote(asked, 'PUT /v1/projects/p1/approver')[0]?.body).toEqual({
      person_id: 'x1',
      reason: 'Away until Monday',
    })
  })

  test('a reason must be given', { tags: ['slow'] }, async () => {
    const message = 'must have at least 1 character'
    serve({
      ...inProject(),
      'PUT /v1/projects/p1/approver': refusal(422, 'invalid', 'a field does not match', {
        errors: [{ where: 'reason', message }],
      }),
    })
    openApp('/projects/p1/approvers')
    await userEvent.click(await screen.findByRole('button', { name: 'Change approver' }))
    await userEvent.click(screen.getByRole('button', { name: 'Make approver' }))
    expect(await screen.findByText('Must have at least 1 character.')).toBeVisible()
  })

  test('an address is invited as the approver', async () => {
    const { asked } = serve({
      ...inProject(),
      'POST /v1/projects/p1/approver-invitations': { email: 'ana@shieldwing.test', is_named: false },
    })
    openApp('/projects/p1/approvers')
    const form = within(await screen.findByRole('form', { name: 'Invite an approver' }))
    await userEvent.type(form.getByLabelText('Approver’s email'), 'ana@shieldwing.test{Enter}')
    expect(await screen.findByText('ana@shieldwing.test is invited.')).toBeVisible()
    expect(wrote(asked, 'POST /v1/projects/p1/approver-invitations')).toHaveLength(1)
  })

  test('an audio lead is made; the approver stays one, and it is said why', async () => {
    const { asked } = serve({
      ...inProject(),
      'PUT /v1/projects/p1/liaisons/x4': aProject('producer', {
        liaisons: [people.approver, people.composer],
        audio_leads_warning: '3 audio leads speak for the team',
      }),
      'DELETE /v1/projects/p1/liaisons/x2': refusal(
        409,
        'liaison-is-approver',
        'this audio lead is the project’s approver',
        {
          fix: 'name another approver first',
        },
      ),
    })
    openApp('/projects/p1/people')
    await userEvent.click(await screen.findByRole('button', { name: 'Make audio lead: Composer' }))
    expect(await screen.findByRole('button', { name: 'Remove as audio lead: Composer' })).toBeVisible()
    expect(wrote(asked, 'PUT /v1/projects/p1/liaisons/x4')).toHaveLength(1)
    expect(screen.getByText('3 audio leads speak for the team.')).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Remove as audio lead: Audio director' }))
    const alert = await screen.findByRole('alert')
    expect(alert).toHaveTextContent('This audio lead is the project’s approver. Name another approver first.')
  })

  test('where members see their own projects only, a producer adds one to the project, and removes them after a question', async () => {
    const isIn = (...who: { id: string; name: string }[]) => ({
      members_see: 'own',
      members: who.map((person) => ({ person })),
    })
    const { asked, answers } = serve({
      ...inProject(),
      'GET /v1/projects/p1/members': isIn(people.producer, people.approver),
      'PUT /v1/projects/p1/members/x4': answer(null, 204),
      'DELETE /v1/projects/p1/members/x4': answer(null, 204),
    })
    openApp('/projects/p1/people')
    const add = await screen.findByRole('button', { name: 'Add to the project: Composer' })
    expect(screen.getByText(/^reviewer, not in the project/)).toBeVisible()
    answers['GET /v1/projects/p1/members'] = isIn(people.producer, people.approver, people.composer)
    await userEvent.click(add)
    const remove = await screen.findByRole('button', { name: 'Remove from the project: Composer' })
    expect(wrote(asked, 'PUT /v1/projects/p1/members/x4')).toHaveLength(1)
    await userEvent.click(remove)
    expect(wrote(asked, 'DELETE /v1/projects/p1/members/x4')).toHaveLength(0)
    const confirm = screen.getByRole('group', { name: 'Remove from project: Composer' })
    expect(confirm).toHaveTextContent('Build tokens that they made for it are revoked.')
    await userEvent.click(within(confirm).getByRole('button', { name: 'Remove from project' }))
    await waitFor(() => expect(wrote(asked, 'DELETE /v1/projects/p1/members/x4')).toHaveLength(1))
  })
})

describe('what designers hear of each other', () => {
  const LABEL = 'Approved sounds and those in review'

  test('a producer chooses, and takes it back by Undo', async () => {
    const { asked } = serve({
      ...inProject(),
      'PATCH /v1/projects/p1': ({ body }: Asked) => aProject('producer', body as Record<string, unknown>),
    })
    openApp('/projects/p1/approval')
    const group = await screen.findByRole('group', { name: 'Designers can play' })
    expect(within(group).getByRole('radio', { name: 'Approved sounds and the palette' })).toBeChecked()
    await userEvent.click(within(group).getByRole('radio', { name: LABEL }))
    await waitFor(() => expect(within(group).getByRole('radio', { name: LABEL })).toBeChecked())
    await userEvent.click(await screen.findByRole('button', { name: /Undo/ }))
    await waitFor(() =>
      expect(wrote(asked, 'PATCH /v1/projects/p1').map(({ body }) => body)).toEqual([
        { designers_hear: 'waiting' },
        { designers_hear: 'approved' },
      ]),
    )
  })

  test('others of the team read it', async () => {
    serve({ ...inProject('reviewer') })
    openApp('/projects/p1/approval')
    const card = await screen.findByRole('region', { name: 'What designers hear of each other' })
    expect(within(card).getByText('Approved sounds and the palette')).toBeVisible()
    expect(within(card).queryByRole('radio')).toBeNull()
  })
})
