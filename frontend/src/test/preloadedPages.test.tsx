import { waitFor } from '@testing-library/react'
import { expect, test, vi } from 'vitest'

import { PAGES } from '../../scripts/preload'

import { HandContext } from './audioContext'
import { atDesk } from './desk'
import { openApp } from './openApp'
import { aMe, anItem, aServer, aTake, PROJECT } from './review'
import { type Asked, serve } from './server'

const item = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a', { number: 1 })])
const team = () =>
  aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', { items: [item], next: null })

const SERVERS: Record<string, { project: string; asked: () => Asked[] }> = {
  '/sign-in': { project: '', asked: () => serve({ 'GET /v1/session': { signed_in: false, demo: false } }).asked },
  '/projects/{project}/review': { project: PROJECT, asked: () => team().asked },
  '/projects/{project}/review/shield': { project: PROJECT, asked: () => team().asked },
  '/projects/{project}/today': { project: PROJECT, asked: () => team().asked },
  '/projects/{project}/desk': { project: 'p1', asked: () => serve(atDesk()).asked },
}
const OF_PROJECT = '0190a1b2-0000-7000-8000-000000000001'

test('each page that is preloaded is in this test', () => {
  for (const { at } of PAGES) {
    const path = Object.keys(SERVERS).find((one) => new RegExp(at).test(one.replace('{project}', OF_PROJECT)))
    expect(path, at).toBeDefined()
  }
})

test.each(Object.entries(SERVERS))('what is prefetched for %s is asked by its page', async (path, server) => {
  vi.stubGlobal('AudioContext', HandContext)
  const page = PAGES.find(({ at }) => new RegExp(at).test(path.replace('{project}', OF_PROJECT)))
  const asked = server.asked()
  openApp(path.replace('{project}', server.project))
  const wanted = page?.asks.map((one) => one.replace('{project}', server.project)) ?? []
  const seen = () => asked.map((one) => one.path + (one.query.size > 0 ? `?${one.query.toString()}` : ''))
  await waitFor(() => expect(seen()).toEqual(expect.arrayContaining(wanted)))
})
