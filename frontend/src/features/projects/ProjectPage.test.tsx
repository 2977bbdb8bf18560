import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject, people } from '@/test/project'
import { refusal, serve } from '@/test/server'

beforeAll(() => import('./ProjectPage'))

const STEP = { contract_id: null, posting_id: null, subject: '', who: '', count: 0, since: null }
const AWAITED = { kind: 'verdicts', who: 'Audio director', person_id: 'x2', picture: null, count: 4, subject: '' }
const next = {
  'GET /v1/projects/p1/next-steps': {
    steps: [
      { ...STEP, kind: 'write_brief' },
      { ...STEP, kind: 'invite_designer' },
    ],
    awaited: [{ ...AWAITED, since: null }],
  },
}

describe('the overview of a project', () => {
  test('the next step has the button and the Enter key; the one after it is named', async () => {
    serve(inProject('producer', next))
    const { at } = openApp('/projects/p1')
    const step = within(await screen.findByRole('region', { name: 'Next step' }))
    expect(step.getByRole('link', { name: /Write the brief/ })).toHaveAttribute('href', '/projects/p1/brief')
    expect(step.getByText(/Then: Invite a sound designer\./)).toBeVisible()
    await userEvent.keyboard('{Enter}')
    await waitFor(() => expect(at()).toBe('/projects/p1/brief'))
  })

  test('four cards, at most 20 things to press', async () => {
    serve(inProject('producer', next))
    openApp('/projects/p1')
    const sounds = await screen.findByRole('region', { name: 'Sounds' })
    expect(await within(sounds).findByText('1 of 2')).toBeVisible()
    expect(within(sounds).getByRole('link', { name: 'Open list' })).toHaveAttribute('href', '/projects/p1/sound-list')
    const row = within(screen.getByRole('region', { name: 'People' }))
      .getByText('Audio director')
      .closest('li')
    await waitFor(() => expect(row).toHaveTextContent(/Approver\s*to judge 4 cues/))
    for (const name of ['Money', /^Next pack/]) expect(screen.getByRole('region', { name })).toBeVisible()
    const main = within(screen.getByRole('main'))
    expect(main.queryAllByRole('link').length + main.queryAllByRole('button').length).toBeLessThanOrEqual(20)
  })

  test.each([
    ['1', '/projects/p1/sound-list'],
    ['2', '/projects/p1/people'],
    ['3', '/projects/p1/money'],
    ['4', '/projects/p1/packs'],
  ])('the key %s opens its card', async (key, path) => {
    serve(inProject('producer', next))
    const { at } = openApp('/projects/p1')
    await screen.findByRole('region', { name: /^Next pack/ })
    await userEvent.keyboard(key)
    await waitFor(() => expect(at()).toBe(path))
  })

  test('a card that could not be read says so, and the others stand', async () => {
    serve(inProject('producer', { ...next, 'GET /v1/projects/p1/money': refusal(500, 'broken', 'the sums broke') }))
    openApp('/projects/p1')
    const card = await screen.findByRole('region', { name: 'Money' })
    expect(await within(card).findByRole('alert')).toHaveTextContent('The sums broke.')
    expect(screen.getByRole('region', { name: 'Sounds' })).toBeVisible()
  })

  test('leads a designer to the playlists that hold their sounds', async () => {
    const combat = { id: 'l1', name: 'Combat', takes: 3, made_by: people.producer, created_at: '2026-11-20T10:00:00Z' }
    serve(inProject('designer', { 'GET /v1/projects/p1/playlists': [combat] }))
    openApp('/projects/p1')
    const card = await screen.findByRole('region', { name: /^Playlists with your sounds/ })
    expect(within(card).getByRole('link', { name: 'Combat' })).toHaveAttribute('href', '/projects/p1/playlists/l1')
    expect(card).toHaveTextContent('3 sounds, by Producer')
  })

  test('a project that is not there says so', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1': refusal(404, 'project-not-found', 'no such project') }))
    openApp('/projects/p1')
    expect(await screen.findByRole('heading', { name: 'Page not found' })).toBeVisible()
  })
})
