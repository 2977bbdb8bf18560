import { expect, type Page } from '@playwright/test'

import { test } from './fixtures'
import { PASSWORD } from './party'
import { freePort, Server } from './server'

const EMAIL = 'producer@studio.example'

/** Plug a device into a page's browser that makes passkeys and verifies its user. */
async function plugIn(page: Page): Promise<void> {
  const devtools = await page.context().newCDPSession(page)
  await devtools.send('WebAuthn.enable')
  await devtools.send('WebAuthn.addVirtualAuthenticator', {
    options: {
      protocol: 'ctap2',
      transport: 'internal',
      hasResidentKey: true,
      hasUserVerification: true,
      isUserVerified: true,
      automaticPresenceSimulation: true,
    },
  })
}

test('a passkey is added on Account and signs in without password @slow', async ({ page }) => {
  const port = await freePort()
  const server = await Server.start({ port, url: `http://localhost:${port}` }) // passkeys need a name
  try {
    await plugIn(page)
    await page.goto(`${server.url}/sign-up`)
    await page.getByLabel('Email').fill(EMAIL)
    await page.getByLabel('Your name').fill('Producer')
    await page.getByLabel('Password', { exact: true }).fill(PASSWORD)
    await page.getByRole('button', { name: 'Create account' }).click()
    await expect(page.getByRole('navigation', { name: 'Areas' })).toBeVisible()

    await page.goto(`${server.url}/account`)
    const card = page.getByRole('region', { name: 'Passkeys' })
    await card.getByLabel('Passkey name').fill('Laptop')
    await card.getByRole('button', { name: 'Add passkey' }).click()
    await expect(card.getByRole('list', { name: 'Recovery codes' }).getByRole('listitem')).toHaveCount(10)
    await card.getByRole('button', { name: 'I’ve saved them' }).click()
    await expect(card.getByText('never used')).toBeVisible()

    await page.context().clearCookies()
    await page.goto(`${server.url}/sign-in?next=/account`)
    await page.getByRole('button', { name: 'Sign in with a passkey' }).click()
    await expect(card.getByText('last used')).toBeVisible()
    await expect(page.getByText(EMAIL).first()).toBeVisible()

    await card.getByRole('button', { name: 'Remove Laptop' }).click()
    await expect(card.getByText('Laptop')).toBeHidden()
  } finally {
    await server.stop()
  }
})
