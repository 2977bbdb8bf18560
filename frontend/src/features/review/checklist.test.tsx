import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, expect, test, vi } from 'vitest'

import type { CueReview } from '@/verdicts/api'
import { openApp } from '@/test/openApp'
import { HandContext } from '@/test/audioContext'
import { aMe, anItem, aPreview, APPROVER, aReview, aServer, aTake, PROJECT, somePeaks } from '@/test/review'
import type { Asked } from '@/test/server'

beforeAll(() => import('./ReviewPage'))

const ITEMS = [
  { id: 'clicks', category: '', text: 'No clicks' },
  { id: 'mood', category: 'weapon', text: 'Fits the palette' },
]
const single = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a')])
const set = anItem({ id: 'walk', name: 'foot_deck_walk', variations: 2 }, [
  aTake('w1', { variation: 1 }),
  aTake('w2', { variation: 2 }),
])

let server: ReturnType<typeof aServer>
let review: CueReview

beforeEach(() => {
  vi.stubGlobal('AudioContext', HandContext)
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', { items: [single, set], next: null })
    .on('GET /v1/review-queue/count', { cues: 2, is_all: true })
    .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
    .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
    .on(`GET /v1/projects/${PROJECT}/judged-lately`, [])
    .on('GET /v1/cues/shield/review', () => review)
    .on('GET /v1/cues/walk/review', () => review)
  for (const id of ['a', 'w1', 'w2']) {
    server.on(`GET /v1/sounds/${id}/preview`, aPreview).on(`GET /v1/sounds/${id}/peaks.json`, somePeaks)
  }
})

async function opened(cueId: string) {
  openApp(`/projects/${PROJECT}/review/${cueId}`)
  return screen.findByRole('region', { name: 'Verdict' })
}

const approve = (verdict: HTMLElement) => within(verdict).getByRole('button', { name: /^Approve/ })

test('items are checked one after another by one key, and then the version can be approved', async () => {
  review = aReview(single, {
    checklist: {
      blockers: 'items',
      items: ITEMS,
      checks: [],
      blocked: [{ take_id: 'a', why: '“No clicks”, “Fits the palette” are not checked' }],
    },
  })
  for (const { id } of ITEMS) {
    server.on(`PUT /v1/takes/a/checklist/${id}`, ({ body }: Asked) => {
      expect(body).toEqual({ is_checked: true })
      const { checklist } = review
      const check = { take_id: 'a', item_id: id, by: APPROVER, checked_at: new Date().toISOString() }
      const checks = [...checklist.checks, check]
      const blocked = checks.length === 2 ? [] : [{ take_id: 'a', why: '“Fits the palette” is not checked' }]
      review = { ...review, checklist: { ...checklist, checks, blocked } }
      return null
    })
  }
  const verdict = await opened('shield')
  expect(verdict).toHaveTextContent('Not to be approved yet: “No clicks”, “Fits the palette” are not checked.')
  expect(approve(verdict)).toBeDisabled()
  await userEvent.keyboard('a')
  const list = await screen.findByRole('region', { name: 'Checklist' })
  expect(list).toHaveTextContent('0 of 2 checked')
  await userEvent.keyboard('i')
  await waitFor(() => expect(list).toHaveTextContent('1 of 2 checked'))
  await userEvent.keyboard('i')
  await waitFor(() => expect(list).toHaveTextContent('2 of 2 checked'))
  expect(approve(verdict)).toBeEnabled()
  expect(
    within(list)
      .getAllByRole('checkbox')
      .every((box) => (box as HTMLInputElement).checked),
  ).toBe(true)
  expect(list).toHaveTextContent('Audio director')
  expect(server.of('POST /v1/takes/a/verdict')).toEqual([])
  const { violations } = await axe.run(list, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations).toEqual([])
})

test('a set of which one version is open says so and is not accepted', async () => {
  review = aReview(set, {
    checklist: {
      blockers: 'notes',
      items: [],
      checks: [],
      blocked: [{ take_id: 'w2', why: '1 comment is not resolved' }],
    },
  })
  const verdict = await opened('walk')
  expect(verdict).toHaveTextContent(/Left out: .*2, 1 comment is not resolved\./)
  expect(within(verdict).getByRole('button', { name: /Accept the set/ })).toBeDisabled()
})

test('of several selected versions those that are open are left out', async () => {
  review = aReview(set, {
    checklist: {
      blockers: 'notes',
      items: [],
      checks: [],
      blocked: [{ take_id: 'w2', why: '1 comment is not resolved' }],
    },
  })
  server.on('POST /v1/takes/w1/verdict', {})
  await opened('walk')
  await userEvent.keyboard('{Shift>}X{/Shift}')
  await userEvent.keyboard('{Shift>}A{/Shift}')
  await waitFor(() => expect(server.of('POST /v1/takes/w1/verdict')).toHaveLength(1))
  expect(server.of('POST /v1/takes/w2/verdict')).toEqual([])
})
