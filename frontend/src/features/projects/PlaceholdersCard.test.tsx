import { screen, waitFor, within } from '@testing-library/react'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { refusal, serve } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

describe('placeholders', () => {
  const NEXT = {
    cue_id: 'c7',
    cue: 'SW-007',
    name: 'mine_arm',
    variation: 1,
    path: 'weapon/mine_arm.wav',
    category: 'weapon',
    state: 'missing',
    spoken: false,
    trigger: '',
    refusal: null,
  }
  const COUNTDOWN = {
    target: 'game',
    cues: 12,
    cues_left: 4,
    files: 20,
    left: 6,
    categories: [
      { category: '', files: 2, left: 1 },
      { category: 'ui', files: 8, left: 0 },
      { category: 'weapon', files: 10, left: 5 },
    ],
    next: NEXT,
  }
  const shown = async (countdown: unknown) => {
    serve(inProject('producer', { 'GET /v1/projects/p1/placeholders/countdown': countdown }))
    openApp('/projects/p1/progress')
    return screen.findByRole('region', { name: 'Placeholders' })
  }

  test('count down by category, with the next to record', async () => {
    const card = await shown(COUNTDOWN)
    expect(await within(card).findByText('4 of 12 cues without an accepted sound')).toBeVisible()
    expect(within(card).getByRole('img', { name: '14 of 20 files have an accepted sound' })).toBeVisible()
    expect(
      within(card)
        .getAllByRole('listitem')
        .map((each) => each.textContent),
    ).toEqual(['without a category1 of 2 files', 'weapon5 of 10 files'])
    const next = within(card).getByRole('link', { name: 'mine_arm' })
    expect(next).toHaveAttribute('href', '/projects/p1/sound-list/cues/c7')
    expect(card).toHaveTextContent('SW-007 weapon/mine_arm.wav')
    expect(within(card).getByRole('link', { name: /^All placeholders/ })).toHaveAttribute(
      'href',
      '/projects/p1/placeholders',
    )
  })

  test('that are all under way leave nothing to record', async () => {
    const card = await shown({ ...COUNTDOWN, next: null })
    expect(await within(card).findByText('All remaining cues have a version in progress.')).toBeVisible()
  })

  test('that are all replaced are said to be', async () => {
    const card = await shown({ ...COUNTDOWN, cues_left: 0, left: 0, next: null })
    expect(await within(card).findByText('none: every cue is accepted')).toBeVisible()
    expect(within(card).queryByText(/under way/)).toBeNull()
  })

  test('of a spec without a target are not spoken of', async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/placeholders/countdown': refusal(422, 'target-unknown', 'the spec has no target'),
      }),
    )
    openApp('/projects/p1/progress')
    await screen.findByRole('region', { name: 'Approved pack' })
    await waitFor(() => expect(screen.queryByRole('region', { name: 'Placeholders' })).toBeNull())
  })
})
