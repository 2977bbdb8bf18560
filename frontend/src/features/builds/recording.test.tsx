import { act, fireEvent, screen, within, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, type Answers, type Asked, serve, wrote } from '@/test/server'

import type { CueToHear } from './api'
import { nameOfSound, soundOf, timeOf } from './moments'

const NOTES = 'POST /v1/listening-passes/l1/notes'
const AT = '2026-11-20T10:00:00Z'
const WHO = { id: 'x1', name: 'Producer' }
const cue = (id: string, name: string, events: string[]): CueToHear => ({
  cue: { id, label: `SW-00${id}`, name },
  category: 'foley',
  description: '',
  events,
  files: 1,
  gain_db: 6,
  message: '',
  depends: [],
  move: null,
  suggested_db: -6,
  sound: null,
  heard: false,
})
const CUES = [
  cue('1', 'deck walk', ['Play_steps']),
  cue('2', 'deck run', ['Play_steps']),
  cue('3', 'laser', ['Play_gun']),
]
const PASS = {
  id: 'l1',
  audit: {
    id: 'a1',
    label: '482',
    commit: '',
    target: 'game',
    engine: 'wwise',
    sounds: 3,
    drifted: 0,
    new_drifts: 0,
    created_at: AT,
  },
  started_at: AT,
  is_newest: true,
  people: 1,
  heard: 0,
  cues: CUES,
  notes: [] as object[],
  may_close: true,
}
const reference = (id: string, kind: string, caption: string) => ({
  id,
  project_id: 'p1',
  cue: null,
  category: null,
  caption,
  terms: '',
  words: '',
  start_s: null,
  end_s: null,
  added_at: AT,
  may_change: true,
  version: {
    id: `${id}v`,
    number: 1,
    kind,
    media_type: 'video/mp4',
    file_name: `${caption}.mp4`,
    url: null,
    file_bytes: 9,
    excerpt: '',
    preview: 'none',
    problem: '',
    width_px: null,
    height_px: null,
    added_at: AT,
    added_by: WHO,
  },
})

function open(url = '/projects/p1/recording', more: Answers = {}): readonly Asked[] {
  const { asked } = serve(
    inProject('producer', {
      'GET /v1/projects/p1/listening-pass': { listening_pass: PASS, newest_audit: PASS.audit },
      'GET /v1/projects/p1/references': {
        items: [
          reference('r1', 'video', 'Level 1'),
          reference('r2', 'picture', 'Mood'),
          reference('r3', 'audio', 'Walk'),
        ],
        next: null,
      },
      'POST /v1/reference-versions/r1v/openings': answer(null, 204),
      'POST /v1/reference-versions/r3v/openings': answer(null, 204),
      'POST /v1/listening-passes/l1/notes': answer({}, 201),
      ...more,
    }),
  )
  openApp(url)
  return asked
}

beforeEach(() => localStorage.clear())

/** The player, standing at a time. */
async function playerAt(s: number): Promise<HTMLVideoElement> {
  const video = await screen.findByLabelText<HTMLVideoElement>('Level 1')
  act(() => {
    video.currentTime = s
  })
  return video
}

test('a key marks the moment, and the sound is named by an event afterwards', { tags: ['slow'] }, async () => {
  const asked = open()
  const user = userEvent.setup()
  await playerAt(65.24)
  await user.keyboard('1')
  await playerAt(70)
  await user.keyboard('5')
  const marks = screen.getByRole('region', { name: /Marks/ })
  expect(within(marks).getByText('Too loud')).toBeVisible()
  await user.type(within(marks).getByLabelText('Sound at 1:05.2'), 'play_gun')
  await user.type(within(marks).getByLabelText('Sound at 1:10.0'), 'play_steps')
  expect(within(marks).getByText(/Several sounds, or none/)).toBeVisible()
  await user.type(within(marks).getByLabelText('Comment at 1:05.2'), 'over the dialogue{Enter}')
  await waitFor(() => expect(wrote(asked, NOTES)).toHaveLength(1))
  const [sent] = wrote(asked, NOTES)
  const body = sent?.body
  expect(body).toMatchObject({
    cue_id: '3',
    said: 'too-loud',
    amount_db: -6,
    text: 'over the dialogue',
    recording: { reference_version_id: 'r1v', at_s: 65.24 },
  })
  expect(within(marks).queryByText('Too loud')).toBeNull()
  expect(within(marks).getByText('1 mark without a sound stays here.')).toBeVisible()
})

test('marks survive a reload, and the last one is removed by a key', async () => {
  open()
  const user = userEvent.setup()
  await playerAt(3)
  await user.keyboard('2')
  await user.keyboard('6')
  const marks = screen.getByRole('region', { name: /Marks/ })
  expect(within(marks).getByText('Missing')).toBeVisible()
  await user.keyboard('u')
  expect(within(marks).queryByText('Missing')).toBeNull()
  expect(Object.values(localStorage).some((kept) => String(kept).includes('too-soft'))).toBe(true)
})

test('a link of a task leads to its moment, and notes of the recording are listed', async () => {
  const note = {
    id: 'n1',
    cue: CUES[2]?.cue,
    said: 'wrong',
    amount_db: null,
    text: 'clicks',
    written_by: WHO,
    written_at: AT,
    is_mine: true,
    recording: { reference_version_id: 'r1v', at_s: 83.4 },
    task_id: 't1',
    role: 'designer',
    is_done: false,
  }
  open('/projects/p1/recording?recording=r1v&at=83.4', {
    'GET /v1/projects/p1/listening-pass': {
      listening_pass: { ...PASS, notes: [note, { ...note, id: 'n2', recording: null }] },
      newest_audit: PASS.audit,
    },
  })
  const video = await screen.findByLabelText<HTMLVideoElement>('Level 1')
  fireEvent.loadedMetadata(video)
  expect(video.currentTime).toBe(83.4)
  const notes = screen.getByRole('region', { name: /Notes of this recording/ })
  expect(within(notes).getAllByRole('listitem')).toHaveLength(1)
  expect(within(notes).getByText(/wrong, clicks, from Producer/)).toBeVisible()
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
})

test('only clips and sounds are recordings; without a pass the page says what comes first', async () => {
  open()
  const choice = await screen.findByLabelText('Recording')
  expect(
    within(choice)
      .getAllByRole('option')
      .map(({ textContent }) => textContent),
  ).toEqual(['Level 1', 'Walk'])
})

test('a recording that the browser cannot play says what to do', async () => {
  open()
  fireEvent.error(await screen.findByLabelText('Level 1'))
  expect(await screen.findByText(/can’t play Level 1.mp4/)).toBeVisible()
})

test('no pass is open', async () => {
  open('/projects/p1/recording', { 'GET /v1/projects/p1/listening-pass': { listening_pass: null, newest_audit: null } })
  expect(await screen.findByText('No listening pass is open')).toBeVisible()
})

test('sounds are found by name, number, event or a part of them that only one has', () => {
  const [walk, run, laser] = CUES
  expect(soundOf('deck walk', CUES)).toBe(walk)
  expect(soundOf('SW-002', CUES)).toBe(run)
  expect(soundOf('play_gun', CUES)).toBe(laser)
  expect(soundOf(nameOfSound(CUES[1] ?? CUES[0]!), CUES)).toBe(run)
  expect([soundOf('deck', CUES), soundOf('', CUES), soundOf('boom', CUES)]).toEqual([null, null, null])
  expect([timeOf(0), timeOf(59.96), timeOf(605.25)]).toEqual(['0:00.0', '1:00.0', '10:05.3'])
})
