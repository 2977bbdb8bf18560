import { type ConsoleMessage, expect } from '@playwright/test'

import { test } from './fixtures'

test('the API’s documentation works from our own server alone, within its content security policy @slow', async ({
  demo,
  page,
}) => {
  const complaints: string[] = []
  const foreign: string[] = []
  page.on('console', (message: ConsoleMessage) => {
    if (message.type() === 'error' || /content security policy/i.test(message.text())) complaints.push(message.text())
  })
  page.on('pageerror', (error) => complaints.push(error.message))
  page.on('request', (request) => {
    const { protocol, origin } = new URL(request.url())
    if (protocol.startsWith('http') && origin !== demo.url) foreign.push(request.url())
  })
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', (event) => {
      console.error(`content security policy: ${event.violatedDirective} ${event.blockedURI} ${event.sample}`)
    })
  })

  const answer = await page.goto(`${demo.url}/docs`)
  expect(answer?.headers()['content-security-policy']).toContain("script-src 'self'")
  await expect(page.getByRole('heading', { name: /^Soundlist/ })).toBeVisible()

  // A read of the server, sent from the page.
  await page.locator('#operations-tag-accounts').click()
  const session = page.locator('#operations-accounts-read_session')
  await session.getByRole('button').first().click()
  await session.getByRole('button', { name: 'Try it out' }).click()
  await session.getByRole('button', { name: 'Execute' }).click()
  await expect(session.locator('.live-responses-table')).toContainText('"demo": true')

  expect(complaints).toEqual([])
  expect(foreign).toEqual([])
})

test('each page leads to its guide, which works within the content security policy', async ({ demo, page }) => {
  const complaints: string[] = []
  const foreign: string[] = []
  await page.goto(`${demo.url}/today`)
  await page.getByRole('button', { name: /: account and settings$/ }).click()
  const opening = page.waitForEvent('popup')
  await page.getByRole('menuitem', { name: 'Help on this page' }).click()
  const guide = await opening
  guide.on('console', (message: ConsoleMessage) => {
    if (message.type() === 'error' || /content security policy/i.test(message.text())) complaints.push(message.text())
  })
  guide.on('pageerror', (error) => complaints.push(error.message))
  guide.on('request', (request) => {
    const { protocol, origin } = new URL(request.url())
    if (protocol.startsWith('http') && origin !== demo.url) foreign.push(request.url())
  })
  await guide.reload()
  await expect(guide).toHaveURL(`${demo.url}/help/how-to/review.html`)
  await expect(guide.getByRole('heading', { level: 1, name: /^Review sounds/ })).toBeVisible()

  await guide.goto(`${demo.url}/help`)
  await expect(guide).toHaveURL(`${demo.url}/help/`)
  await guide.getByRole('link', { name: 'Your first project', exact: true }).first().click()
  await expect(guide.getByRole('heading', { level: 1, name: /^Your first project/ })).toBeVisible()
  expect(complaints).toEqual([])
  expect(foreign).toEqual([])
})
