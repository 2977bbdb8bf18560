import { screen } from '@testing-library/react'
import { beforeEach, vi } from 'vitest'

import type { components } from '@/api/schema.gen'
import { dismissToast } from '@/app/toast'
import type { QueueItem } from '@/verdicts/api'

import { HandContext } from './audioContext'
import { aMe, anItem, aPreview, aServer, aTake, PROJECT, somePeaks } from './review'
import { openApp } from './openApp'

type Today = components['schemas']['Today']

export const TODAY = `/v1/projects/${PROJECT}/today`
export const DRAFTS = `/v1/projects/${PROJECT}/change-requests`

export const alternates = anItem({ id: 'shield', name: 'shield_hit' }, [
  aTake('a', { number: 1 }),
  aTake('b', { number: 2, loudness_lufs: -13.9 }),
])
export const single = anItem({ id: 'suit', name: 'suit_hit', label: 'SW-011' }, [aTake('s', { number: 2 })], {
  waiting_since: '2026-11-20T11:00:00Z',
})

export function day(answer: Partial<Today> = {}): Today {
  return {
    questions: [],
    with_others: [],
    builds: [],
    counts: {},
    draft_changes: 0,
    placeholders: 0,
    unsent_mails: 0,
    ...answer,
  }
}

export let server: ReturnType<typeof aServer>
let queue: QueueItem[]
/** Let other cues wait. */
export const queueIs = (...items: QueueItem[]) => (queue = items)

/** Before each test: a server with two cues in the queue. */
export function serveTodayPage() {
  beforeEach(() => {
    dismissToast()
    vi.stubGlobal('AudioContext', HandContext)
    queue = [alternates, single]
    server = aServer()
      .on('GET /v1/me', aMe())
      .on('GET /v1/review-queue', () => ({ items: queue, next: null }))
      .on('GET /v1/review-queue/count', () => ({ cues: queue.length, is_all: true }))
      .on(`GET ${TODAY}`, day())
      .on(`GET ${DRAFTS}`, { items: [], next: null })
      .on('GET /v1/sounds/a/peaks.json', somePeaks)
    for (const id of ['a', 'b', 's']) server.on(`GET /v1/sounds/${id}/preview`, aPreview)
  })
}

export const open = () => openApp(`/projects/${PROJECT}/today`)
export const opened = async () => {
  const drawn = open()
  await screen.findAllByRole('button', { name: /^Approve / })
  return drawn
}

/** One that waits for an answer. */
export const question = {
  id: 'question-1',
  cue: { id: 'coolant', label: 'SW-010', name: 'coolant_splash' },
  text: 'What falls in: a drop, a tool, a person?',
  asked_by: { id: 'designer', name: 'Sound designer' },
  asked_at: '2026-11-15T10:00:00Z',
  answer: null,
  answered_at: null,
  owner: null,
  due_on: null,
  blocks: false,
}
