import { cleanup, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test } from 'vitest'

import { forgetDrafts } from '@/app/drafts'
import { anItem, aPreview, aReview, aTake, OURS, PROJECT, somePeaks } from '@/test/review'
import { opened, posts, queueIs, server, serveReview, serveReviewPage, shield, walk } from '@/test/reviewPage'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()
beforeEach(() => forgetDrafts())

const why = () => screen.findByRole('group', { name: /^Approve .* because$/ })
const hand = (letter: string) =>
  within(screen.getByRole('radiogroup', { name: 'Alternates' })).getByRole('radio', { name: new RegExp(`^${letter}`) })
const own = (kind: 'change' | 'pick', ...reasons: string[]) =>
  server.on(`GET /v1/projects/${PROJECT}/review-reasons`, { ...OURS, [kind]: { is_own: true, reasons } })

/** Open More and press one of its lines. */
const fromMore = async (line: string) => {
  await userEvent.click(within(screen.getByRole('main')).getByRole('button', { name: /^More/ }))
  await userEvent.click(await screen.findByRole('menuitem', { name: line }))
}

describe('the reason of a pick', () => {
  test('p and a digit approve with it and move on', async () => {
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('p')
    expect(await why()).toHaveFocus()
    expect((await axe.run(await why(), { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
    queueIs(walk)
    await userEvent.keyboard('2')
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
    expect(screen.getByText('shield_hit A approved: Best timing.')).toBeVisible()
    expect(posts()).toHaveLength(1)
    expect(posts()[0]?.body).toMatchObject({ kind: 'approve', note: '', reasons: ['Best timing'] })
  })

  test('comes from the list of the studio, by mouse too', async () => {
    own('pick', 'Feels right', 'Right size')
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    await fromMore('Approve with a reason')
    const buttons = within(await why()).getAllByRole('button')
    expect(buttons.map(({ textContent }) => textContent)).toEqual(['Feels right1', 'Right size2', 'CloseEsc'])
    await userEvent.click(within(await why()).getByRole('button', { name: /Right size/ }))
    await waitFor(() => expect(posts()[0]?.body).toMatchObject({ kind: 'approve', reasons: ['Right size'] }))
  })

  test('Escape closes, and digits choose alternates again; Space and Enter approve nothing', async () => {
    await opened()
    await userEvent.keyboard('p')
    await why()
    await userEvent.keyboard(' {Enter}9')
    expect(hand('A')).toBeChecked()
    await userEvent.keyboard('{Escape}')
    expect(screen.queryByRole('group', { name: /^Approve .* because$/ })).toBeNull()
    await userEvent.keyboard('2')
    expect(hand('B')).toBeChecked()
    expect(posts()).toEqual([])
  })

  test('a alone approves without one', async () => {
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('a')
    await waitFor(() => expect(posts()[0]?.body).toMatchObject({ kind: 'approve', reasons: [] }))
  })

  test('is that of a whole set', async () => {
    server.on('POST /v1/cues/walk/accept-set', {})
    await opened('/walk')
    await userEvent.keyboard('p4')
    await waitFor(() =>
      expect(server.of('POST /v1/cues/walk/accept-set')[0]?.body).toEqual({
        note: '',
        reasons: ['Cleanest'],
        take_ids: ['w1', 'w2'],
        heard_take_ids: ['w1', 'w2'],
      }),
    )
  })

  test('is not asked for what cannot be approved yet', async () => {
    const blocked = ['a', 'b'].map((take_id) => ({ take_id, why: '1 comment is not resolved' }))
    serveReview(aReview(shield, { checklist: { blockers: 'notes', items: [], checks: [], blocked } }))
    await opened()
    await userEvent.keyboard('p1')
    expect(screen.queryByRole('group', { name: /^Approve .* because$/ })).toBeNull()
    expect(posts()).toEqual([])
  })
})

describe('the reasons of a change', () => {
  const form = () => screen.findByRole('form', { name: 'What to change in shield_hit A' })
  const changed = { draft: null }

  test('are those of the studio, kept beside the text', async () => {
    own('change', 'Too wet', 'Too synthetic')
    server.on('POST /v1/takes/a/verdict', changed)
    await opened()
    await userEvent.keyboard('r2less of it{Enter}')
    await waitFor(() =>
      expect(posts()[0]?.body).toMatchObject({
        kind: 'request_change',
        note: 'Too synthetic. less of it',
        reasons: ['Too synthetic'],
      }),
    )
  })

  test('Shift R and a digit add one at once', async () => {
    server.on('POST /v1/takes/a/verdict', changed)
    await opened()
    await userEvent.keyboard('{Shift>}R{/Shift}')
    expect(await screen.findByRole('group', { name: 'Request a change of shield_hit A because' })).toHaveFocus()
    await userEvent.keyboard('3')
    await waitFor(() => expect(posts()[0]?.body).toMatchObject({ note: 'Too long.', reasons: ['Too long'] }))
  })

  test('one that left the list since it was chosen is kept, and can be taken back', async () => {
    server.on('POST /v1/takes/a/verdict', changed)
    await opened()
    await userEvent.keyboard('r1')
    cleanup()
    own('change', 'Too wet')
    await opened()
    await userEvent.keyboard('r')
    const kept = within(await form()).getByRole('button', { name: 'Too loud' })
    expect(kept).toHaveAttribute('aria-pressed', 'true')
    await userEvent.click(kept)
    expect(within(await form()).queryByRole('button', { name: 'Too loud' })).toBeNull()
  })
})

describe('the label of an alternate', () => {
  const labelled = () => server.of('PUT /v1/takes/a/label').map(({ body }) => body)

  test('Shift L and a digit say what it is, and it stands on its card', async () => {
    const [a, b] = shield.takes
    if (!a || !b) throw new Error('two alternates wait')
    server.on('PUT /v1/takes/a/label', () => {
      serveReview(aReview({ ...shield, takes: [{ ...a, label: 'wild' }, b] }))
      return { label: 'wild', labelled_by: null, labelled_at: null }
    })
    await opened()
    await userEvent.keyboard('{Shift>}L{/Shift}5')
    await waitFor(() => expect(hand('A')).toHaveTextContent('wild'))
    expect(labelled()).toEqual([{ label: 'wild' }])
    expect(screen.getByText('shield_hit A is labelled “wild”.')).toBeVisible()
    await userEvent.keyboard('{Shift>}L{/Shift}')
    expect(await screen.findByRole('group', { name: 'Label A, now “wild”, as' })).toHaveFocus()
    await userEvent.keyboard('0')
    await waitFor(() => expect(labelled()).toEqual([{ label: 'wild' }, { label: null }]))
  })

  test('is set by mouse too, from More', async () => {
    server.on('PUT /v1/takes/a/label', { label: 'layered', labelled_by: null, labelled_at: null })
    await opened()
    await fromMore('Label')
    await screen.findByRole('group', { name: 'Label A as' })
    await userEvent.click(screen.getByRole('button', { name: 'layered' }))
    await waitFor(() => expect(labelled()).toEqual([{ label: 'layered' }]))
    await waitFor(() => expect(screen.queryByRole('group', { name: /^Label/ })).toBeNull())
  })

  test('has no button that does nothing while a change is written', async () => {
    await opened()
    await userEvent.keyboard('r')
    await screen.findByRole('form', { name: 'What to change in shield_hit A' })
    await userEvent.click(within(screen.getByRole('main')).getByRole('button', { name: /^More/ }))
    expect(await screen.findByRole('menuitem', { name: 'Label' })).toBeDisabled()
  })

  test('is neither shown nor set while versions are compared blind', async () => {
    const [a, b] = shield.takes
    if (!a || !b) throw new Error('two alternates wait')
    serveReview(aReview({ ...shield, takes: [{ ...a, label: 'wild' }, b] }))
    await opened()
    await userEvent.keyboard('d{Shift>}L{/Shift}')
    expect(screen.queryByText('wild')).toBeNull()
    expect(screen.queryByRole('group', { name: /^Label/ })).toBeNull()
  })
})

const TAKES = 12
const PAGE = 5

test(`${TAKES} takes are judged by at most two keys each`, async () => {
  const items = Array.from({ length: TAKES }, (_, place) =>
    anItem({ id: `cue-${place}`, name: `hit_${place}` }, [aTake(`take-${place}`)]),
  )
  const judged = new Set<string>()
  const open = () => items.filter(({ takes: [take] }) => take && !judged.has(take.id))
  server
    .on('GET /v1/review-queue', () => ({ items: open().slice(0, PAGE), next: open().length > PAGE ? 'more' : null }))
    .on('GET /v1/review-queue/count', () => ({ cues: open().length, is_all: true }))
  for (const item of items) {
    const [take] = item.takes
    if (!take) continue
    serveReview(aReview(item))
    server
      .on(`GET /v1/sounds/${take.id}/preview`, aPreview)
      .on(`GET /v1/sounds/${take.id}/peaks.json`, somePeaks)
      .on(`POST /v1/takes/${take.id}/verdict`, () => {
        judged.add(take.id)
        return { draft: null }
      })
  }
  await opened('/cue-0')
  const ways = ['a', 'p1', '{Shift>}R{/Shift}1']
  for (const [place, { cue }] of items.entries()) {
    await screen.findByRole('heading', { name: cue.name, level: 1 })
    await userEvent.keyboard(ways[place % ways.length] ?? '')
    await waitFor(() => expect(judged.size).toBe(place + 1))
  }
  // The next sound plays by itself, so that what was heard is reported among the verdicts.
  const verdicts = posts().filter(({ path }) => path.endsWith('/verdict'))
  const kinds = verdicts.map(({ body }) => body as { kind: string; reasons: string[] })
  expect(kinds).toHaveLength(TAKES)
  expect(kinds.filter(({ reasons }) => reasons[0] === 'Fits the scene')).toHaveLength(TAKES / 3)
  expect(kinds.filter(({ kind, reasons }) => kind === 'request_change' && reasons[0] === 'Too loud')).toHaveLength(
    TAKES / 3,
  )
})
