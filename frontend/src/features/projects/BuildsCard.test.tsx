import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { build, REPORT } from '@/test/builds'
import { openApp } from '@/test/openApp'
import { anOverview, inProject, people } from '@/test/project'
import { answer, refusal, serve, wrote } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

describe('builds', () => {
  const withBuilds = () =>
    inProject('producer', {
      'GET /v1/projects/p1/overview': anOverview({
        builds: [build('482', 2, 0), build('481', 0, 3), build('480', 0, 0)],
      }),
      'GET /v1/builds/b482': { report: REPORT },
    })

  test('the squares are described in words; the latest names what it refuses, and a waived file is none of it', async () => {
    serve(withBuilds())
    openApp('/projects/p1/progress')
    expect(await screen.findByRole('img', { name: '3 builds: 1 passed, 1 with warnings, 1 refused' })).toBeVisible()
    const refused = await screen.findByRole('list', { name: 'Refused files' })
    expect(within(refused).getByText('assets/airlock.wav')).toBeVisible()
    expect(within(refused).getByText('Sample rate 44100 Hz')).toBeVisible()
    expect(within(refused).getByText(', accepted 48000 Hz. Render it again.')).toBeVisible()
    expect(within(refused).getByText('Unreadable')).toBeVisible()
    expect(within(refused).queryByText('assets/let_through.wav')).toBeNull()
    expect(within(refused).queryByText(/true peak/i)).toBeNull()
  })

  test('the copy button takes the one command that does everything', async () => {
    serve(withBuilds())
    const press = userEvent.setup()
    openApp('/projects/p1/progress')
    await press.click(await screen.findByRole('button', { name: 'Copy the CI command' }))
    expect(await navigator.clipboard.readText()).toBe(
      'curl soundlist.pyz && python3 -I soundlist.pyz ci --target game assets/',
    )
  })

  test('a token’s secret is shown once, with what it is for', async () => {
    const made = {
      id: 't1',
      name: 'Nightly',
      scopes: ['spec:read'],
      creator: people.producer,
      created_at: '2026-11-20T10:00:00Z',
      last_used_at: null,
      expires_at: '2126-11-20T10:00:00Z',
      revoked_at: null,
    }
    const { asked } = serve({
      ...withBuilds(),
      'POST /v1/projects/p1/tokens': answer({ ...made, secret: 'slt_once' }, 201),
    })
    const press = userEvent.setup()
    openApp('/projects/p1/progress')
    await press.click(await screen.findByRole('button', { name: 'Create token' }))
    const name = screen.getByLabelText('Token name')
    await press.clear(name)
    await press.type(name, 'Nightly')
    await press.selectOptions(screen.getByLabelText('Works for'), '90 days')
    await press.click(screen.getByRole('button', { name: 'Create token' }))
    expect(await screen.findByText('slt_once')).toBeVisible()
    expect(wrote(asked, 'POST /v1/projects/p1/tokens')[0]?.body).toEqual({
      name: 'Nightly',
      scopes: ['spec:read', 'list:read', 'checks:write', 'manifest:read'],
      days: 90,
    })
    await press.click(screen.getByRole('button', { name: 'Copy secret' }))
    expect(await navigator.clipboard.readText()).toBe('slt_once')
    await press.click(screen.getByRole('button', { name: 'I’ve saved it' }))
    expect(screen.queryByText('slt_once')).toBeNull()
  })

  test('a token reads contracts and sources only where that was chosen', async () => {
    const { asked } = serve({ ...withBuilds(), 'POST /v1/projects/p1/tokens': refusal(422, 'invalid', 'no') })
    const press = userEvent.setup()
    openApp('/projects/p1/progress')
    await press.click(await screen.findByRole('button', { name: 'Create token' }))
    await press.click(screen.getByRole('checkbox', { name: 'Also reads contracts and sources of approved sounds' }))
    await press.click(screen.getByRole('button', { name: 'Create token' }))
    await waitFor(() => expect(wrote(asked, 'POST /v1/projects/p1/tokens')).toHaveLength(1))
    expect(wrote(asked, 'POST /v1/projects/p1/tokens')[0]?.body).toMatchObject({
      scopes: ['spec:read', 'list:read', 'checks:write', 'manifest:read', 'rights:read'],
    })
  })

  test('a token that has ended says so, and is not to be revoked', async () => {
    const token = {
      id: 't1',
      name: 'Nightly',
      scopes: ['spec:read'],
      creator: people.producer,
      created_at: '2025-01-01T10:00:00Z',
      last_used_at: null,
      expires_at: '2025-03-01T10:00:00Z',
      revoked_at: null,
    }
    serve({
      ...withBuilds(),
      'GET /v1/projects/p1/tokens': [token],
    })
    openApp('/projects/p1/tokens')
    expect(await screen.findByText('Ended')).toBeVisible()
    expect(screen.getByText(/ended Saturday 1 March 2025/)).toBeVisible()
    expect(screen.queryByRole('button', { name: 'Revoke Nightly' })).toBeNull()
  })

  test('a token is revoked only after it was said what that does', async () => {
    const token = {
      id: 't1',
      name: 'Nightly',
      scopes: ['spec:read'],
      creator: people.producer,
      created_at: '2026-11-20T10:00:00Z',
      last_used_at: null,
      expires_at: '2126-11-20T10:00:00Z',
      revoked_at: null,
    }
    const { asked, answers } = serve({
      ...withBuilds(),
      'GET /v1/projects/p1/tokens': [token],
      'DELETE /v1/projects/p1/tokens/t1': answer(null, 204),
    })
    const press = userEvent.setup()
    openApp('/projects/p1/tokens')
    await press.click(await screen.findByRole('button', { name: 'Revoke Nightly' }))
    expect(wrote(asked, 'DELETE /v1/projects/p1/tokens/t1')).toHaveLength(0)
    answers['GET /v1/projects/p1/tokens'] = [{ ...token, revoked_at: '2026-11-21T10:00:00Z' }]
    await press.click(screen.getByRole('button', { name: 'Revoke “Nightly”' }))
    expect(await screen.findByText('Revoked')).toBeVisible()
    expect(wrote(asked, 'DELETE /v1/projects/p1/tokens/t1')).toHaveLength(1)
  })
})
