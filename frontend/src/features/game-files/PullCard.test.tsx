import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { serve } from '@/test/server'

import { pullCommands } from './pullCommands'

const target = (name: string) => ({
  name,
  engine: null,
  accepts: null,
  why: null,
  sample_rate_hz: 48000,
  bit_depth: 16,
  encoding: 'pcm',
  channels: 1,
  dither: 'tpdf',
  folder: '',
  codec_ratio: 1,
  streamed: false,
  used: { total: {}, categories: [] },
  forecast: { total: {}, categories: [] },
})
const PACK = { target: 'pc', targets: ['pc', 'handheld'], files: 0, bytes: 0, masters_bytes: 0, cues_accepted: 0 }
const CHANGES = { since: null, new: 0, changed: 0, gone: 0, same: 0, paths: [] }
const onPacks = () =>
  inProject('producer', {
    'GET /v1/projects/p1/targets': { targets: [target('pc'), target('handheld')], presets: [] },
    'GET /v1/projects/p1/packs': { items: [], next: null },
    'GET /v1/projects/p1/pack': { ...PACK, cues_wanted: 3, changes: CHANGES, missing: [] },
  })

describe('Pulling into a game', () => {
  test('the commands of the chosen target are copied', async () => {
    serve(onPacks())
    const person = userEvent.setup()
    openApp('/projects/p1/packs')
    const card = await screen.findByRole('region', { name: 'Pull into your game' })
    const commands = within(card).getByRole('region', { name: 'Pull commands' })
    expect(commands).toHaveTextContent('soundlist.pyz pull --server http://localhost:3000 --project p1 --target pc')
    await person.click(within(card).getByRole('combobox', { name: 'Target to pull' }))
    await person.click(await screen.findByRole('option', { name: 'handheld' }))
    await person.click(within(card).getByRole('button', { name: 'Copy the pull commands' }))
    expect(await navigator.clipboard.readText()).toBe(
      [
        'curl -fsSO -H "Authorization: Bearer $SOUNDLIST_TOKEN" http://localhost:3000/v1/projects/p1/soundlist.pyz',
        'python3 soundlist.pyz pull --server http://localhost:3000 --project p1 --target handheld',
      ].join('\n'),
    )
    expect(await screen.findByText('Commands copied.')).toBeVisible()
    const download = within(card).getByRole('link', { name: 'Download soundlist.pyz' })
    expect(download).toHaveAttribute('href', '/v1/projects/p1/soundlist.pyz')
    const { violations } = await axe.run(card, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
  })

  test.each([
    ['pc', 'pc'],
    ['old pc', "'old pc'"],
    ["it's; rm -rf", "'it'\\''s; rm -rf'"],
    ['-x', "'-x'"],
  ])('a target of any name stays one word: %s', (name, word) => {
    expect(pullCommands('https://sounds.example', 'p1', name)[1]).toSatisfy((line: string) =>
      line.endsWith(`--target ${word}`),
    )
  })
})
