import { act, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { anItem, aReview, aTake, PROJECT } from '@/test/review'
import { opened, posts, queueIs, server, serveReview, serveReviewPage, walk } from '@/test/reviewPage'
import { answer } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

/** The context of the page, which ends its sounds when the test says so. */
let context: HandContext
let playedS = 0
beforeEach(() => {
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
  // The clock that says how much was played goes on when the test says so: a busy machine makes no difference.
  playedS = 0
  vi.spyOn(performance, 'now').mockImplementation(() => 1_000 * playedS)
  server.on(`POST /v1/projects/${PROJECT}/heard-takes`, answer(null, 204))
  for (const id of ['a', 'w1', 'w2']) server.on(`GET /v1/sounds/${id}/preview`, { durationS: 5 })
})
afterEach(() => vi.restoreAllMocks())

/** The sound that plays comes to its end. */
const playToEnd = () => {
  playedS += 5
  act(() => context.started.at(-1)?.end())
}

const verdict = () => screen.getByRole('region', { name: 'Verdict' })
const decisions = () => posts().filter(({ path }) => /verdict$|accept-set$/.test(path))
const unheard = (id: string, take: Parameters<typeof aTake>[1] = {}) =>
  aTake(id, { is_heard: false, duration_s: 5, ...take })
const one = (take: Parameters<typeof aTake>[1] = {}, cue: Parameters<typeof anItem>[0] = {}) =>
  anItem({ id: 'shield', name: 'shield_hit', ...cue }, [unheard('a', take)])
const openOne = async (item = one()) => {
  server.on('POST /v1/takes/a/verdict', {})
  queueIs(item)
  serveReview(aReview(item))
  await opened()
}
const sounds = async (count: number) => {
  await waitFor(() => expect(context.started).toHaveLength(count))
  expect(context.started.at(-1)).toMatchObject({ fromS: 0 })
}

describe('an approval of what was not heard', () => {
  test(
    'plays it first, decides nothing, and is given when it is asked for again once it has played',
    { tags: ['slow'] },
    async () => {
      await openOne()
      expect(verdict()).toHaveTextContent('You have not heard version 1 yet. Approve a plays it first.')
      await userEvent.keyboard('a')
      await sounds(1)
      expect(verdict()).toHaveTextContent('version 1 is playing for the first time. It is not approved yet.')
      expect(verdict()).toHaveTextContent('Press Approve a again once it has played.')
      await userEvent.keyboard('a')
      expect(context.started).toHaveLength(1) // it goes on, and does not begin again
      expect(decisions()).toEqual([])
      playToEnd()
      expect(await within(verdict()).findByText(/^Heard\./)).toBeVisible()
      expect(decisions()).toEqual([])
      await userEvent.keyboard('a')
      await waitFor(() => expect(decisions()).toHaveLength(1))
      expect(decisions()[0]?.body).toMatchObject({ kind: 'approve', heard: true })
    },
  )

  test('plays a sound from its start that plays from its middle', async () => {
    await openOne()
    await userEvent.keyboard(' ')
    await sounds(1)
    screen.getByRole('slider', { name: /position/i }).focus()
    await userEvent.keyboard('{ArrowRight}')
    await waitFor(() => expect(context.started.at(-1)?.fromS).toBeGreaterThan(0))
    const jumped = context.started.length
    await userEvent.keyboard('a')
    await sounds(jumped + 1)
    await userEvent.keyboard('a')
    expect(context.started).toHaveLength(jumped + 1) // now it is whole, and goes on
    expect(decisions()).toEqual([])
  })

  test('is not given by a reason either', async () => {
    await openOne()
    await userEvent.keyboard('p1')
    await sounds(1)
    expect(decisions()).toEqual([])
    playToEnd()
    await within(verdict()).findByText(/^Heard\./)
    await userEvent.keyboard('1')
    await waitFor(() => expect(decisions()[0]?.body).toMatchObject({ reasons: ['Fits the scene'], heard: true }))
  })

  test('stops at Escape, and the next time it plays from its start', async () => {
    await openOne()
    await userEvent.keyboard('a')
    await sounds(1)
    await userEvent.keyboard('{Escape}')
    expect(await within(verdict()).findByText(/You have not heard version 1 yet/)).toBeVisible()
    await userEvent.keyboard('a')
    await sounds(2)
    expect(decisions()).toEqual([])
  })

  test('is given without listening by the button of that name, which the server is told', async () => {
    await openOne()
    await userEvent.keyboard('.')
    await userEvent.click(await screen.findByRole('menuitem', { name: 'Approve without listening' }))
    await waitFor(() => expect(decisions()[0]?.body).toMatchObject({ kind: 'approve', heard: false }))
    expect(context?.started ?? []).toEqual([])
  })

  test('asks for half a minute of a longer sound', async () => {
    server.on('GET /v1/sounds/a/preview', { durationS: 90 })
    await openOne(one({ duration_s: 90 }))
    await userEvent.keyboard('a')
    expect(await within(verdict()).findByText(/once 30 s of it have played/)).toBeVisible()
  })

  test('of a sound that has no preview yet is not given by a key', async () => {
    await openOne(one({ preview_url: null }))
    expect(verdict()).toHaveTextContent('You have not heard version 1 yet. The preview is not ready yet.')
    await userEvent.keyboard('a')
    expect(decisions()).toEqual([])
  })

  test('asks nothing of those who only advise', async () => {
    const item = one()
    queueIs(item)
    serveReview(aReview(item, { may_approve: false }))
    await opened()
    expect(within(verdict()).queryByText(/not heard/)).toBeNull()
  })
})

test('of a set each file is played to its end before the next, and the set is approved once all were', async () => {
  const set = { ...walk, takes: [unheard('w1', { variation: 1 }), unheard('w2', { variation: 2 })] }
  server.on('POST /v1/cues/walk/accept-set', {})
  queueIs(set)
  serveReview(aReview(set))
  await opened('/walk')
  expect(verdict()).toHaveTextContent('You have not heard the 2 files yet. Accept the set a plays them first.')
  await userEvent.keyboard('a')
  await sounds(1)
  expect(verdict()).toHaveTextContent('_01 is playing for the first time.')
  playToEnd()
  await sounds(2)
  expect(verdict()).toHaveTextContent('_02 is playing for the first time.')
  playToEnd()
  expect(await within(verdict()).findByText(/^Heard\./)).toHaveTextContent('Heard. Press Accept the set a again.')
  expect(decisions()).toEqual([])
  await userEvent.keyboard('a')
  await waitFor(() => expect(decisions()[0]?.body).toMatchObject({ heard_take_ids: ['w1', 'w2'] }))
})

describe('a set that is judged quickly', () => {
  test('sends each variation once, and no second time what the first press decided', async () => {
    let letGo = () => undefined as void
    const held = new Promise<object>((resolve) => {
      letGo = () => resolve({})
    })
    server
      .on('POST /v1/takes/w1/verdict', () => held)
      .on('POST /v1/takes/w2/verdict', {})
      .on('POST /v1/cues/walk/accept-set', {})
    await opened('/walk')
    await userEvent.keyboard('{Shift>}a{/Shift}')
    expect(await screen.findByText('_01 approved', { exact: false })).toBeVisible()
    expect(within(screen.getByRole('radiogroup', { name: 'Variations' })).getAllByRole('radio')).toHaveLength(1)
    await userEvent.keyboard('a')
    await waitFor(() => expect(decisions()).toHaveLength(2))
    expect(decisions().map(({ path }) => path)).toEqual(['/v1/takes/w1/verdict', '/v1/cues/walk/accept-set'])
    expect(decisions()[1]?.body).toMatchObject({ take_ids: ['w2'] })
    letGo()
  })
})
