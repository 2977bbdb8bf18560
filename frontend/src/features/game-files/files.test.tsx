import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, refusal, serve } from '@/test/server'

const NOW = '2026-11-20T10:00:00Z'
const takes = (category: string | null, memory: number, budget: number | null, more = {}) => ({
  category,
  files: 2,
  unknown_files: 0,
  pcm_bytes: memory * 4,
  disk_bytes: memory,
  memory_bytes: memory,
  budget_bytes: budget,
  over_bytes: budget === null ? null : memory - budget,
  ...more,
})
const TARGETS = {
  targets: [
    {
      name: 'unity',
      engine: 'Unity',
      accepts: 'WAV, AIFF, Ogg Vorbis and MP3 of up to 8 channels',
      why: 'So mono is made here.',
      sample_rate_hz: 48000,
      bit_depth: 16,
      encoding: 'pcm',
      channels: 1,
      dither: 'tpdf',
      folder: 'Assets/Audio/{category}',
      codec_ratio: 3.5,
      streamed: false,
      used: { total: takes(null, 1_000_000, 4_000_000), categories: [takes('weapon', 1_000_000, null)] },
      forecast: {
        total: takes(null, 5_000_000, 4_000_000),
        categories: [takes('weapon', 2_000_000, 3_000_000), takes('ambience', 3_000_000, null, { unknown_files: 7 })],
      },
    },
  ],
  presets: [{ name: 'raw', engine: 'An engine of one’s own', accepts: 'WAV', why: 'PCM.', toml: '[targets.raw]\n' }],
}
const batch = (more = {}) => ({
  id: 'b1',
  number: 3,
  state: 'running',
  targets: [],
  by_spec: true,
  note: '',
  created_at: NOW,
  ended_at: null,
  files: 10,
  waiting: 6,
  made: 3,
  kept: 0,
  refused: 1,
  left: 0,
  ...more,
})
const SIZES = [
  { target: 'unity', category: 'weapon', files: 10, before_bytes: 4000, after_bytes: 2000 },
  { target: 'trailer', category: 'ui', files: 1, before_bytes: 0, after_bytes: 1000 },
  { target: 'trailer', category: 'weapon', files: 1, before_bytes: 0, after_bytes: 2000 },
]
const TROUBLE = [{ cue: 'SW-002', name: 'ui_confirm', target: 'unity', reason: 'the master has 44100 Hz' }]
const onPage = (more = {}) =>
  inProject('producer', {
    'GET /v1/projects/p1/targets': TARGETS,
    'GET /v1/projects/p1/batches': { items: [batch()], next: null },
    'GET /v1/batches/b1': { ...batch(), sizes: SIZES, trouble: TROUBLE },
    ...more,
  })
const clean = async () => {
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
}

describe('game files', () => {
  test('each target says its format, whom it is for, and by how much its memory is over', async () => {
    serve(onPage())
    openApp('/projects/p1/game-files')
    const unity = await screen.findByRole('region', { name: 'Target unity' })
    expect(within(unity).getByText('48 kHz, 16 bit, mono')).toBeVisible()
    expect(within(unity).getByText('resident, codec 3.5 : 1')).toBeVisible()
    expect(within(unity).getByText('5.0 MB, over by 1.0 MB')).toBeVisible()
    expect(within(unity).getByText('2.0 MB, 1.0 MB under')).toBeVisible()
    expect(
      within(unity).getByRole('img', { name: /Memory of unity: all 5.0 MB, over by 1.0 MB; weapon/ }),
    ).toBeVisible()
    await userEvent.click(within(unity).getByText('Show as table'))
    const row = within(unity).getByRole('row', { name: /^ambience/ })
    expect(row).toHaveTextContent('ambience270 bytes3.0 MB3.0 MBnone')
    await clean()
  })

  test('a batch says how far it is, what it does to the sizes, what it cannot make, and can be stopped', async () => {
    let state = batch()
    const { asked } = serve(
      onPage({
        'GET /v1/projects/p1/batches': () => ({ items: [state], next: null }),
        'POST /v1/batches/b1/cancel': () => {
          state = batch({ state: 'cancelled', note: 'cancelled by hand' })
          return { ...state, sizes: [], trouble: [] }
        },
      }),
    )
    openApp('/projects/p1/game-files')
    const line = await screen.findByRole('listitem', { name: 'Batch 3' })
    expect(within(line).getByRole('status')).toHaveTextContent('4 of 10 files: 3 rendered, 1 refused, 6 to render.')
    const sizes = await within(line).findByRole('table', { name: 'Sizes of batch 3' })
    expect(within(sizes).getByRole('row', { name: /^unity/ })).toHaveTextContent('−2.0 kB')
    expect(within(line).getByRole('img', { name: /^Sizes of batch 3/ })).toHaveAccessibleName(
      'Sizes of batch 3: unity 4.0 kB before, 2.0 kB after; trailer none before, 3.0 kB after',
    )
    expect(within(line).getByText(/The master has 44100 Hz/)).toBeVisible()
    await userEvent.click(await within(line).findByRole('button', { name: /^Stop\s*Batch 3$/ }))
    await waitFor(() => expect(within(line).queryByRole('button', { name: /Stop/ })).toBeNull())
    expect(asked.some(({ method, path }) => `${method} ${path}` === 'POST /v1/batches/b1/cancel')).toBe(true)
    expect(within(line).getByText(/6 not rendered/)).toBeVisible()
  })

  test('without a batch it says what begins one; a refusal stands in the card', async () => {
    serve(
      onPage({
        'GET /v1/projects/p1/batches': { items: [], next: null },
        'POST /v1/projects/p1/batches': refusal(409, 'nothing-to-render', 'no version conforms yet'),
      }),
    )
    openApp('/projects/p1/game-files')
    expect(await screen.findByText('No re-renders yet')).toBeVisible()
    await userEvent.click(await screen.findByRole('button', { name: 'Re-render all game files' }))
    expect(await screen.findByText('No version conforms yet.')).toBeVisible()
  })
})

describe('packs', () => {
  const PACK = {
    id: 'k1',
    target: 'unity',
    number: 2,
    note: 'for the alpha',
    with_masters: false,
    placeholders: true,
    handoff: 'wwise',
    state: 'sealed',
    refusal: '',
    sealed_by: 'Composer',
    created_at: NOW,
    sealed_at: NOW,
    files: 41,
    placeholder_files: 9,
    bytes: 5_000_000,
  }
  const CHANGES = { since: 1, new: 1, changed: 1, gone: 0, same: 39, paths: [{ path: 'a/laser.wav', kind: 'changed' }] }
  const NEXT = {
    target: 'unity',
    targets: ['unity'],
    files: 42,
    bytes: 5_100_000,
    masters_bytes: 1,
    cues_accepted: 2,
    cues_wanted: 5,
    handoff: 'wwise',
    changes: { ...CHANGES, since: 2 },
    missing: [],
  }

  test('sealed packs with what changed, and the next one sealed', { tags: ['slow'] }, async () => {
    const { asked } = serve(
      onPage({
        'GET /v1/projects/p1/packs': { items: [PACK], next: null },
        'GET /v1/packs/k1': { ...PACK, changes: CHANGES },
        'GET /v1/projects/p1/pack': NEXT,
        'POST /v1/projects/p1/packs': answer({ ...PACK, id: 'k2', state: 'sealing' }, 201),
      }),
    )
    openApp('/projects/p1/packs')
    const line = await screen.findByRole('listitem', { name: 'Pack unity 2' })
    expect(within(line).getByText('With placeholders')).toBeVisible()
    expect(within(line).getByText(/^Sealed by Composer .*, for Wwise\./)).toBeVisible()
    expect(within(line).getByText('41 files, 9 placeholders, 5.0 MB')).toBeVisible()
    expect(within(line).getByRole('link', { name: 'Download pack unity 2' })).toHaveAttribute(
      'href',
      '/v1/packs/k1/pack.zip',
    )
    await userEvent.click(within(line).getByText(/What changed/))
    expect(await within(line).findByText('Since pack 1: 1 new, 1 changed, 39 unchanged.')).toBeVisible()
    expect(within(line).getByText('a/laser.wav')).toBeVisible()
    expect(await screen.findByText(/42 files, 5.1 MB; since pack 2/)).toBeVisible()
    await userEvent.type(screen.getByRole('textbox', { name: 'Note' }), 'beta')
    await userEvent.click(screen.getByRole('checkbox', { name: 'With placeholders for sounds that are not accepted' }))
    await userEvent.click(screen.getByRole('button', { name: 'Seal pack' }))
    await waitFor(() => {
      const sent = asked.find(({ method, path }) => `${method} ${path}` === 'POST /v1/projects/p1/packs')
      expect(sent?.body).toEqual({
        target: 'unity',
        note: 'beta',
        masters: false,
        placeholders: true,
        handoff: 'wwise',
        allow_missing: false,
      })
    })
    await clean()
  })

  test('import files are for the engine of the last pack, until another is chosen', async () => {
    const { asked } = serve(
      onPage({
        'GET /v1/projects/p1/packs': { items: [], next: null },
        'GET /v1/projects/p1/pack': NEXT,
        'POST /v1/projects/p1/packs': answer({ ...PACK, id: 'k2', state: 'sealing' }, 201),
      }),
    )
    openApp('/projects/p1/packs')
    const engine = await screen.findByRole('combobox', { name: 'Import files for' })
    await waitFor(() => expect(engine).toHaveValue('Wwise'))
    expect(engine).toHaveAccessibleDescription(/^Tables for the tab-delimited import/)
    await userEvent.click(engine)
    await userEvent.click(await screen.findByRole('option', { name: 'Godot' }))
    expect(engine).toHaveAccessibleDescription('Import files beside the sounds, and a randomizer for each set.')
    await userEvent.click(screen.getByRole('button', { name: 'Seal pack' }))
    await waitFor(() => {
      const sent = asked.find(({ method, path }) => `${method} ${path}` === 'POST /v1/projects/p1/packs')
      expect(sent?.body).toMatchObject({ handoff: 'godot' })
    })
    await clean()
  })
})

describe('placeholders', () => {
  const item = (path: string, state: string, more = {}) => ({
    cue_id: path,
    cue: 'SW-001',
    name: 'Siren',
    variation: 1,
    path,
    category: '',
    state,
    spoken: false,
    trigger: '',
    refusal: null,
    ...more,
  })
  const REGISTER = {
    target: 'game',
    targets: ['game', 'handheld'],
    files: 10,
    replaced: 8,
    left: 2,
    made: 1,
    items: [item('siren.wav', 'missing'), item('hum.wav', 'made', { spoken: true })],
  }

  test('the register counts down, and what lacks a placeholder-file is made', async () => {
    const { asked } = serve(
      onPage({
        'GET /v1/projects/p1/placeholders': REGISTER,
        'POST /v1/projects/p1/placeholders': answer(null, 202),
      }),
    )
    openApp('/projects/p1/placeholders')
    expect(await screen.findByRole('heading', { name: '2 files left' })).toBeVisible()
    expect(screen.getByText('8 of 10 replaced by accepted sounds')).toBeVisible()
    expect(screen.getByText('spoken placeholder')).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Generate 1 placeholder' }))
    await waitFor(() => expect(asked.some(({ method }) => method === 'POST')).toBe(true))
    await clean()
  })

  test('when nothing is left it says so', async () => {
    serve(onPage({ 'GET /v1/projects/p1/placeholders': { ...REGISTER, left: 0, made: 0, replaced: 10, items: [] } }))
    openApp('/projects/p1/placeholders')
    expect(await screen.findByText('No placeholders')).toBeVisible()
  })
})
