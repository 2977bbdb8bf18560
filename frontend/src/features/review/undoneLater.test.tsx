import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { outbox } from '@/api'
import { WAITING } from '@/api/outbox'
import { opened, queueIs, server, serveReviewPage, shield, walk } from '@/test/reviewPage'

serveReviewPage()

let isThere: boolean

beforeEach(() => {
  localStorage.clear()
  isThere = true
  server.on('POST /v1/takes/a/verdict', {}).on('DELETE /v1/takes/a/verdict', {}).on('GET /readyz', {})
  const reached = globalThis.fetch
  vi.stubGlobal('fetch', (...asked: Parameters<typeof fetch>) =>
    isThere ? reached(...asked) : Promise.reject(new TypeError('Failed to fetch')),
  )
})

const line = (state: 'lost' | 'back', isKnown = true) => {
  isThere = state === 'back'
  vi.spyOn(navigator, 'onLine', 'get').mockReturnValue(isThere || !isKnown)
}
const kept = () => Object.keys(localStorage).filter((name) => name.startsWith(WAITING))
const heading = (name: string) => screen.findByRole('heading', { name, level: 1 })
const approved = async () => {
  await opened()
  await userEvent.keyboard('a')
  await heading('foot_deck_walk')
}
const queued = () =>
  screen.getAllByRole('link', { name: /shield_hit|foot_deck_walk/ }).map(({ textContent }) => textContent)

describe('undo without a connection', () => {
  test('takes a verdict out that was not sent, and shows its cue again at its place', async () => {
    await opened()
    const before = queued()
    line('lost')
    await userEvent.keyboard('a')
    await heading('foot_deck_walk')
    await waitFor(() => expect(outbox.getState().waiting).toEqual(['verdict']))
    expect(queued()).not.toEqual(before)
    await userEvent.keyboard('u')
    expect(await heading('shield_hit')).toBeVisible()
    expect(queued()).toEqual(before)
    expect(outbox.getState().waiting).toHaveLength(0)
    expect(kept()).toEqual([])
    line('back')
    await waitFor(() => expect(server.of('GET /v1/review-queue').length).toBeGreaterThan(1))
    expect(server.of('POST /v1/takes/a/verdict')).toEqual([])
    expect(server.of('DELETE /v1/takes/a/verdict')).toEqual([])
  })

  test('is kept behind a verdict that was sent, and its cue is shown again at once', async () => {
    queueIs(shield, walk)
    await approved()
    await waitFor(() => expect(server.of('POST /v1/takes/a/verdict')).toHaveLength(1))
    line('lost', false)
    await userEvent.keyboard('u')
    expect(await heading('shield_hit')).toBeVisible()
    expect(outbox.getState().waiting).toEqual(['undo'])
    line('back')
    await waitFor(() => expect(server.of('DELETE /v1/takes/a/verdict')).toHaveLength(1))
    await waitFor(() => expect(kept()).toEqual([]))
    expect(outbox.getState()).toEqual({ waiting: [], refused: [] })
  })
})
