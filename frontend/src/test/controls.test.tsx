import { screen, waitFor } from '@testing-library/react'
import { describe, expect, test } from 'vitest'

import { controlsInSight } from './controls'
import { atDesk } from './desk'
import { aContract, figures, PAGE, serveMoney, serveMoneyPage } from './moneyPage'
import { openApp } from './openApp'
import { inProject, people } from './project'
import { serve } from './server'

const AT = '2026-11-20T10:00:00Z'
/** What stands above a table and beside its rows, as a page opens. */
const MAX_CONTROLS = 7

const LINK = {
  id: 'g1',
  kind: 'cues',
  title: 'For the composer',
  state: 'open',
  sounds: 3,
  has_password: true,
  may_comment: true,
  has_beeps: true,
  expires_at: null,
  max_openings: null,
  openings: 2,
  plays: 7,
  made_by: people.producer,
  created_at: AT,
  revoked_at: null,
  is_own: true,
}
const DELIVERY = {
  id: 'd1',
  number: 1,
  note: 'First sounds',
  designer: people.designer,
  created_at: AT,
  closed_at: null,
  takes_count: 3,
}

const shown = async (text: RegExp | string) => {
  expect((await screen.findAllByText(text)).length).toBeGreaterThan(0)
  await waitFor(() => expect(document.querySelector('[aria-busy="true"]')).toBeNull())
  return controlsInSight(screen.getByRole('main'))
}
const few = (controls: string[]) => expect(controls.length, controls.join(' | ')).toBeLessThanOrEqual(MAX_CONTROLS)

describe('at most seven controls stand around the rows of a page as it opens', () => {
  test('People', async () => {
    serve(inProject())
    openApp('/projects/p1/people')
    few(await shown('Invite a designer'))
  })

  test('guest links and playlists', async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/guest-links': { items: [LINK], next: null },
        'GET /v1/projects/p1/playlists': [
          { id: 'l1', name: 'Combat', takes: 3, made_by: people.producer, created_at: AT },
        ],
      }),
    )
    openApp('/projects/p1/sharing')
    few(await shown('For the composer'))
  })

  test('Deliveries', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1/deliveries': { items: [DELIVERY], next: null } }))
    openApp('/projects/p1/deliveries')
    few(await shown('Delivery 1'))
  })

  test('the desk', async () => {
    serve(atDesk())
    openApp('/desk')
    few(await shown('Your desk'))
  })
})

describe('Money', () => {
  serveMoneyPage()

  test('has at most seven controls beside its rows', async () => {
    serveMoney({ contracts: [aContract('effects', 'Effects')], totals: [{ currency: 'USD', figures: figures() }] })
    openApp(PAGE)
    few(await shown('Invoices'))
  })
})
