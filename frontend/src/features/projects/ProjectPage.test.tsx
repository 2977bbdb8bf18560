import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject, people } from '@/test/project'
import { answer, refusal, serve, wrote } from '@/test/server'

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

describe('phases', () => {
  const PHASES = {
    phases: [
      {
        phase: 'palette',
        cues: 4,
        accepted: 1,
        is_open: true,
        is_done: false,
        awaited: [
          { who: 'Ida', act: 'deliver', count: 2 },
          { who: 'Tom', act: 'review', count: 1 },
        ],
      },
      { phase: 'beta', cues: 5, accepted: 0, is_open: false, is_done: false, awaited: [] },
    ],
    palette_approval: null,
    may_approve_palette: false,
    closed_cue_ids: [],
  }

  test('a gate says what is missing and who must act', async () => {
    serve({ ...inProject(), 'GET /v1/projects/p1/phases': PHASES })
    openApp('/projects/p1')
    const list = await screen.findByRole('list', { name: 'Phases' })
    expect(
      within(list).getByText('3 cues without an accepted version: Ida to deliver 2, Tom to review 1.'),
    ).toBeVisible()
    expect(within(list).getByText('opens when the previous phase is done')).toBeVisible()
    expect(within(list).getByRole('link', { name: 'Beta' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list?phase=beta',
    )
  })

  test('the approver approves the palette as a set', async () => {
    const { asked, answers } = serve({
      ...inProject(),
      'GET /v1/projects/p1/phases': { ...PHASES, may_approve_palette: true },
      'POST /v1/projects/p1/palette-approval': answer({}, 201),
    })
    openApp('/projects/p1')
    const button = await screen.findByRole('button', { name: 'Approve palette' })
    answers['GET /v1/projects/p1/phases'] = {
      ...PHASES,
      palette_approval: { approver: { id: 'x2', name: 'Audio director' }, created_at: '2026-11-20T10:00:00Z' },
    }
    await userEvent.click(button)
    expect(await screen.findByText('Audio director approved the palette as a set.')).toBeVisible()
    expect(wrote(asked, 'POST /v1/projects/p1/palette-approval')).toHaveLength(1)
  })
})
