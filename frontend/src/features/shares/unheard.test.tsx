import { act, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aPlaylistTake as take, LIVE, PLAYLIST } from '@/test/playlist'
import { inProject } from '@/test/project'
import { anItem, aPreview, aReview, aTake, OURS } from '@/test/review'
import { answer, serve, wrote } from '@/test/server'

const LASER = take('t1', 'laser', { is_heard: false, duration_s: 0.2 })
const THREE = { ...PLAYLIST, takes: [LASER, take('t2', 'door'), take('t3', 'steps', { is_heard: false })] }

function open(playlist: object, part: 'producer' | 'designer' = 'producer', more: Record<string, unknown> = {}) {
  const { asked } = serve(
    inProject(part, {
      'GET /v1/playlists/l1': playlist,
      'GET /v1/playlists/l1/live': LIVE,
      'PUT /v1/playlists/l1/position': answer(null, 204),
      'POST /v1/projects/p1/heard-takes': answer(null, 204),
      'GET /v1/sounds/p-t1/preview': { ...aPreview, durationS: 0.2 },
      'GET /v1/sounds/p-t2/preview': aPreview,
      'GET /v1/sounds/p-t3/preview': aPreview,
      ...more,
    }),
  )
  openApp('/projects/p1/playlists/l1')
  return asked
}
const sound = (name: RegExp) => screen.getByRole('button', { name })
const now = () => screen.getByRole('region', { name: 'Now' })
const nextUnheard = () => userEvent.keyboard('{Shift>}j{/Shift}')

beforeEach(() => {
  dismissToast()
  localStorage.clear()
  vi.stubGlobal('AudioContext', HandContext)
})
afterEach(() => vi.restoreAllMocks())

test('what was not heard is marked and counted, and a key goes from one to the next', { tags: ['slow'] }, async () => {
  open(THREE)
  expect(await screen.findByText('2 not heard yet')).toBeVisible()
  expect(sound(/^laser/)).toHaveTextContent('not heard yet')
  expect(sound(/^door/)).not.toHaveTextContent('not heard yet')
  await nextUnheard()
  await waitFor(() => expect(now()).toHaveTextContent('steps'))
  await nextUnheard()
  await waitFor(() => expect(now()).toHaveTextContent('laser'))
  await userEvent.keyboard('?')
  const keys = await screen.findByRole('dialog')
  expect(within(keys).getByText('Next that you have not heard')).toBeVisible()
  await userEvent.keyboard('{Escape}')
  const found = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(found.violations.map(({ id }) => id)).toEqual([])
})

test('where every other sound was heard the key says so and stays', async () => {
  open({ ...PLAYLIST, position: null, takes: [LASER, take('t2', 'door')] })
  await screen.findByText('1 not heard yet')
  await nextUnheard()
  expect(await screen.findByText('You have heard every other sound of this playlist.')).toBeVisible()
  expect(now()).toHaveTextContent('laser')
})

test('what is played for long enough is reported, and its mark goes', { tags: ['slow'] }, async () => {
  const asked = open({ ...THREE, position: null })
  await screen.findByText('2 not heard yet')
  await userEvent.keyboard(' ')
  await waitFor(() => expect(sound(/^laser/)).not.toHaveTextContent('not heard yet'))
  expect(screen.getByText('1 not heard yet')).toBeVisible()
  await waitFor(() => expect(wrote(asked, 'POST /v1/projects/p1/heard-takes')[0]?.body).toEqual({ take_ids: ['t1'] }))
})

test('of a designer nothing is recorded: there are no marks, and the key does nothing', async () => {
  const takes = THREE.takes.map((one) => ({ ...one, is_heard: null }))
  open({ ...THREE, takes, may_share: false, may_join: false }, 'designer')
  await waitFor(() => expect(now()).toHaveTextContent('door'))
  await nextUnheard()
  expect(screen.queryByText(/not heard/)).toBeNull()
  expect(now()).toHaveTextContent('door')
})

test('an approval of what was not heard plays it to its end, and the next sound waits for the decision', async () => {
  let context: HandContext | undefined
  let playedS = 0
  vi.spyOn(performance, 'now').mockImplementation(() => 1_000 * playedS)
  vi.stubGlobal(
    'AudioContext',
    class extends HandContext {
      constructor() {
        super()
        // eslint-disable-next-line @typescript-eslint/no-this-alias -- the page makes it
        context = this
      }
    },
  )
  const laser = take('t1', 'laser', { is_heard: false, duration_s: 5, may_approve: true })
  const item = anItem({ id: 'c-t1', name: 'laser' }, [aTake('t1', { is_heard: false, duration_s: 5 })])
  const asked = open({ ...PLAYLIST, position: null, takes: [laser, take('t2', 'door')] }, 'producer', {
    'GET /v1/cues/c-t1/review': aReview(item),
    'GET /v1/projects/p1/review-reasons': OURS,
    'GET /v1/sounds/p-t1/preview': { durationS: 5 },
    'POST /v1/takes/t1/verdict': {},
  })
  expect(await screen.findByText(/You have not heard version 1 yet/)).toBeVisible()
  await userEvent.keyboard('a')
  expect(await screen.findByText('version 1 is playing for the first time.')).toBeVisible()
  playedS += 5
  act(() => context?.started.at(-1)?.end())
  expect(await screen.findByText(/^Heard\./)).toBeVisible()
  expect(now()).toHaveTextContent('laser')
  expect(wrote(asked, 'POST /v1/takes/t1/verdict')).toEqual([])
  await userEvent.keyboard('a')
  await waitFor(() => expect(wrote(asked, 'POST /v1/takes/t1/verdict')[0]?.body).toMatchObject({ heard: true }))
  await waitFor(() => expect(now()).toHaveTextContent('door'))
})
