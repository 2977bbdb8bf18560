import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aPreview } from '@/test/review'
import { answer } from '@/test/server'
import { aCue, aNewestTake, ListServer } from '@/test/soundList'

beforeAll(() => import('./SoundListPage'))

function three(part: 'team' | 'designer' = 'team') {
  const server = new ListServer(
    [aCue(1, 'ui_confirm'), aCue(2, 'shield_hit'), aCue(3, 'door', { state: 'cut' })],
    {
      ui_confirm: { status: 'accepted', newest_take: aNewestTake('t1') },
      shield_hit: {
        status: 'to_review',
        newest_take: { ...aNewestTake('t2'), duration_s: 0.2 },
        unheard_take_ids: part === 'team' ? ['t2'] : [],
      },
    },
    part,
  )
  server.answers['GET /v1/sounds/t2/preview'] = { ...aPreview, durationS: 0.2 }
  server.answers['GET /v1/sounds/t1/preview'] = aPreview
  server.answers[`POST ${server.at}/heard-takes`] = answer(null, 204)
  return server
}
const row = (name: string) => screen.findByRole('row', { name: new RegExp(name) })
async function chip() {
  const filter = await screen.findByRole('button', { name: /^Filter/ })
  if (filter.getAttribute('aria-expanded') !== 'true') await userEvent.click(filter)
  return screen.findByRole('button', { name: /^Not heard yet/ })
}

beforeEach(() => {
  localStorage.clear()
  vi.stubGlobal('AudioContext', HandContext)
})

test('a cue with a version that was not heard is marked', async () => {
  openApp(three().path)
  await chip()
  expect(await row('shield_hit')).toHaveTextContent('not heard yet')
  expect(await row('ui_confirm')).not.toHaveTextContent('not heard yet')
  expect(within(await row('shield_hit')).getByRole('link', { name: 'shield_hit' })).toBeVisible()
})

test('the filter leaves what was not heard, stands in the address, and Escape takes it away', async () => {
  const app = openApp(three().path)
  const filter = await chip()
  expect(filter).toHaveTextContent('1')
  await userEvent.click(filter)
  await waitFor(() => expect(app.search()).toEqual({ heard: 'no' }))
  expect(filter).toHaveAttribute('aria-pressed', 'true')
  expect(screen.queryByRole('link', { name: 'ui_confirm' })).toBeNull()
  await userEvent.keyboard('{Escape}')
  await waitFor(() => expect(app.search()).toEqual({}))
  await row('ui_confirm')
})

test(
  'what is played for long enough is reported, its mark goes, and its row stays until another plays',
  { tags: ['slow'] },
  async () => {
    const server = three()
    openApp(`${server.path}?heard=no`)
    await row('shield_hit')
    await userEvent.click(screen.getByRole('button', { name: 'Play shield_hit' }))
    await waitFor(async () => expect(await row('shield_hit')).not.toHaveTextContent('not heard yet'))
    expect(await chip()).toHaveTextContent('0')
    await waitFor(() => expect(server.sent('POST', `${server.at}/heard-takes`)[0]?.body).toEqual({ take_ids: ['t2'] }))
  },
)

test('a designer has no marks and no filter', async () => {
  const server = three('designer')
  openApp(server.path)
  await screen.findByText('To review', { selector: 'td *' })
  expect(screen.queryByText(/not heard/i)).toBeNull()
})
