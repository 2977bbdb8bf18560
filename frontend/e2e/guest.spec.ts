import { expect } from '@playwright/test'

import { ask } from './api'
import { atWork, deliver, visit } from './atWork'
import { expectAccessible } from './axe'
import { test } from './fixtures'
import { Hand } from './hand'
import { wav } from './sounds'

const SOUNDS = 3
/** What a guest does at most to hear a list through and to say one thing. */
const MOST = { clicks: 3, fields: 2, requests: 25 }

test('a guest on a phone opens a link, hears the list through and comments, counted @slow', async ({
  server: { url },
  browser,
}) => {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const names = Array.from({ length: SOUNDS }, (_, index) => `step_${index + 1}`)
  const project = await atWork(
    producer,
    designer,
    url,
    names.map((name) => ({ name })),
  )
  const files = Object.fromEntries(
    names.map((name, index) => [`${name}.wav`, wav({ seconds: 1, pitchHz: 300 + 50 * index })]),
  )
  await deliver(designer, producer, url, project, files)
  const { cues } = await ask<{ cues: { id: string }[] }>(producer.context(), `${url}/v1/projects/${project}/sound-list`)
  const link = await ask<{ url: string }>(producer.context(), `${url}/v1/projects/${project}/guest-links`, 'POST', {
    kind: 'cues',
    title: 'Steps',
    cue_ids: cues.map(({ id }) => id),
    may_comment: true,
  })

  const phone = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })
  const guest = new Hand(await phone.newPage())
  const { page } = guest
  await page.goto(link.url)
  await expect(page.getByRole('heading', { name: 'Listen' })).toBeVisible()
  await expectAccessible(page)
  await guest.type(page.getByLabel('Your name'), 'Publisher')
  await guest.click(page.getByRole('button', { name: 'Open' }))

  await expect(page.getByRole('heading', { name: 'Steps' })).toBeVisible()
  await expectAccessible(page)
  const now = page.getByRole('region', { name: 'Now' })
  await expect(async () => {
    await page.reload()
    await expect(now.getByRole('button', { name: 'Play' })).toBeEnabled({ timeout: 10_000 })
  }).toPass({ timeout: 300_000 })
  await guest.click(now.getByRole('button', { name: 'Play' }))
  await expect(now.getByText(names.at(-1) ?? '')).toBeVisible() // without a further press
  await expect(now.getByRole('button', { name: 'Play' })).toBeVisible()
  await guest.type(page.getByRole('textbox', { name: /^Comment on/ }), 'The last one is the best.')
  await guest.click(page.getByRole('button', { name: 'Send comment' }))
  await expect(page.getByRole('list', { name: 'What you wrote' })).toContainText('The last one is the best.')
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390)

  guest.report('guest, from the link to a comment')
  expect(guest.clicks).toBeLessThanOrEqual(MOST.clicks)
  expect(guest.fields).toBeLessThanOrEqual(MOST.fields)
  expect(guest.requests).toBeLessThanOrEqual(MOST.requests)

  const links = `${url}/v1/projects/${project}/guest-links`
  const { items } = await ask<{ items: { id: string }[] }>(producer.context(), links)
  const visits = await ask<{ items: { guest_name: string; played: { plays: number }[] }[] }>(
    producer.context(),
    `${url}/v1/guest-links/${items[0]?.id}/visits`,
  )
  expect(visits.items.map(({ guest_name, played }) => [guest_name, played.map(({ plays }) => plays)])).toEqual([
    ['Publisher', names.map(() => 1)],
  ])
})
