import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test } from 'vitest'

import { aDraft, aNote, anItem, aReview, aTake, APPROVER } from '@/test/review'
import { opened, queueIs, server, serveReview, serveReviewPage } from '@/test/reviewPage'
import { type Asked, refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

describe('a version that answers a change', () => {
  const before = aTake('old', { number: 1, state: 'change_requested' })
  const after = aTake('a', { number: 2 })
  const change = { ...aDraft(before, anItem({}, []).cue, 'Add a dull clank'), sent_at: '2026-11-20T09:30:00Z' }

  beforeEach(() => {
    queueIs(anItem({ id: 'shield', name: 'shield_hit' }, [after]))
    const item = anItem({ id: 'shield', name: 'shield_hit' }, [after, before])
    serveReview(aReview(item, { change_requests: [{ ...change, take_id: before.id }] }))
  })

  test('shows what was asked, and b flips to the version that it was asked of and back', async () => {
    await opened()
    const asked = await screen.findByRole('region', { name: 'What was asked of version 1' })
    expect(asked).toHaveTextContent('“Add a dull clank”')
    await userEvent.keyboard('b')
    expect(await within(asked).findByRole('button', { name: /^Back to the new version/ })).toBeVisible()
    await userEvent.keyboard('b')
    expect(await within(asked).findByRole('button', { name: /^Hear version 1/ })).toBeVisible()
  })
})

describe('notes on earlier versions', () => {
  const old = aTake('old', { number: 1, state: 'change_requested' })
  const now = aTake('a', { number: 2 })
  const item = anItem({ id: 'shield', name: 'shield_hit' }, [now], { open_notes: 2 })
  const tail = aNote('tail', 'Tail a little shorter.', { start_s: 0.41 })
  const clank = aNote('clank', 'Add a dull metallic clank.', { kind: 'change', start_s: 0.02, end_s: 0.11 })

  test('are asked of the next one, answered by keys one after another, and counted in the queue', async () => {
    let review = aReview(item, { takes: [now, old], carried_notes: [tail, clank] })
    server.on('GET /v1/cues/shield/review', () => review)
    for (const note of [tail, clank]) {
      server.on(`POST /v1/takes/a/carried-notes/${note.id}`, ({ body }: Asked) => {
        const { is_done } = body as { is_done: boolean }
        const answer = { is_done, number: 2, given_by: APPROVER, created_at: new Date().toISOString() }
        const said = { ...note, answer }
        review = { ...review, carried_notes: review.carried_notes.map((one) => (one.id === note.id ? said : one)) }
        return said
      })
    }
    queueIs(item)
    await opened()
    const carried = await screen.findByRole('region', { name: 'Carried over from earlier versions' })
    expect(carried).toHaveTextContent('0 of 2 done')
    expect(screen.getByRole('link', { name: /shield_hit/ })).toHaveTextContent('2 notes still open')
    await userEvent.keyboard('{Enter}')
    await waitFor(() => expect(carried).toHaveTextContent('1 of 2 done'))
    expect(carried).toHaveTextContent(/Done in version 2, Audio director/)
    await userEvent.keyboard('n')
    expect(await within(carried).findByText(/Still open in version 2/)).toBeVisible()
    expect(server.of('POST /v1/takes/a/carried-notes/tail')[0]?.body).toEqual({ is_done: true })
    expect(server.of('POST /v1/takes/a/carried-notes/clank')[0]?.body).toEqual({ is_done: false })
    const { violations } = await axe.run(carried, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations).toEqual([])
  })

  test('stay open with the reason when an answer is refused', async () => {
    serveReview(aReview(item, { takes: [now, old], carried_notes: [tail] }))
    server.on('POST /v1/takes/a/carried-notes/tail', () => refusal(404, 'note-not-found', 'No such note.'))
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: 'Done: Tail a little shorter.' }))
    expect(await screen.findByText('No such note.')).toBeVisible()
    expect(screen.getByText('0 of 1 done')).toBeVisible()
  })
})
