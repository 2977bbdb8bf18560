import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aProject, inProject } from '@/test/project'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

describe('projects', () => {
  const firstTime = () => {
    const answers = inProject()
    return { ...answers, 'GET /v1/me': { ...(answers['GET /v1/me'] as object), projects: [] } }
  }

  test('a producer without a project begins by creating one, and sees why', async () => {
    serve(firstTime())
    const { at } = openApp('/projects')
    expect(await screen.findByRole('heading', { name: 'What is the game called?' })).toBeVisible()
    expect(at()).toBe('/projects/new')
    expect(screen.getAllByRole('textbox')).toHaveLength(1)
  })

  test('a designer without a project finds the postings that are for them', async () => {
    const answers = inProject()
    const posting = { id: 'p1', title: 'Effects for Alpha', studio_name: 'Lantern Games', state: 'open' }
    serve({
      ...answers,
      'GET /v1/me': { ...(answers['GET /v1/me'] as object), studios: [], projects: [] },
      'GET /v1/projects': { items: [], next: null },
      'GET /v1/postings': [{ ...posting, takes_bids: true, bids_until_on: '2027-01-05', own_bid: null }],
    })
    openApp('/projects')
    const card = await screen.findByRole('region', { name: 'Postings for you' })
    expect(within(card).getByRole('link', { name: 'Effects for Alpha' })).toHaveAttribute('href', '/postings/p1')
    expect(card).toHaveTextContent('bid until')
  })

  test('the prefix follows the name until it is typed; the new project opens on its list', async () => {
    const { asked } = serve({
      ...firstTime(),
      'POST /v1/projects': answer({ ...aProject(), id: 'p9' }, 201),
      'GET /v1/projects/p9/sound-list': { revision: 0, cues: [] },
    })
    const { at } = openApp('/projects/new')
    await userEvent.type(await screen.findByLabelText('Game title'), 'Deep Field')
    expect(screen.getByText(/Cue numbers start with DF\./)).toHaveTextContent('Masters: 48 or 96 kHz')
    await userEvent.click(screen.getByRole('button', { name: 'More options' }))
    expect(screen.getByLabelText('Cue ID prefix')).toHaveValue('DF')
    await userEvent.clear(screen.getByLabelText('Cue ID prefix'))
    await userEvent.type(screen.getByLabelText('Cue ID prefix'), 'dfl')
    await userEvent.type(screen.getByLabelText('Game title'), ' Two')
    expect(screen.getByLabelText('Cue ID prefix')).toHaveValue('DFL')
    await userEvent.click(screen.getByRole('radio', { name: 'Game standard: 48 kHz / 24 bit' }))
    await userEvent.click(screen.getByRole('button', { name: 'Create project' }))
    await waitFor(() => expect(at()).toBe('/projects/p9/sound-list'))
    expect(wrote(asked, 'POST /v1/projects')[0]?.body).toEqual({
      studio_id: 's1',
      name: 'Deep Field Two',
      cue_prefix: 'DFL',
      description: '',
      preset: '48k',
    })
  })

  test('a refused name stands at its field, and nothing typed is lost', async () => {
    const message = 'must have at least 1 character'
    serve({
      ...firstTime(),
      'POST /v1/projects': refusal(422, 'invalid', 'a field does not match', { errors: [{ where: 'name', message }] }),
    })
    openApp('/projects/new')
    await userEvent.type(await screen.findByLabelText('Game title'), 'Rivers')
    await userEvent.click(screen.getByRole('button', { name: 'More options' }))
    await userEvent.type(screen.getByLabelText(/Description/), 'A game of rivers')
    await userEvent.click(screen.getByRole('button', { name: 'Create project' }))
    expect(await screen.findByText('Must have at least 1 character.')).toBeVisible()
    expect(screen.getByLabelText('Game title')).toHaveAccessibleDescription('Must have at least 1 character.')
    expect(screen.getByLabelText(/Description/)).toHaveValue('A game of rivers')
  })

  test('people who create no projects see who does', async () => {
    serve(inProject('reviewer'))
    openApp('/projects/new')
    expect(await screen.findByRole('heading', { name: 'Only producers create projects' })).toBeVisible()
    expect(screen.queryByRole('button', { name: 'Create project' })).toBeNull()
  })

  test('the list shows one’s role in each; archived ones are separate', async () => {
    const { asked } = serve({
      ...inProject(),
      'GET /v1/projects': ({ query }: Asked) => ({
        items:
          query.get('archived') === 'true' ? [] : [aProject(), aProject('designer', { id: 'p2', name: 'Deep Field' })],
        next: null,
      }),
    })
    openApp('/projects')
    const rows = within(await screen.findByRole('list', { name: 'Projects' })).getAllByRole('listitem')
    expect(rows[0]).toHaveTextContent(/Shield Wing.*you are a producer.*approver: Audio director/)
    expect(rows[1]).toHaveTextContent(/Deep Field.*sound designer, contractor/)
    await userEvent.click(screen.getByRole('button', { name: 'Archived' }))
    expect(await screen.findByText('No archived projects')).toBeVisible()
    expect(wrote(asked, 'GET /v1/projects').at(-1)?.query.get('archived')).toBe('true')
  })

  test('a project is renamed in its settings', async () => {
    const { asked } = serve({
      ...inProject(),
      'PATCH /v1/projects/p1': ({ body }: Asked) => aProject('producer', body as Record<string, unknown>),
    })
    openApp('/projects/p1/settings')
    await userEvent.clear(await screen.findByLabelText('Name'))
    await userEvent.type(screen.getByLabelText('Name'), 'Shield Wing II')
    await userEvent.click(screen.getByRole('button', { name: 'Save' }))
    expect(await screen.findByText('Shield Wing II updated.')).toBeVisible()
    expect(wrote(asked, 'PATCH /v1/projects/p1')[0]?.body).toMatchObject({ name: 'Shield Wing II', cue_prefix: 'SW' })
  })
})
