import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

import type { AuditedSound } from './api'
import { groupsOf } from './groups'
import { louder } from './louder'
import { proposedDb } from './SoundToJudge'
import { describeChange } from './words'

const AT = '2026-11-20T10:00:00Z'
const WHO = { id: 'x1', name: 'Producer' }

beforeEach(() => {
  localStorage.clear()
  vi.stubGlobal('AudioContext', HandContext)
})

const audit = (label: string, drifted: number, new_drifts: number) => ({
  id: `a${label}`,
  label,
  commit: '',
  target: 'game',
  engine: 'wwise',
  sounds: 3,
  drifted,
  new_drifts,
  created_at: AT,
})
const sound = (place: number, more: object = {}): AuditedSound => ({
  place,
  path: `foot_deck_walk_0${place}.wav`,
  cue: { id: 'c1', label: 'SW-008', name: 'foot_deck_walk' },
  status: 'gain',
  played_status: 'gain',
  has_drifted: true,
  is_new: true,
  gain_db: 6,
  file_db: 0,
  property_db: 6,
  message: 'the game plays it 6.0 dB louder',
  moves: [
    {
      object: '\\Sounds\\foot_deck_walk',
      property: 'Volume',
      file: 'x.wwu',
      approved_db: 0,
      gain_db: 6,
      changelist: { id: '48211', on: '2026-11-19', subject: 'Raise the footsteps' },
    },
  ],
  depends: [],
  events: ['Play_foot_deck_walk'],
  accepted: null,
  task_id: null,
  sound: null,
  ...more,
})

const STATES = {
  cues: 3,
  in_build: 2,
  heard: 1,
  never_heard: 2,
  build: '482',
  categories: [{ category: 'foley', cues: 3, heard: 1 }],
  unheard: [
    { cue: { id: 'c3', label: 'SW-021', name: 'void_whale' }, category: 'creature', in_build: null, heard: null },
  ],
  may_mark: true,
}
const TASK = {
  id: 'k1',
  cue: { id: 'c1', label: 'SW-008', name: 'foot_deck_walk' },
  path: 'foot_deck_walk_01.wav',
  kind: 'too-loud',
  role: 'implementer',
  gain_db: -6,
  where: '\\Sounds\\foot_deck_walk, Volume',
  text: 'crunches over the dialogue',
  asked_by: WHO,
  asked_at: AT,
  done_at: null,
  may_do: true,
}

const drift = (more: object = {}) =>
  inProject('producer', {
    'GET /v1/projects/p1/audits': { items: [audit('482', 2, 2), audit('481', 0, 0)], next: null },
    'GET /v1/audits/a482': { ...audit('482', 2, 2), before: '481', accepted: 0, depends: 0, unread: [] },
    'GET /v1/audits/a482/sounds': { items: [sound(1), sound(2)], next: null },
    'GET /v1/projects/p1/sound-history': [],
    'GET /v1/projects/p1/game-states': STATES,
    'GET /v1/projects/p1/game-tasks': { items: [TASK], next: null },
    'GET /v1/projects/p1/ci': { command: 'python3 -I soundlist.pyz ci assets/', lines: ['audio-checks audit assets/'] },
    'POST /v1/audits/a482/accepted-drifts': answer({}, 201),
    'POST /v1/audits/a482/tasks': answer(TASK, 201),
    'PUT /v1/cues/c3/game-state': STATES,
    'PUT /v1/game-tasks/k1': { ...TASK, done_at: AT },
    ...more,
  })

const bodies = (asked: readonly Asked[], what: string) => wrote(asked, what).map(({ body }) => body)

test('a set that drifted alike is one row, with what changed it and who is not named', { tags: ['slow'] }, async () => {
  serve(drift())
  openApp('/projects/p1/drift')
  expect(await screen.findByRole('heading', { level: 1, name: 'Build 482' })).toBeVisible()
  const row = await screen.findByRole('button', { name: /foot_deck_walk 2 files ?new ?Louder/ })
  expect(row).toHaveTextContent('\\Sounds\\foot_deck_walk, Volume')
  expect(row).toHaveTextContent('48211')
  expect(row).toHaveTextContent('+6.0 dB')
  expect(screen.getByText(/last 2: 1 as approved, 0 with known drift, 1 with new drift/)).toBeVisible()
  expect(screen.getByText('Never heard in the game: 2')).toBeVisible()
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
})

test('drift is accepted with a reason only, for every file of the set', { tags: ['slow'] }, async () => {
  const { asked } = serve(drift())
  const press = userEvent.setup()
  openApp('/projects/p1/drift')
  await screen.findByRole('button', { name: /^Accept \+6.0 dB/ })
  await press.keyboard('a')
  expect(await screen.findByRole('alert')).toHaveTextContent('needs a reason')
  expect(bodies(asked, 'POST /v1/audits/a482/accepted-drifts')).toEqual([])
  const reason = screen.getByRole('textbox', { name: 'Reason, or what to do' })
  await press.type(reason, 'quiet under the music')
  await press.click(screen.getByRole('button', { name: /^Accept \+6.0 dB/ }))
  await waitFor(() => expect(bodies(asked, 'POST /v1/audits/a482/accepted-drifts')).toHaveLength(2))
  expect(bodies(asked, 'POST /v1/audits/a482/accepted-drifts')).toEqual([
    { path: 'foot_deck_walk_01.wav', reason: 'quiet under the music' },
    { path: 'foot_deck_walk_02.wav', reason: 'quiet under the music' },
  ])
})

test('a sound is sent back by one key, and a state is set by hand', async () => {
  const { asked } = serve(drift())
  const press = userEvent.setup()
  openApp('/projects/p1/drift')
  await screen.findByRole('button', { name: /^Send back/ })
  await press.keyboard('s')
  await waitFor(() => expect(bodies(asked, 'POST /v1/audits/a482/tasks')).toHaveLength(2))
  await press.click(screen.getByText(/never heard$/))
  await press.click(screen.getByRole('button', { name: 'void_whale: heard in the game' }))
  await waitFor(() => expect(bodies(asked, 'PUT /v1/cues/c3/game-state')).toEqual([{ mark: 'heard', is_set: true }]))
})

test('without a build the page has the commands', async () => {
  serve(drift({ 'GET /v1/projects/p1/audits': { items: [], next: null } }))
  openApp('/projects/p1/drift')
  expect(await screen.findByText('No build was audited yet')).toBeVisible()
  expect(await screen.findByText(/soundlist.pyz ci assets/)).toBeVisible()
})

test('a task is marked as done', async () => {
  const { asked } = serve(drift())
  const press = userEvent.setup()
  openApp('/projects/p1/game-tasks')
  const tasks = await screen.findByRole('region', { name: 'Tasks' })
  expect(await within(tasks).findByText('crunches over the dialogue')).toBeVisible()
  await press.click(within(tasks).getByRole('button', { name: 'Done: foot_deck_walk' }))
  await waitFor(() => expect(bodies(asked, 'PUT /v1/game-tasks/k1')).toEqual([{ is_done: true }]))
})

const cue = (id: string, name: string, more: object = {}) => ({
  cue: { id, label: `SW-${id}`, name },
  category: 'foley',
  description: '',
  events: [`Play_${name}`],
  files: 1,
  gain_db: 0,
  message: '',
  depends: [],
  move: null,
  suggested_db: null,
  sound: null,
  heard: false,
  ...more,
})
const LOUD = cue('c1', 'foot_deck_walk', { gain_db: 6, suggested_db: -6, files: 6 })
const pass = (notes: object[] = []) => ({
  listening_pass: {
    id: 'l1',
    audit: audit('482', 2, 2),
    started_at: AT,
    is_newest: true,
    people: 1,
    heard: 0,
    cues: [LOUD, cue('c2', 'dock_clamp'), cue('c3', 'radar_ping')],
    notes,
    may_close: true,
  },
  newest_audit: audit('482', 2, 2),
})
const listening = (more: object = {}) =>
  inProject('producer', {
    'GET /v1/projects/p1/listening-pass': pass(),
    'POST /v1/listening-passes/l1/notes': answer({}, 201),
    ...more,
  })
const NOTES = 'POST /v1/listening-passes/l1/notes'

test('one key and Enter keep a note with the gain that brings the approved level back', async () => {
  const { asked } = serve(listening())
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  expect(await screen.findByRole('heading', { level: 2, name: 'foot_deck_walk' })).toBeVisible()
  await press.keyboard('1')
  expect(screen.getByRole('button', { name: /^Too loud/ })).toHaveAttribute('aria-pressed', 'true')
  expect(screen.getByRole('status', { name: 'Suggested gain' })).toHaveTextContent('−6.0 dB')
  expect(bodies(asked, NOTES)).toEqual([])
  await press.keyboard('{Enter}')
  await waitFor(() => expect(bodies(asked, NOTES)).toHaveLength(1))
  expect(bodies(asked, NOTES)[0]).toMatchObject({ cue_id: 'c1', said: 'too-loud', amount_db: -6 })
  expect(screen.getByRole('heading', { level: 2, name: 'dock_clamp' })).toBeVisible()
  expect(screen.getAllByText('1 of 3 heard')[0]).toBeInTheDocument()
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
})

test('a sound that is skipped or not reached is not heard', async () => {
  const { asked } = serve(listening())
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  await screen.findByRole('heading', { level: 2, name: 'foot_deck_walk' })
  await press.keyboard('j')
  expect(screen.getByRole('heading', { level: 2, name: 'dock_clamp' })).toBeVisible()
  await press.keyboard('0')
  await waitFor(() => expect(bodies(asked, NOTES)).toHaveLength(1))
  expect(bodies(asked, NOTES)[0]).toMatchObject({ cue_id: 'c2', said: 'not-reached', amount_db: null })
  expect(screen.getAllByText('0 of 3 heard')[0]).toBeInTheDocument()
})

test('notes are kept while the line is lost, and sent in order, once each', async () => {
  let isUnreachable = true
  const away = { status: 503, body: 'no server' }
  const { asked } = serve(
    listening({
      [NOTES]: () => (isUnreachable ? away : answer({}, 201)),
      'GET /readyz': () => (isUnreachable ? away : answer({})),
    }),
  )
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  await screen.findByRole('heading', { level: 2, name: 'foot_deck_walk' })
  await press.keyboard('7{Enter}')
  await press.keyboard('3{Enter}')
  expect(await screen.findByText(/2 notes kept in this browser/)).toBeVisible()
  const kept = Object.keys(localStorage).find((key) => key.startsWith('soundlist-listening'))
  expect(JSON.parse(localStorage.getItem(kept ?? '') ?? '{}')).toMatchObject({ pending: [{}, {}] })
  isUnreachable = false
  await waitFor(() => expect(screen.queryByText(/kept in this browser/)).toBeNull())
  const sent = bodies(asked, NOTES) as { note_id: string; said: string }[]
  const ids = [...new Set(sent.map(({ note_id }) => note_id))]
  expect(ids.map((id) => sent.find(({ note_id }) => note_id === id)?.said)).toEqual(['good', 'too-long'])
  expect(localStorage.getItem(kept ?? '')).toBeNull()
})

test('a note that the server refuses is shown with what was said, not lost', async () => {
  serve(listening({ [NOTES]: refusal(409, 'listening-pass-closed', 'this listening pass is closed') }))
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  await screen.findByRole('heading', { level: 2, name: 'foot_deck_walk' })
  await press.type(screen.getByRole('textbox', { name: 'In words' }), 'crunches')
  await press.click(screen.getByRole('button', { name: /^Wrong/ }))
  await press.click(screen.getByRole('button', { name: /^Next/ }))
  expect(
    await screen.findByText(/foot_deck_walk, wrong: crunches was not taken: this listening pass is closed/),
  ).toBeVisible()
})

test('u takes the last note back and returns to its sound', async () => {
  const note = {
    id: 'n1',
    cue: LOUD.cue,
    said: 'too-loud',
    amount_db: -6,
    text: '',
    written_by: WHO,
    written_at: AT,
    is_mine: true,
    task_id: 'k1',
    role: 'implementer',
    is_done: false,
  }
  const { asked } = serve(
    listening({
      'GET /v1/projects/p1/listening-pass': pass([note]),
      'DELETE /v1/listening-notes/n1': answer(null, 204),
    }),
  )
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  expect(await screen.findByRole('heading', { level: 2, name: 'dock_clamp' })).toBeVisible() // where it stopped
  await press.keyboard('u')
  expect(screen.getByRole('heading', { level: 2, name: 'foot_deck_walk' })).toBeVisible()
  await waitFor(() => expect(wrote(asked, 'DELETE /v1/listening-notes/n1')).toHaveLength(1))
})

test('a pass begins with the newest build, and says so where there is none', async () => {
  const { asked, answers } = serve(
    listening({
      'GET /v1/projects/p1/listening-pass': { listening_pass: null, newest_audit: audit('482', 2, 2) },
      'POST /v1/projects/p1/listening-passes': answer(pass(), 201),
    }),
  )
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  const begin = await screen.findByRole('button', { name: 'Begin with build 482' })
  answers['GET /v1/projects/p1/listening-pass'] = pass()
  await press.click(begin)
  expect(await screen.findByRole('heading', { level: 2, name: 'foot_deck_walk' })).toBeVisible()
  expect(wrote(asked, 'POST /v1/projects/p1/listening-passes')).toHaveLength(1)
})

test('what happened to a sound is never called the same where the game changes its level', () => {
  const of = (status: AuditedSound['status'], more: Partial<AuditedSound> = {}) =>
    describeChange({ status, played_status: 'same', gain_db: null, ...more })
  expect(of('depends', { depends: ['Menu open'] })).toBe('Depends on Menu open')
  expect(of('gain', { gain_db: -3 })).toBe('Quieter')
  expect(of('trimmed', { gain_db: -1.5, played_status: 'gain' })).toBe('Cut or padded, quieter')
  expect(of('same')).toBe('As approved')
})

test('sounds are grouped by cue and drift', () => {
  const groups = groupsOf([sound(1), sound(2), sound(3, { gain_db: 3 }), sound(4, { cue: null })])
  expect(groups.map(({ name, sounds }) => [name, sounds.length])).toEqual([
    ['foot_deck_walk', 2],
    ['foot_deck_walk', 1],
    ['foot_deck_walk_04.wav', 1],
  ])
})

test('a shape at 6 dB more is twice as large, and ends at full scale', () => {
  const peaks = { points: 2, fullScale: 1, min: [-0.25, -0.8], max: [0.25, 0.8], rms: [0.1, 0.4] }
  expect(louder(peaks, 6).max[0]).toBeCloseTo(0.499, 3)
  expect(louder(peaks, 6).max[1]).toBe(1)
})

test('a gain is proposed towards the approved level, never away from it', () => {
  expect(proposedDb('too-loud', -6)).toBe(-6)
  expect(proposedDb('too-loud', 4)).toBe(-3)
  expect(proposedDb('too-soft', null)).toBe(3)
  expect(proposedDb('wrong', -6)).toBeNull()
})

test('the sounds of a pass are grouped by category or event, the choice is kept, and the sound stays', async () => {
  localStorage.removeItem('soundlist-listening-order')
  const cues = [
    cue('c1', 'foot_deck_walk', { category: 'foley', events: ['Play_Step'] }),
    cue('c2', 'dock_clamp', { category: '', events: [] }),
    cue('c3', 'radar_ping', { category: 'alarms', events: ['Play_Step'] }),
  ]
  const given = pass()
  serve(
    listening({
      'GET /v1/projects/p1/listening-pass': { ...given, listening_pass: { ...given.listening_pass, cues } },
    }),
  )
  const press = userEvent.setup()
  openApp('/projects/p1/listening')
  expect(await screen.findByRole('heading', { level: 2, name: 'foot_deck_walk' })).toBeVisible()
  const list = screen.getByRole('complementary', { name: 'Sounds of the build' })
  const names = () =>
    within(within(list).getByRole('list'))
      .getAllByRole('button')
      .map((one) => one.textContent)
  await press.keyboard('o')
  expect(within(list).getByRole('button', { name: 'Category' })).toHaveAttribute('aria-pressed', 'true')
  expect(names()).toEqual(['radar_pingnot heard', 'foot_deck_walknot heard', 'dock_clampnot heard'])
  expect(
    within(list)
      .getAllByRole('heading', { level: 2 })
      .map((one) => one.textContent),
  ).toEqual(['alarms', 'foley', 'No category'])
  expect(screen.getByRole('heading', { level: 2, name: 'foot_deck_walk' })).toBeVisible()
  await press.keyboard('o')
  expect(
    within(list)
      .getAllByRole('heading', { level: 2 })
      .map((one) => one.textContent),
  ).toEqual(['Play_Step', 'No event'])
  expect(localStorage.getItem('soundlist-listening-order')).toBe('event')
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  localStorage.removeItem('soundlist-listening-order')
})
