import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aMe, anItem, aPreview, aReview, aServer, aTake, PROJECT, somePeaks } from '@/test/review'
import { refusal } from '@/test/server'

import type { Masking, Scene, SceneLane } from './api'

beforeAll(() => Promise.all([import('../ReviewPage'), import('./SceneStage')]))

const THUMB = { points: 2, min: [-90, -20], max: [90, 20], rms: [40, 8] }
const aLane = (id: string, name: string, lane: Partial<SceneLane> = {}): SceneLane => ({
  id,
  name,
  cue_id: id,
  take_id: id,
  bed: null,
  reference_version_id: null,
  preview_url: `/v1/sounds/${id}/preview`,
  thumb: THUMB,
  duration_s: 0.8,
  loops: false,
  starts_s: [0.5],
  level_db: 0,
  level_from: 'approved',
  is_on: true,
  is_measured: true,
  problem: '',
  ...lane,
})
const music = aLane('music', 'Battle 2', {
  cue_id: null,
  take_id: null,
  bed: {
    id: 'bed-1',
    role: 'music',
    category: '',
    take_id: null,
    reference_id: 'reference-1',
    level_db: -18,
    is_on: true,
  },
  reference_version_id: 'version-1',
  preview_url: '/v1/scene-sounds/s1/preview',
  loops: true,
  level_db: -18,
  level_from: 'bed',
})
const aScene = (scene: Partial<Scene> = {}): Scene => ({
  take_id: 'a',
  cue_id: 'shield',
  category: 'weapon',
  length_s: 8,
  has_spots: true,
  audit_label: 'Build 481',
  lanes: [
    aLane('sound', 'shield_hit', { starts_s: [0.5, 3] }),
    aLane('engine', 'engine_idle_loop', { loops: true, starts_s: [0], level_db: -14, level_from: 'audit' }),
    music,
  ],
  clips: [],
  is_ready: true,
  may_change: true,
  ...scene,
})
const aMasking: Masking = {
  is_measured: true,
  is_compared: true,
  missing: '',
  bands: [
    { hz: 150, is_part: true, is_heard: false, sound_db: -40, cover_db: -30, margin_db: -10, covered_by: 'engine' },
    { hz: 2_200, is_part: true, is_heard: true, sound_db: -20, cover_db: -31, margin_db: 11, covered_by: 'music' },
    { hz: 9_000, is_part: false, is_heard: false, sound_db: null, cover_db: null, margin_db: null, covered_by: null },
  ],
  part_bands: 2,
  heard_bands: 1,
  energy_share: 0.99,
  time_share: 1,
  in_words: 'Heard in 1 of 2 bands. Clearest at 2.2 kHz, +11 dB. Covered by engine_idle_loop: 150 Hz.',
}

let server: ReturnType<typeof aServer>

beforeEach(() => {
  dismissToast()
  vi.stubGlobal('AudioContext', HandContext)
  const item = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a', { number: 1 }), aTake('b', { number: 2 })])
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', { items: [item], next: null })
    .on('GET /v1/review-queue/count', { cues: 1, is_all: true })
    .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
    .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
    .on(`GET /v1/projects/${PROJECT}/judged-lately`, [])
    .on('GET /v1/cues/shield/review', aReview(item))
    .on('POST /v1/takes/a/scene', aScene())
    .on('POST /v1/takes/b/scene', aScene({ take_id: 'b' }))
    .on('GET /v1/takes/a/masking', aMasking)
    .on('GET /v1/takes/b/masking', aMasking)
    .on('GET /v1/scene-sounds/s1/preview', aPreview)
    .on('POST /v1/reference-versions/version-1/openings', { status: 204, body: null })
  for (const id of ['a', 'b', 'engine']) {
    server.on(`GET /v1/sounds/${id}/preview`, aPreview).on(`GET /v1/sounds/${id}/peaks.json`, somePeaks)
  }
})

async function openScene() {
  const drawn = openApp(`/projects/${PROJECT}/review/shield`)
  await screen.findByRole('region', { name: 'Verdict' })
  await userEvent.keyboard('o')
  return { ...drawn, scene: within(await screen.findByRole('region', { name: 'Scene' })) }
}

test(
  'o opens the scene with its lanes, their levels and what is heard, and o closes it',
  { tags: ['slow'] },
  async () => {
    const { scene } = await openScene()
    const lanes = within(scene.getByRole('list', { name: 'Lanes' })).getAllByRole('listitem')
    expect(lanes.map((lane) => lane.textContent)).toEqual([
      expect.stringContaining('shield_hit2 times, from the list'),
      expect.stringContaining('engine_idle_loopthroughout, level of the build'),
      expect.stringContaining('Music, Battle 2whole project, throughout'),
    ])
    expect(scene.getByRole('slider', { name: 'Level of engine_idle_loop' })).toHaveValue('-14')
    expect(await scene.findByRole('img', { name: aMasking.in_words })).toBeVisible()
    expect(scene.getByText('1 of 2 bands, 99 % of its energy')).toBeVisible()
    expect(scene.getByText(/Levels of neighbours are those of Build 481/)).toBeVisible()
    await userEvent.keyboard('.')
    expect(await screen.findByRole('menuitemcheckbox', { name: 'Play in context' })).toBeChecked()
    await userEvent.keyboard('{Escape}')
    await userEvent.keyboard('o')
    await waitFor(() => expect(screen.queryByRole('region', { name: 'Scene' })).toBeNull())
  },
)

test('a sound alone gets no figure, and what is missing is said', async () => {
  const words = 'Not known yet: the scene has no bed and no neighbours.'
  const alone = { ...aMasking, is_compared: false, missing: words, in_words: words, bands: [], heard_bands: 0 }
  server.on('GET /v1/takes/a/masking', alone)
  const { scene } = await openScene()
  expect(await scene.findByText(words)).toBeVisible()
  expect(scene.queryByText(/bands/)).toBeNull()
})

test('the figures stand in a table too, with what covers each band', async () => {
  const { scene } = await openScene()
  await userEvent.click(await scene.findByText('Figures by band'))
  expect(scene.getByRole('row', { name: '150 −40.0 dB −30.0 dB covered engine_idle_loop' })).toBeVisible()
  expect(scene.getByRole('row', { name: '9,000 nothing any level' })).toBeVisible()
})

test('a lane that is muted covers nothing: the figure is asked for without it', async () => {
  const { scene } = await openScene()
  await scene.findByRole('img', { name: aMasking.in_words })
  const asked = () => server.of('GET /v1/takes/a/masking').map(({ query }) => query.getAll('lane'))
  expect(asked().at(-1)).toEqual(['sound:0', 'engine:-14', 'music:-18'])
  await userEvent.click(scene.getByRole('button', { name: 'Mute engine_idle_loop' }))
  await waitFor(() => expect(asked().at(-1)).toEqual(['sound:0', 'music:-18']))
})

test('changes to a bed are saved for everyone, once the level rests', async () => {
  server.on('PATCH /v1/beds/bed-1', music.bed)
  const { scene } = await openScene()
  const level = scene.getByRole('slider', { name: 'Level of Battle 2' })
  fireEvent.change(level, { target: { value: '-9.5' } })
  expect(server.of('PATCH /v1/beds/bed-1')).toHaveLength(0)
  fireEvent.pointerUp(level)
  await waitFor(() => expect(server.of('PATCH /v1/beds/bed-1').map(({ body }) => body)).toEqual([{ level_db: -9.5 }]))
  await userEvent.click(scene.getByRole('button', { name: 'Mute Battle 2' }))
  await waitFor(() => expect(server.of('PATCH /v1/beds/bed-1').at(-1)?.body).toEqual({ is_on: false }))
})

test('who only reviews changes no bed, and moves levels for themselves', async () => {
  server.on('POST /v1/takes/a/scene', aScene({ may_change: false }))
  const { scene } = await openScene()
  const level = scene.getByRole('slider', { name: 'Level of Battle 2' })
  fireEvent.change(level, { target: { value: '-9.5' } })
  fireEvent.pointerUp(level)
  expect(level).toHaveValue('-9.5')
  expect(scene.queryByRole('button', { name: /Add a bed|Remove/ })).toBeNull()
  expect(server.of('PATCH /v1/beds/bed-1')).toHaveLength(0)
})

test('a mix that would clip comes down as a whole, and the scene says by how much', async () => {
  // Each is one wave of half of full scale over the whole scene: 0.5 + 2 · 0.5 · 10^(6/20) is 7.9 dB over full scale.
  const loud = { durationS: 8, samples: Array.from({ length: 64 }, (_, at) => 0.5 * Math.sin((Math.PI * at) / 32)) }
  for (const id of ['a', 'b', 'engine']) server.on(`GET /v1/sounds/${id}/preview`, loud)
  server.on('GET /v1/scene-sounds/s1/preview', loud)
  const lanes = aScene().lanes.map((lane) => ({ ...lane, loops: true, starts_s: [0] }))
  const at = (lane: SceneLane | undefined, db: number) => (lane ? [{ ...lane, level_db: db }] : [])
  const louder = [...at(lanes[0], 0), ...at(lanes[1], 6), ...at(lanes[2], 6)]
  server.on('POST /v1/takes/a/scene', aScene({ lanes: louder }))
  const { scene } = await openScene()
  expect(await scene.findByText('All of it plays 8.9 dB lower, so that the mix does not clip.')).toBeVisible()
  await userEvent.click(scene.getByRole('button', { name: 'Mute Battle 2' }))
  await userEvent.click(scene.getByRole('button', { name: 'Mute engine_idle_loop' }))
  await waitFor(() => expect(scene.queryByText(/so that the mix does not clip/)).toBeNull())
})

test('the opening of a bed from the references is recorded before it is fetched', async () => {
  await openScene()
  await waitFor(() => expect(server.of('GET /v1/scene-sounds/s1/preview')).toHaveLength(1))
  const order = server.asked.map(({ path }) => path)
  expect(order.indexOf('/v1/reference-versions/version-1/openings')).toBeLessThan(
    order.indexOf('/v1/scene-sounds/s1/preview'),
  )
})

test('a bed is added under the whole project or under the category', async () => {
  server
    .on(`GET /v1/projects/${PROJECT}/bed-sources`, [
      { take_id: 'engine', reference_id: null, name: 'engine_idle_loop', loops: true },
      { take_id: null, reference_id: 'r2', name: 'Wind', loops: false },
    ])
    .on(`PUT /v1/projects/${PROJECT}/beds`, music.bed)
  const { scene } = await openScene()
  await userEvent.click(scene.getByRole('button', { name: 'Add a bed' }))
  const form = within(await scene.findByRole('form', { name: 'Add a bed' }))
  await userEvent.selectOptions(await form.findByLabelText('Sound'), 'Wind (reference)')
  await userEvent.selectOptions(form.getByLabelText('Plays as'), 'Music')
  await userEvent.selectOptions(form.getByLabelText('Under the sounds of'), 'weapon')
  await userEvent.click(form.getByRole('button', { name: 'Add' }))
  const put = () => server.of(`PUT /v1/projects/${PROJECT}/beds`)
  await waitFor(() => expect(put()).toHaveLength(1))
  expect(put()[0]?.body).toEqual({
    role: 'music', category: 'weapon', take_id: null, reference_id: 'r2', level_db: -12, is_on: true,
  }) // prettier-ignore
})

describe('the clip', () => {
  test('without one the page says how to add it', async () => {
    const { scene } = await openScene()
    expect(scene.getByText('No clip of the game is pinned to this cue.')).toBeVisible()
    expect(scene.getByRole('link', { name: 'Add a clip' })).toHaveAttribute('href', `/projects/${PROJECT}/references`)
  })

  const clip = {
    reference_id: 'r9',
    reference_version_id: 'v9',
    caption: 'Boarding, build 481',
    file_name: 'boarding.webm',
    media_type: 'video/webm',
    start_s: 2,
    end_s: 10,
  }

  test('is opened on the record, muted, and shows its time', async () => {
    server
      .on('POST /v1/takes/a/scene', aScene({ clips: [clip] }))
      .on('POST /v1/reference-versions/v9/openings', { status: 204, body: null })
    const { scene } = await openScene()
    const video = await scene.findByLabelText<HTMLVideoElement>('Boarding, build 481')
    await waitFor(() => expect(video).toHaveAttribute('src', '/v1/reference-versions/v9/file'))
    expect(video.muted).toBe(true)
    expect(scene.getByText('2.50 s')).toBeVisible()
  })

  test('that cannot be played here leaves its time and the sound', async () => {
    server
      .on('POST /v1/takes/a/scene', aScene({ clips: [clip] }))
      .on('POST /v1/reference-versions/v9/openings', { status: 204, body: null })
    const { scene } = await openScene()
    fireEvent.error(await scene.findByLabelText('Boarding, build 481'))
    expect(await scene.findByText(/This browser can’t play Boarding, build 481/)).toBeVisible()
    expect(scene.getByText('2.50 s')).toBeVisible()
  })
})

test('a scene that is refused says why', async () => {
  server.on('POST /v1/takes/a/scene', refusal(404, 'take-not-found', 'version a is for no cue yet'))
  openApp(`/projects/${PROJECT}/review/shield`)
  await screen.findByRole('region', { name: 'Verdict' })
  await userEvent.keyboard('o')
  expect(await screen.findByText(/version a is for no cue yet/i)).toBeVisible()
})

test('a designer hears their own sounds in the game too', async () => {
  server.on('GET /v1/me', aMe({ part: 'designer', is_liaison: false, is_approver: false }))
  openApp(`/projects/${PROJECT}/review/shield`)
  await screen.findByRole('region', { name: 'Verdict' })
  await userEvent.keyboard('.')
  expect(await screen.findByRole('menuitemcheckbox', { name: 'Play in context' })).toBeVisible()
})

describe('against another sound', () => {
  const made = {
    id: 'c1',
    is_made: true,
    lag_s: 0.0125,
    gain_db: 6,
    residue_db: -23,
    spectra: { hz: [100, 1_000], sound_dbfs: [-30, -40], against_dbfs: [-36, -46], difference_dbfs: [null, -53] },
    file_url: '/v1/comparisons/c1/file',
    refusal: null,
  }
  const opened = async () => {
    openApp(`/projects/${PROJECT}/review/shield`)
    await screen.findByRole('region', { name: 'Verdict' })
    await userEvent.keyboard('.')
    await userEvent.click(await screen.findByRole('menuitemcheckbox', { name: 'Against another sound' }))
    await userEvent.keyboard('{Escape}')
    return within(await screen.findByRole('region', { name: 'Against' }))
  }

  beforeEach(() => {
    const shown = { preview_url: '/v1/sounds/b/preview', state: 'drawn' }
    server
      .on(`GET /v1/projects/${PROJECT}/bed-sources`, [])
      .on('GET /v1/takes/b/sounds', { take_id: 'b', master: shown, fix: null, renders: [], closed: null })
      .on('POST /v1/takes/a/comparisons', made)
      .on('GET /v1/comparisons/c1/file', aPreview)
  })

  test('the figures say how both were aligned and what is left, and b plays the other', async () => {
    const panel = await opened()
    expect(
      await panel.findByText(/Aligned by 12.50 ms, level matched by \+6.0 dB. The difference is −23.0 dB relative/),
    ).toBeVisible()
    expect(server.of('POST /v1/takes/a/comparisons')[0]?.body).toEqual({ against_take_id: 'b' })
    const flip = panel.getByRole('button', { name: /⇄/ })
    await waitFor(() => expect(flip).toBeEnabled())
    await userEvent.keyboard('b')
    await waitFor(() => expect(flip).toHaveAttribute('aria-pressed', 'true'))
    await userEvent.keyboard('b')
    await waitFor(() => expect(flip).toHaveAttribute('aria-pressed', 'false'))
    await userEvent.click(panel.getByRole('button', { name: /^Difference/ }))
    await waitFor(() => expect(server.of('GET /v1/comparisons/c1/file')).toHaveLength(1))
  })

  test('what cannot be compared says why', async () => {
    server.on('POST /v1/takes/a/comparisons', refusal(409, 'nothing-to-compare', 'both are the same file'))
    const panel = await opened()
    expect(await panel.findByText(/both are the same file/i)).toBeVisible()
    expect(panel.getByRole('button', { name: /^Difference/ })).toBeDisabled()
  })
})

test('axe finds nothing', { tags: ['slow'] }, async () => {
  const { scene } = await openScene()
  await scene.findByRole('img', { name: aMasking.in_words })
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
})
