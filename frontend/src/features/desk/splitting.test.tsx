import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, expect, test } from 'vitest'

import { atDesk } from '@/test/desk'
import { openApp } from '@/test/openApp'
import { serve } from '@/test/server'

beforeAll(() => import('./DeskPage'))

const STEP = { id: 'c5', label: 'SW-005', name: 'step' }
const OFFER = {
  take_id: 't5',
  file_name: 'step_01.wav',
  cue: STEP,
  variations: 3,
  says: '3 sounds with silence between them (0.20 s, 1.40 s), 1.00 s long.',
}
const part = (number: number, start_s: number) => ({ number, start_s, duration_s: 0.222, label: '' })
const SPLIT = {
  take_id: 't5',
  state: 'offered',
  says: OFFER.says,
  may_split: true,
  is_our_fault: false,
  shortest_pause_s: 0.6,
  found_by: null,
  parts: [],
  tray_action_id: null,
  split_from: null,
}
const MADE = {
  ...SPLIT,
  state: 'made',
  says: '4 parts, found by silence of 0.6 s or more.',
  found_by: 'silence',
  parts: [part(1, 0), part(2, 1.198), part(3, 2.398), part(4, 3.598)],
}
const CUE = { ...STEP, use: '', state: 'locked', stems: ['step_01', 'step_02', 'step_03'] }

async function openSplit(split: object) {
  let shown = split
  const { asked } = serve(
    atDesk({
      'GET /v1/projects/p1/splits': [OFFER],
      'GET /v1/projects/p1/sound-list': { revision: 1, columns: [], cues: [CUE] },
      'GET /v1/takes/t5/split': () => shown,
      'POST /v1/takes/t5/split': () => (shown = MADE),
      'POST /v1/takes/t5/split/use': {
        id: 'a5',
        kind: 'split',
        done_at: '2026-11-17T09:00:00Z',
        undone_at: null,
        take_ids: ['t5', 't6', 't7', 't8'],
      },
      'POST /v1/tray-actions/a5/undo': { id: 'a5', kind: 'split', take_ids: [], moved_back: 4, left: 0 },
    }),
  )
  openApp('/desk')
  const file = within(await screen.findByRole('group', { name: 'step_01.wav' }))
  await userEvent.click(file.getByRole('button', { name: 'Split step_01.wav into variations' }))
  const body = (path: string) => asked.find((each) => each.method === 'POST' && each.path.endsWith(path))?.body
  const isSent = (path: string) => asked.some((each) => each.method === 'POST' && each.path.endsWith(path))
  return { file, body, isSent }
}

test('the parts of a file are shown before anything changes', async () => {
  const { file, body } = await openSplit(SPLIT)
  await userEvent.click(await file.findByRole('button', { name: 'Find the parts' }))
  const rows = (await file.findAllByRole('row')).slice(1)
  expect(rows).toHaveLength(4)
  expect(within(rows[1]!).getByText('1.198 s')).toBeVisible()
  expect(within(rows[1]!).getByText('0.222 s')).toBeVisible()
  expect(body('/split')).toEqual({ shortest_pause_s: 0.6 })
  expect(body('/split/use')).toBeUndefined()
})

test('each becomes a variation in its order, the rest is named as left out, and it can be undone', async () => {
  const { file, body, isSent } = await openSplit(MADE)
  await waitFor(() => expect(file.getByLabelText('Variation of part 3')).toHaveValue('3'))
  expect(file.getByLabelText('Variation of part 4')).toHaveValue('0')
  expect(file.getByText('1 part left out: the cue has 3 variations.')).toBeVisible()
  await userEvent.click(file.getByRole('button', { name: 'Split into 3 variations' }))
  await waitFor(() =>
    expect(body('/split/use')).toEqual({
      cue_id: 'c5',
      places: [1, 2, 3].map((number) => ({ part: number, variation: number })),
    }),
  )
  expect(await screen.findByText('step_01.wav is 3 variations of step.')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
  await waitFor(() => expect(isSent('/undo')).toBe(true))
})

test('two parts for one variation are not sent', async () => {
  const { file } = await openSplit(MADE)
  await waitFor(() => expect(file.getByLabelText('Variation of part 4')).toBeEnabled())
  await userEvent.selectOptions(file.getByLabelText('Variation of part 4'), '2')
  expect(file.getByRole('alert')).toHaveTextContent('Two parts have the same variation.')
  expect(file.getByRole('button', { name: 'Split into 4 variations' })).toBeDisabled()
})

test('where one sound is found, shorter silence can be asked for', async () => {
  const says = 'Not split: it holds one sound: no silence of 0.6 s or more inside, and no two markers.'
  const { file, body } = await openSplit({ ...SPLIT, state: 'refused', says })
  expect(await file.findByText(says)).toBeVisible()
  const seconds = file.getByLabelText('Silence between parts, at least (s)')
  await userEvent.clear(seconds)
  await userEvent.type(seconds, '0.2')
  await userEvent.click(file.getByRole('button', { name: 'Find the parts again' }))
  await waitFor(() => expect(body('/split')).toEqual({ shortest_pause_s: 0.2 }))
  expect(await file.findAllByRole('row')).toHaveLength(5)
})
