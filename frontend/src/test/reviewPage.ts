import { screen } from '@testing-library/react'
import { beforeEach, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import type { CueReview, QueueItem } from '@/verdicts/api'

import { HandContext } from './audioContext'
import { aFinding, aMe, anItem, aPreview, aReview, aServer, aTake, PROJECT, somePeaks } from './review'
import { openApp } from './openApp'

export const shield = anItem(
  { id: 'shield', name: 'shield_hit' },
  [aTake('a', { number: 1, findings: [aFinding()] }), aTake('b', { number: 2 })],
  { accepted_after: '2030-03-15' },
)
export const walk = anItem(
  { id: 'walk', name: 'foot_deck_walk', label: 'SW-008', variations: 2 },
  [aTake('w1', { variation: 1 }), aTake('w2', { variation: 2 })],
  { accepted_after: '2030-03-15' },
)

export let server: ReturnType<typeof aServer>
let queue: QueueItem[]
/** Let other cues wait. */
export const queueIs = (...items: QueueItem[]) => (queue = items)

export const serveReview = (review: CueReview) => server.on(`GET /v1/cues/${review.cue.id}/review`, review)

/** Before each test: a server with two cues in the queue. */
export function serveReviewPage() {
  beforeEach(() => {
    dismissToast()
    vi.stubGlobal('AudioContext', HandContext)
    queue = [shield, walk]
    server = aServer()
      .on('GET /v1/me', aMe())
      .on('GET /v1/review-queue', () => ({ items: queue, next: null }))
      .on('GET /v1/review-queue/count', () => ({ cues: queue.length, is_all: true }))
      .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
      .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
      .on(`GET /v1/projects/${PROJECT}/judged-lately`, [
        {
          cue: { id: 'clamp', label: 'SW-009', name: 'dock_clamp' },
          status: 'accepted',
          since: new Date().toISOString(),
        },
      ])
    for (const id of ['a', 'b', 'w1', 'w2', 'old']) {
      server.on(`GET /v1/sounds/${id}/preview`, aPreview).on(`GET /v1/sounds/${id}/peaks.json`, somePeaks)
    }
    serveReview(aReview(shield))
    serveReview(aReview(walk))
  })
}

export const open = (path = '/shield') => openApp(`/projects/${PROJECT}/review${path}`)
/** Open the page of a cue, with its bar of verdicts. */
export const opened = async (path?: string) => {
  const drawn = open(path)
  await screen.findByRole('region', { name: 'Verdict' })
  return drawn
}

export const posts = () => server.asked.filter(({ method }) => method === 'POST')
