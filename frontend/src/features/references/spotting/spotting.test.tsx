import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, refusal, serve, wrote } from '@/test/server'

const AT = '2026-11-20T10:00:00Z'
const PRODUCER = { id: 'x1', name: 'Producer' }
const VERSION = {
  id: 'v1',
  number: 1,
  kind: 'video',
  media_type: 'video/mp4',
  file_name: 'walkway.mp4',
  url: null,
  file_bytes: 2_000,
  excerpt: '',
  preview: 'none',
  problem: '',
  width_px: null,
  height_px: null,
  added_at: AT,
  added_by: PRODUCER,
}
const CLIP = {
  id: 'r1',
  project_id: 'p1',
  cue: null,
  category: null,
  caption: '',
  terms: '',
  words: '',
  start_s: null,
  end_s: null,
  added_at: AT,
  version: VERSION,
  may_change: true,
}

/** A video that stands where the test puts it. */
function stageVideo() {
  const video = document.querySelector('video')
  if (video === null) throw new Error('no video')
  const state = { currentTime: 0, paused: true, duration: 20 }
  for (const name of ['currentTime', 'paused', 'duration'] as const) {
    Object.defineProperty(video, name, {
      configurable: true,
      get: () => state[name],
      set: (value: never) => {
        state[name] = value
      },
    })
  }
  fireEvent(video, new Event('loadedmetadata'))
  return state
}

async function open(more: object = {}, clip: object = CLIP) {
  const { asked } = serve(
    inProject('producer', {
      'GET /v1/projects/p1/desk': refusal(403, 'x', 'no desk'),
      'GET /v1/projects/p1/references': { items: [clip], next: null },
      'GET /v1/projects/p1/sound-list': { revision: 1, next: null, cues: [] },
      'GET /v1/projects/p1/category-guess': { category: 'door' },
      'POST /v1/reference-versions/v1/openings': answer(null, 204),
      'POST /v1/references/r1/cues': answer([{ id: 'c1' }, { id: 'c2' }], 201),
      'POST /v1/references/r1/cues/undo': answer(null, 204),
      ...more,
    }),
  )
  const app = openApp('/projects/p1/references/r1/spotting')
  await waitFor(() => expect(document.querySelector('video')).toHaveAttribute('src'))
  return { asked, app, video: stageVideo() }
}

const rows = () => within(screen.getByRole('region', { name: 'Marks' })).queryAllByRole('listitem')
const valueOf = (name: string) => screen.getByLabelText<HTMLInputElement>(name).value
const tapAt = async (video: { currentTime: number }, s: number) => {
  video.currentTime = s
  await userEvent.keyboard('t')
}

beforeEach(() => {
  localStorage.clear()
  vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: vi.fn(), removeEventListener: vi.fn() }))
})

test('each press of the key marks where the clip is, to the millisecond', async () => {
  const { asked, video } = await open()
  expect(wrote(asked, 'POST /v1/reference-versions/v1/openings')).toHaveLength(1)
  await tapAt(video, 4)
  await tapAt(video, 1.2344)
  expect(rows()).toHaveLength(2)
  expect(valueOf('Time of walkway 1')).toBe('0:01.234')
  expect(valueOf('Time of walkway 2')).toBe('0:04.000')
  expect(valueOf('Length of walkway 1')).toBe('')
})

test('a key that is held gives the length', async () => {
  const { video } = await open()
  video.currentTime = 2
  fireEvent.keyDown(window, { key: 't' })
  video.currentTime = 2.75
  fireEvent.keyUp(window, { key: 't' })
  expect(valueOf('Length of walkway 1')).toBe('0:00.750')
  video.currentTime = 5
  fireEvent.keyDown(window, { key: 't' })
  video.currentTime = 5.1
  fireEvent.keyUp(window, { key: 't' })
  expect(valueOf('Length of walkway 2')).toBe('')
})

test('the pad marks by finger and by keyboard', async () => {
  const { video } = await open()
  const pad = screen.getByRole('button', { name: /^Mark/ })
  video.currentTime = 3
  fireEvent.pointerDown(pad)
  video.currentTime = 4
  fireEvent.pointerUp(pad)
  fireEvent.click(pad, { detail: 1 })
  expect(valueOf('Length of walkway 1')).toBe('0:01.000')
  fireEvent.click(pad, { detail: 0 })
  expect(rows()).toHaveLength(2)
})

test('arrows move the selected mark by a frame, and every step is undone', async () => {
  const { video } = await open()
  await userEvent.selectOptions(screen.getByLabelText('Frames a second'), '25')
  screen.getByLabelText('Frames a second').blur()
  await tapAt(video, 1)
  await userEvent.keyboard('{ArrowRight}{ArrowRight}')
  expect(valueOf('Time of walkway 1')).toBe('0:01.080')
  await userEvent.keyboard('{Shift>}{ArrowLeft}{/Shift}')
  expect(valueOf('Time of walkway 1')).toBe('0:00.680')
  await userEvent.keyboard('x')
  expect(rows()).toHaveLength(0)
  await userEvent.keyboard('u')
  expect(valueOf('Time of walkway 1')).toBe('0:00.680')
  await userEvent.keyboard('u')
  expect(valueOf('Time of walkway 1')).toBe('0:01.000')
  await userEvent.keyboard('u')
  expect(rows()).toHaveLength(0)
})

test('a mark is dragged along the clip', async () => {
  const { video } = await open()
  await tapAt(video, 10)
  const mark = screen.getByRole('button', { name: 'walkway 1, 10.000 seconds' })
  mark.setPointerCapture = vi.fn()
  const line = mark.parentElement
  if (line === null) throw new Error('no line')
  vi.spyOn(line, 'getBoundingClientRect').mockReturnValue({ left: 0, width: 200 } as DOMRect)
  fireEvent.pointerDown(mark, { clientX: 101 })
  fireEvent.pointerMove(mark, { clientX: 121 })
  fireEvent.pointerMove(mark, { clientX: 151 })
  fireEvent.pointerUp(mark)
  fireEvent.pointerMove(mark, { clientX: 10 })
  expect(valueOf('Time of walkway 1')).toBe('0:15.000')
  await userEvent.keyboard('u')
  expect(valueOf('Time of walkway 1')).toBe('0:10.000')
})

test('the ends of a mark are set where the clip is', async () => {
  const { video } = await open()
  await tapAt(video, 2)
  video.currentTime = 3.5
  await userEvent.keyboard(']')
  expect(valueOf('Length of walkway 1')).toBe('0:01.500')
  video.currentTime = 2.5
  fireEvent.keyDown(window, { key: '[' })
  expect(valueOf('Time of walkway 1')).toBe('0:02.500')
})

test('what was marked is there again after a reload', async () => {
  const { video } = await open()
  await tapAt(video, 4)
  await userEvent.keyboard('e')
  await userEvent.keyboard('Hull door')
  document.body.innerHTML = ''
  await open()
  expect(await screen.findByText(/Draft restored/)).toBeVisible()
  expect(valueOf('Name of mark 1')).toBe('Hull door')
  expect(valueOf('Time of Hull door')).toBe('0:04.000')
})

test('the cues are made in one act with categories by their words, and undo brings the marks back', async () => {
  const { asked, app, video } = await open()
  await tapAt(video, 4)
  await tapAt(video, 1)
  await userEvent.type(screen.getByLabelText('Name of mark 1'), 'Hull door{Enter}')
  expect(screen.getByLabelText('Name of mark 2')).toHaveFocus()
  await waitFor(() => expect(valueOf('Category of Hull door')).toBe('door'))
  await userEvent.type(screen.getByLabelText('Category of walkway 2'), 'ui')
  await userEvent.keyboard('{Control>}{Enter}{/Control}')
  await waitFor(() => expect(app.at()).toBe('/projects/p1/sound-list'))
  expect(wrote(asked, 'POST /v1/references/r1/cues').map(({ body }) => body)).toEqual([
    {
      marks: [
        { name: 'Hull door', category: 'door', start_s: 1, duration_s: null },
        { name: 'walkway 2', category: 'ui', start_s: 4, duration_s: null },
      ],
    },
  ])
  expect(await screen.findByText('2 cues made from walkway.mp4.')).toBeVisible()
  await userEvent.click(within(screen.getByRole('status')).getByRole('button', { name: /Undo/ }))
  await waitFor(() =>
    expect(wrote(asked, 'POST /v1/references/r1/cues/undo').map(({ body }) => body)).toEqual([
      { cue_ids: ['c1', 'c2'] },
    ]),
  )
  await waitFor(() => expect(JSON.stringify({ ...localStorage })).toContain('Hull door'))
})

test('a refusal stands in the row that it is about, and nothing is lost', async () => {
  const { video } = await open({
    'POST /v1/references/r1/cues': refusal(422, 'rows-invalid', 'nothing was saved', {
      errors: [{ where: 'row 2: name', message: 'the file name "shot" belongs to SW-004 already' }],
    }),
  })
  await tapAt(video, 1)
  await tapAt(video, 2)
  await userEvent.click(screen.getByRole('button', { name: /Make 2 cues/ }))
  const [, second] = rows()
  if (!second) throw new Error('no second row')
  expect(await within(second).findByText('The file name "shot" belongs to SW-004 already.')).toBeVisible()
  expect(rows()).toHaveLength(2)
})

test('the page has no violation of WCAG that a program finds', async () => {
  const { video } = await open()
  await tapAt(video, 1)
  const found = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(found.violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
})

test('what is not a clip says so', async () => {
  serve(
    inProject('producer', {
      'GET /v1/projects/p1/desk': refusal(403, 'x', 'no desk'),
      'GET /v1/projects/p1/references': { items: [{ ...CLIP, version: { ...VERSION, kind: 'audio' } }], next: null },
    }),
  )
  openApp('/projects/p1/references/r1/spotting')
  expect(await screen.findByRole('heading', { name: 'Only clips are spotted' })).toBeVisible()
})
