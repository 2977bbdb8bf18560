import { act, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { aFinding, aReview, aTake, APPROVER } from '@/test/review'
import { opened, posts, server, serveReview, serveReviewPage, shield } from '@/test/reviewPage'
import { refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

describe('what is said', () => {
  test('c writes at once: no letter of it is taken for a verdict', async () => {
    server.on('POST /v1/takes/a/comments', {
      id: 'c1',
      take_id: 'a',
      text: 'a clear attack',
      start_s: null,
      end_s: null,
      author: APPROVER,
      decides: true,
      created_at: '2026-11-20T10:00:00Z',
      resolved_at: null,
      mentions: [],
      acknowledgements: [],
    })
    await opened()
    await userEvent.keyboard('ca clear{Shift>}{Enter}{/Shift}attack{Enter}')
    await waitFor(() => expect(posts()).toHaveLength(1))
    expect(posts()[0]).toMatchObject({ path: '/v1/takes/a/comments', body: { text: 'a clear\nattack' } })
  })

  test('stays in its field when it is refused', async () => {
    server.on('POST /v1/takes/a/comments', () => refusal(422, 'range-invalid', 'It is beyond the end of the sound.'))
    await opened()
    await userEvent.keyboard('cclear{Enter}')
    expect(await screen.findByRole('alert')).toHaveTextContent('It is beyond the end of the sound.')
    expect(screen.getByRole('textbox', { name: /^Comment/ })).toHaveValue('clear')
  })

  test('those who advise say which they prefer, and are told who decides', async () => {
    serveReview(aReview(shield, { may_approve: false }))
    server.on('POST /v1/takes/a/comments', { id: 'c1', take_id: 'a' })
    await opened()
    expect(screen.getByText('You can comment. Audio director approves.')).toBeVisible()
    expect(screen.queryByRole('button', { name: /^Approve |^Request/ })).toBeNull()
    await userEvent.keyboard('a')
    await waitFor(() => expect(posts()).toHaveLength(1))
    expect(posts()[0]).toMatchObject({ path: '/v1/takes/a/comments', body: { text: 'I prefer A.' } })
  })

  test('a deputy sees for whom they decide, and everybody else who may', async () => {
    serveReview(aReview(shield, { deputies: [{ id: 'x1', name: 'Producer' }], on_behalf_of: APPROVER }))
    await opened()
    expect(screen.getByText(/^Your call, for Audio director\./)).toBeVisible()
  })

  test('who advises sees the deputy too', async () => {
    serveReview(aReview(shield, { deputies: [{ id: 'x1', name: 'Producer' }], may_approve: false }))
    await opened()
    expect(screen.getByText('You can comment. Audio director or Producer approves.')).toBeVisible()
  })

  test('findings stand in their tab with the limit and what to do', async () => {
    await opened()
    await userEvent.click(screen.getByRole('tab', { name: 'Details' }))
    const finding = screen.getByRole('article', { name: 'True peak −0.60 dBTP, limit −1 dBTP' })
    expect(finding).toHaveTextContent('Lower the level by 0.40 dB or more.')
    expect(within(finding).getByRole('button', { name: 'Go to position' })).toBeVisible()
  })
})

describe('a version that came back', () => {
  const came = aTake('a', {
    state: 'returned',
    findings: [aFinding({ severity: 'error', message: 'sample peak 0.00 dBFS, limit -0.1 dBFS' })],
  })

  test('is let through by the approver alone, with a reason', async () => {
    serveReview(aReview(shield, { takes: [came] }))
    server.on('POST /v1/takes/a/waiver', {})
    await opened()
    await userEvent.click(screen.getByRole('tab', { name: 'Details' }))
    const through = await screen.findByRole('button', { name: 'Waive version 1' })
    await userEvent.click(through)
    expect(await screen.findByText('Waive the findings: reason is required.')).toBeVisible()
    expect(posts()).toEqual([])
    await userEvent.type(screen.getByRole('textbox', { name: 'Waive the findings: reason' }), 'meant to clip')
    await userEvent.click(through)
    await waitFor(() => expect(posts()).toHaveLength(1))
    expect(posts()[0]).toMatchObject({ path: '/v1/takes/a/waiver', body: { reason: 'meant to clip' } })
  })

  test('is not offered to those who advise', async () => {
    serveReview(aReview(shield, { takes: [came], may_approve: false }))
    await opened()
    await userEvent.click(screen.getByRole('tab', { name: 'Details' }))
    await act(() => import('./Waiver'))
    expect(screen.queryByRole('button', { name: /^Waive/ })).toBeNull()
  })
})
