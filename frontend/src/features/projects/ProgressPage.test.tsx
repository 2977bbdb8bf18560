import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { build, REPORT } from '@/test/builds'
import { openApp } from '@/test/openApp'
import { anOverview, aProject, inProject } from '@/test/project'
import { answer, refusal, serve } from '@/test/server'

beforeAll(() => import('./ProgressPage'))
beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

describe('the progress page', () => {
  test('one cell a cue, the palette first; a cell says its state and leads to where it is dealt with', async () => {
    serve(inProject())
    openApp('/projects/p1/progress')
    const palette = await screen.findByRole('list', { name: 'Palette' })
    const rest = screen.getByRole('list', { name: 'The rest of the list' })
    expect(palette.compareDocumentPosition(rest)).toBe(Node.DOCUMENT_POSITION_FOLLOWING)
    expect(within(palette).getByRole('link', { name: 'SW-002 ui_confirm: Accepted' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list/cues/c2',
    )
    expect(within(rest).getByRole('link', { name: 'SW-001 shield_hit: To review' })).toHaveAttribute(
      'href',
      '/projects/p1/review/c1',
    )
    expect(screen.getByText('1 accepted, 1 waits for the approver')).toBeVisible()
    // The cut cue is drawn and not counted.
    expect(within(rest).getAllByRole('link')).toHaveLength(2)
    expect(screen.getByText('0 of 1 accepted')).toBeVisible()
  })

  test('the spec in words: what a master may be, limits with what follows, what is made of it', async () => {
    serve(inProject())
    openApp('/projects/p1/progress')
    const spec = await screen.findByRole('region', { name: 'Delivery spec' })
    expect(await within(spec).findByText('48 or 96 kHz')).toBeVisible()
    expect(within(spec).getByText('0.01–30 s')).toBeVisible()
    expect(within(spec).getByText('−1.0 dBTP')).toHaveTextContent('−1.0 dBTP, warns')
    expect(within(spec).getByText('−0.1 dBFS')).toHaveTextContent('−0.1 dBFS, returns')
    expect(within(spec).getByText('48 kHz, 16 bit, same as master')).toBeVisible()
    expect(await within(spec).findByRole('row', { name: 'music 1 music up to 300 s' })).toBeVisible()
    expect(within(spec).getByText(/General rules: impact \(1\)/)).toBeVisible()
  })

  test('`e` opens the spec for those who speak for the team', async () => {
    serve(inProject())
    const { at } = openApp('/projects/p1/progress')
    expect(await screen.findByRole('region', { name: 'Delivery spec' })).toBeVisible()
    await userEvent.keyboard('e')
    await waitFor(() => expect(at()).toBe('/projects/p1/spec'))
  })

  test('a designer sees cues, spec and what happened, and nothing of builds, packs and people', async () => {
    const { asked } = serve(inProject('designer', { 'GET /v1/projects/p1/desk': refusal(403, 'x', 'no desk') }))
    openApp('/projects/p1/progress')
    expect(await screen.findByRole('link', { name: 'SW-001 shield_hit: To review' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list/cues/c1',
    )
    expect(await screen.findByText('48 or 96 kHz')).toBeVisible()
    for (const name of ['Builds', 'Approved pack']) expect(screen.queryByRole('region', { name })).toBeNull()
    expect(screen.queryByRole('link', { name: 'People' })).toBeNull()
    expect(asked.some(({ path }) => /builds|pack|tokens|people/.test(path))).toBe(false)
  })

  test('an empty project says what to do first', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1/overview': anOverview({ steps: [], cues: 0, counts: {} }) }))
    openApp('/projects/p1/progress')
    expect(await screen.findByRole('heading', { name: 'No cues yet' })).toBeVisible()
    expect(screen.getByRole('link', { name: 'Import cues' })).toHaveAttribute('href', '/projects/p1/sound-list/import')
    expect(screen.getByRole('link', { name: 'Invite a designer' })).toHaveAttribute('href', '/projects/p1/people')
    expect(screen.getByText('No builds yet')).toBeVisible()
    expect(await screen.findByText('Nothing is accepted yet.')).toBeVisible()
  })

  test('a list that nobody works on asks for a designer', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1': aProject('producer', { engagements: [] }) }))
    openApp('/projects/p1/progress')
    expect(await screen.findByText('No designer yet')).toBeVisible()
  })

  test('a calendar link is made, and its address shown', async () => {
    const url = 'https://soundlist.example/v1/calendars/secret'
    serve(inProject('designer', { 'POST /v1/projects/p1/calendar': answer({ url }, 201) }))
    openApp('/projects/p1/progress')
    const card = await screen.findByRole('region', { name: 'Calendar' })
    await userEvent.click(within(card).getByRole('button', { name: 'Create calendar link' }))
    expect(await within(card).findByText(url)).toBeVisible()
    expect(within(card).queryByRole('button')).toBeNull()
  })

  test('a project that is not there says so', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1': refusal(404, 'project-not-found', 'no such project') }))
    openApp('/projects/p1/progress')
    expect(await screen.findByRole('heading', { name: 'Page not found' })).toBeVisible()
  })

  test('axe finds nothing', { tags: ['slow'] }, async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/overview': anOverview({ builds: [build('482', 1, 0)] }),
        'GET /v1/builds/b482': { report: REPORT },
      }),
    )
    openApp('/projects/p1/progress')
    await screen.findByText('assets/airlock.wav')
    const { violations } = await axe.run(document.body, {
      rules: { 'color-contrast': { enabled: false }, region: { enabled: false } },
    })
    expect(violations.map(({ id }) => id)).toEqual([])
  })
})
