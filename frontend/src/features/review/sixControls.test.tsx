import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, beforeEach, describe, expect, test } from 'vitest'

import { forgetDrafts } from '@/app/drafts'
import { aDraft, aReview } from '@/test/review'
import { opened, queueIs, server, serveReview, serveReviewPage, shield, walk } from '@/test/reviewPage'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()
beforeEach(() => forgetDrafts())

const MOST_CONTROLS = 12
/** What a style shows on a narrow page alone, where the queue is a drawer. */
const ONLY_NARROW = /^Close queue$|waiting$/
const requests = () => server.of('POST /v1/takes/a/verdict').map(({ body }) => body)
const requested = () => {
  const [take] = shield.takes
  if (!take) throw new Error('two alternates wait')
  return { draft: { ...aDraft(take, shield.cue, 'less hiss'), sends_at: new Date(Date.now() + 10_000).toISOString() } }
}

test('the room shows six controls and More, and no more than twelve in all', async () => {
  await opened()
  const room = within(screen.getByRole('main'))
  for (const name of [/^Play/, /^Compare/, /^Loop/, 'Comment', 'Request change', 'Approve A', 'More']) {
    expect(room.getByRole('button', { name })).toBeVisible()
  }
  const controls = ['button', 'tab', 'textbox', 'combobox', 'checkbox']
    .flatMap((role) => room.queryAllByRole(role))
    .filter((control) => !ONLY_NARROW.test(control.getAttribute('aria-label') ?? control.textContent))
  expect(controls.length).toBeLessThanOrEqual(MOST_CONTROLS)
})

test('the arrows choose among versions, of which one is in the hand', async () => {
  await opened()
  const [a, b] = within(screen.getByRole('radiogroup', { name: 'Alternates' })).getAllByRole('radio')
  expect(a).toBeChecked()
  a?.focus()
  await userEvent.keyboard('{ArrowRight}')
  expect(b).toBeChecked()
  expect(b).toHaveFocus()
})

describe('a change request', () => {
  test('is sent in one act, and u takes it back', async () => {
    server.on('POST /v1/takes/a/verdict', requested()).on('DELETE /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('rless hiss{Shift>}{Enter}{/Shift}please{Enter}')
    await waitFor(() =>
      expect(requests()).toMatchObject([{ kind: 'request_change', note: 'less hiss\nplease', send: true }]),
    )
    expect(await screen.findByText('Change requested: shield_hit A.')).toBeVisible()
    expect(screen.queryByRole('button', { name: /to send$/ })).toBeNull()
    await userEvent.keyboard('u')
    await waitFor(() => expect(server.of('DELETE /v1/takes/a/verdict')).toHaveLength(1))
    expect(await screen.findByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
  })

  test('says who gets it and what it counts', async () => {
    await opened()
    await userEvent.keyboard('r')
    const form = await screen.findByRole('form', { name: 'What to change in shield_hit A' })
    expect(form).toHaveTextContent('Round 1. You can undo it for 10 seconds.')
    expect(within(form).getByRole('button', { name: /^Send to / })).toBeVisible()
  })
})

describe('after a verdict', () => {
  const plays = () => screen.findByRole('button', { name: 'Pause' })
  const approveFirst = async () => {
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    queueIs(walk)
    await userEvent.keyboard('a')
    await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })
  }

  test('the next sound plays by itself', async () => {
    await approveFirst()
    expect(await plays()).toBeVisible()
  })

  test('it does not where a person turned that off', async () => {
    localStorage.setItem('soundlist-plays-next', 'false')
    await approveFirst()
    expect(screen.getByRole('button', { name: 'Play' })).toBeVisible()
    localStorage.removeItem('soundlist-plays-next')
  })
})

test('of a set each file says when it was heard', async () => {
  const [w1, w2] = walk.takes
  if (!w1 || !w2) throw new Error('the set has two variations')
  const anHourAgo = new Date(Date.now() - 3_600_000).toISOString()
  serveReview(
    aReview({
      ...walk,
      takes: [
        { ...w1, is_heard: true, heard_at: anHourAgo },
        { ...w2, is_heard: false },
      ],
    }),
  )
  await opened('/walk')
  const [first, second] = within(screen.getByRole('radiogroup', { name: 'Variations' })).getAllByRole('radio')
  expect(first).toHaveTextContent('heard 1 h ago')
  expect(second).toHaveTextContent('not heard')
})
