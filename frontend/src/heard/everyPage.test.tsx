import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { anOverview, inProject } from '@/test/project'
import { aMe, type aServer, PROJECT } from '@/test/review'
import { answer, refusal, serve, wrote } from '@/test/server'
import { aTakeServer } from '@/test/take'

const SHORT = { durationS: 0.2 }

beforeEach(() => {
  dismissToast()
  localStorage.clear()
  vi.stubGlobal('AudioContext', HandContext)
})

const reported = async (sent: () => unknown) => waitFor(() => expect(sent()).toEqual({ take_ids: ['t1'] }))

test('a sound of the palette that is played is reported as heard', { tags: ['slow'] }, async () => {
  const palette = [
    {
      cue: { id: 'c1', label: 'SW-001', name: 'shield_hit' },
      take_id: 't1',
      loop: false,
      thumb: null,
      preview_url: '/v1/sounds/s1/preview',
      loudness_lufs: null,
    },
  ]
  const { asked } = serve(
    inProject('producer', {
      'GET /v1/projects/p1/overview': anOverview({ palette }),
      'GET /v1/sounds/s1/preview': SHORT,
      'POST /v1/projects/p1/heard-takes': answer(null, 204),
    }),
  )
  openApp('/projects/p1/progress')
  await userEvent.click(await screen.findByRole('button', { name: 'Play shield_hit' }))
  await reported(() => wrote(asked, 'POST /v1/projects/p1/heard-takes')[0]?.body)
})

/** The page of a version, seen by one of the team. */
function takePage(): ReturnType<typeof aServer> {
  return aTakeServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/takes/t1/fit', refusal(404, 'take-not-found', 'there is no such version'))
    .on(`POST /v1/projects/${PROJECT}/heard-takes`, answer(null, 204))
}

test('a version that is played on its page is reported as heard', { tags: ['slow'] }, async () => {
  const server = takePage()
  openApp('/takes/t1')
  await userEvent.click(await screen.findByRole('button', { name: /^Play(?! (original|fixed))/ }))
  await reported(() => server.of(`POST /v1/projects/${PROJECT}/heard-takes`)[0]?.body)
})

test('its fixed copy is another sound: to play it reports nothing', { tags: ['slow'] }, async () => {
  const server = takePage()
  openApp('/takes/t1')
  const heard = () => server.of(`POST /v1/projects/${PROJECT}/heard-takes`).map(({ body }) => body)
  await userEvent.click(await screen.findByRole('button', { name: /^Play fixed/ }))
  await new Promise((done) => setTimeout(done, 1_000)) // a fifth of it would count
  await userEvent.click(screen.getByRole('button', { name: /^Play original/ }))
  await waitFor(() => expect(heard()).toEqual([{ take_ids: ['t1'] }]))
})
