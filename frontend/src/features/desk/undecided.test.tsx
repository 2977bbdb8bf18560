import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, expect, test } from 'vitest'

import { atDesk, CUE } from '@/test/desk'
import { openApp } from '@/test/openApp'
import { serve } from '@/test/server'

beforeAll(() => import('./DeskPage'))

const take = (id: string, number: number, name: string) => ({
  id,
  file_name: name,
  number,
  state: 'conforming',
  received_at: '2026-11-17T09:00:00Z',
})
const PLACE = {
  delivery_id: 'd3',
  cue: CUE,
  variation: 3,
  alternate: null,
  takes: [take('t1', 1, 'airlock_cycle_03.wav'), take('t2', 2, 'Airlock Cycle 03 FINAL (2).wav')],
}
const DONE = { id: 'a1', done_at: '2026-11-17T09:00:00Z', undone_at: null, take_ids: ['t1'] }

async function place() {
  const { asked } = serve(
    atDesk({
      'GET /v1/projects/p1/takes/undecided': [PLACE],
      'POST /v1/projects/p1/takes/discard': { ...DONE, kind: 'discarded' },
      'POST /v1/projects/p1/takes/move': { ...DONE, kind: 'moved' },
    }),
  )
  openApp('/desk')
  const group = within(await screen.findByRole('group', { name: 'SW-009 airlock_cycle, variation 3' }))
  const body = (what: string) => asked.find(({ path }) => path.endsWith(`/takes/${what}`))?.body
  return { group, body }
}

test('of two files for one sound one is used, and the other is kept as a master', async () => {
  const { group, body } = await place()
  expect(screen.getByText('1 sound with several files')).toBeVisible()
  await userEvent.click(group.getByRole('button', { name: 'Use Airlock Cycle 03 FINAL (2).wav' }))
  await waitFor(() => expect(body('discard')).toEqual({ take_ids: ['t1'] }))
  expect(await screen.findByText(/FINAL \(2\)\.wav counts; 1 file discarded, its master is kept/)).toBeVisible()
})

test('or both are alternates', async () => {
  const { group, body } = await place()
  await userEvent.click(group.getByRole('button', { name: 'Both are alternates' }))
  await waitFor(() =>
    expect(body('move')).toEqual({
      moves: [{ take_id: 't2', cue_id: CUE.id, variation: 3, as_alternate: true }],
    }),
  )
})
