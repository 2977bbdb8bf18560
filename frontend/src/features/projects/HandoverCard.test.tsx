import { screen, within } from '@testing-library/react'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { refusal, serve } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

const cue = (number: number) => ({ id: `c${number}`, label: `SW-0${number}`, name: `sound_${number}` })
const ENDED = {
  contract_id: 'k1',
  title: 'Effects',
  designer: 'Sound designer',
  ended_at: '2026-11-17T09:00:00Z',
  cues: Array.from({ length: 11 }, (_, at) => cue(at + 10)),
}
const ADDRESS = 'GET /v1/projects/p1/handovers'

test(
  'cues without a designer are named, with what the next one begins with and how to hire them',
  { tags: ['slow'] },
  async () => {
    serve({ ...inProject(), [ADDRESS]: [ENDED, { ...ENDED, contract_id: 'k2', title: 'Voices', cues: [cue(30)] }] })
    openApp('/projects/p1/progress')
    const card = within(await screen.findByRole('region', { name: '11 cues have no designer' }))
    expect(card.getByText(/SW-010 sound_10, .*SW-017 sound_17 and 3 more/)).toBeVisible()
    expect(card.getByText(/Effects with Sound designer ended/)).toBeVisible()
    const links = card.getAllByRole('link').map((link) => [link.textContent, link.getAttribute('href')])
    expect(links).toEqual([
      ['Write the next contract', '/projects/p1/contracts'],
      ['Invite a designer', '/projects/p1/people'],
      ['Download handover pack', '/v1/contracts/k1/handover'],
    ])
    expect(screen.getByRole('region', { name: '1 cue has no designer' })).toBeVisible()
    expect((await axe.run(document.body)).violations.map(({ id }) => id)).toEqual([])
  },
)

test('a refusal is shown', { tags: ['slow'] }, async () => {
  serve({ ...inProject(), [ADDRESS]: refusal(503, 'busy', 'the server is busy') })
  openApp('/projects/p1/progress')
  expect(await screen.findByText('The server is busy.')).toBeVisible()
})

test('a designer does not ask for it', async () => {
  const { asked } = serve(inProject('designer'))
  openApp('/projects/p1/progress')
  await screen.findByRole('region', { name: 'Pace' })
  expect(asked.some(({ path }) => path.endsWith('/handovers'))).toBe(false)
})
