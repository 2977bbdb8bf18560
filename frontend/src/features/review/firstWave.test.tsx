import { waitFor } from '@testing-library/react'
import { expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aMe, anItem, aServer, aTake, PROJECT, somePeaks } from '@/test/review'

test('the waveform that Review opens with is asked for before its cue is here', async () => {
  vi.stubGlobal('AudioContext', HandContext)
  const newestFirst = [aTake('b', { number: 2 }), aTake('a', { number: 1 })]
  const server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', { items: [anItem({ id: 'shield', name: 'shield_hit' }, newestFirst)], next: null })
    .on('GET /v1/cues/shield/review', () => new Promise(() => undefined))
    .on('GET /v1/sounds/a/peaks.json', somePeaks)
  openApp(`/projects/${PROJECT}/review`)
  await waitFor(() => expect(server.of('GET /v1/sounds/a/peaks.json')).toHaveLength(1))
  expect(server.of('GET /v1/cues/shield/review')).toHaveLength(1)
  expect(server.of('GET /v1/sounds/b/peaks.json')).toHaveLength(0)
})
