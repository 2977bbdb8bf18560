import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { type Asked, serve } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

describe('the approved pack', () => {
  const PACK = {
    target: 'game',
    targets: ['game', 'handheld'],
    files: 3,
    bytes: 5_329_528,
    masters_bytes: 6_584_164,
    cues_accepted: 2,
    cues_wanted: 5,
    missing: [],
  }

  test('each target with its files, its download with masters or without, and its key', async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/pack': ({ query }: Asked) =>
          query.get('target') === 'handheld'
            ? {
                ...PACK,
                target: 'handheld',
                files: 2,
                bytes: 1_400_000,
                missing: [
                  {
                    cue_id: 'c1',
                    label: 'SW-001',
                    name: 'shield_hit',
                    file_name: 'shield_hit.wav',
                    reason: 'not made yet',
                  },
                ],
              }
            : PACK,
      }),
    )
    openApp('/projects/p1/progress')
    const pack = await screen.findByRole('region', { name: 'Approved pack' })
    expect(await within(pack).findByText('2 of 5 cues')).toBeVisible()
    expect(within(pack).getByText('3 files, 5.3 MB')).toBeVisible()
    const game = within(pack).getByRole('link', { name: 'Download game' })
    expect(game).toHaveAttribute('href', '/v1/projects/p1/pack.zip?target=game')
    expect(within(pack).getByRole('link', { name: 'Documentation key of game as XLSX' })).toHaveAttribute(
      'href',
      '/v1/projects/p1/documentation-key.xlsx?target=game',
    )
    // What is missing is named, and its download leaves it out rather than being refused.
    expect(within(pack).getByText('1 accepted file missing')).toBeVisible()
    const handheld = within(pack).getByRole('link', { name: 'Download handheld without 1 missing file' })
    expect(handheld).toHaveAttribute('href', '/v1/projects/p1/pack.zip?target=handheld&allow_missing=true')
    await userEvent.click(within(pack).getByRole('checkbox', { name: 'With masters, 6.6 MB more' }))
    expect(game).toHaveAttribute('href', '/v1/projects/p1/pack.zip?target=game&masters=true')
  })
})
