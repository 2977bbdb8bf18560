import { expect, type Page, test } from '@playwright/test'

import { expectAccessible } from './axe'
import { servePartsPage } from './partsPage'

const WIDE = { width: 1440, height: 900 }
const NARROW = { width: 390, height: 844 }

let parts: Awaited<ReturnType<typeof servePartsPage>>

test.beforeAll(async () => {
  test.setTimeout(300_000) // the page is built first
  parts = await servePartsPage()
})

test.afterAll(() => parts.stop())

async function open(page: Page, scheme: 'light' | 'dark', size: { width: number; height: number }): Promise<void> {
  await page.setViewportSize(size)
  await page.emulateMedia({ colorScheme: scheme })
  await page.goto(`${parts.url}/parts`)
  await expect(page.getByRole('heading', { level: 1, name: 'Parts' })).toBeVisible()
}

for (const scheme of ['light', 'dark'] as const) {
  for (const [name, size] of [
    ['wide', WIDE],
    ['narrow', NARROW],
  ] as const) {
    test(`every part, ${scheme}, ${name} @slow`, async ({ page }) => {
      const broken: string[] = []
      page.on('pageerror', (error) => broken.push(error.message))
      page.on('request', (request) => {
        if (!/^(http:\/\/127\.0\.0\.1|blob:|data:)/.test(request.url())) broken.push(`asked for ${request.url()}`)
      })
      await open(page, scheme, size)
      await expectAccessible(page)
      const sideways = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
      expect(sideways).toBeLessThanOrEqual(0)
      expect(broken).toEqual([])
    })
  }
}

test('the palette opens by its key, finds a sound and does without a mouse @slow', async ({ page }) => {
  await open(page, 'light', WIDE)
  await page.keyboard.press('Control+k')
  await expect(page.getByRole('combobox', { name: 'Search or run a command' })).toBeFocused()
  await page.keyboard.type('shield')
  await expect(page.getByRole('option', { selected: true })).toContainText('SW-007')
  await expectAccessible(page)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('status').filter({ hasText: 'shield_hit opened.' })).toBeVisible()
})

test('the sheet of keys opens by ?, and single keys can be turned off @slow', async ({ page }) => {
  await open(page, 'dark', WIDE)
  await page.keyboard.press('?')
  const sheet = page.getByRole('dialog', { name: 'Keyboard shortcuts' })
  await expect(sheet.getByText('Approve')).toBeVisible()
  await expectAccessible(page)
  await sheet.getByRole('switch', { name: 'Single-key shortcuts' }).click()
  await page.keyboard.press('Escape')
  await expect(sheet).toBeHidden()
  await page.keyboard.press('a')
  await expect(page.getByText('shield_hit A approved.')).toBeHidden()
})

test('what was done is taken back by u @slow', async ({ page }) => {
  await open(page, 'light', WIDE)
  await page.keyboard.press('a')
  await expect(page.getByText('shield_hit A approved. Alpha is 4 of 10.')).toBeVisible()
  await expectAccessible(page)
  await page.keyboard.press('u')
  await expect(page.getByText('shield_hit A approved. Alpha is 4 of 10.')).toBeHidden()
})

test('the scheme is chosen in the menu, and kept @slow', async ({ page }) => {
  await open(page, 'light', WIDE)
  const scheme = () => page.evaluate(() => document.documentElement.dataset.mantineColorScheme)
  await page.getByRole('button', { name: 'Settings' }).click()
  await page.getByRole('menuitemradio', { name: 'Dark' }).click()
  expect(await scheme()).toBe('dark')
  await page.reload()
  expect(await scheme()).toBe('dark')
})

test('a sound plays, moves its playhead, and another takes over where it stands @slow', async ({ page }) => {
  await open(page, 'light', WIDE)
  const stage = page.getByRole('region', { name: 'Stage' })
  const slider = stage.getByRole('slider').first()
  const at = () => slider.evaluate((element) => Number(getComputedStyle(element).getPropertyValue('--at')))
  await stage.getByRole('button', { name: 'Loop' }).click()
  await stage.getByRole('button', { name: 'Play', exact: true }).click()
  await expect(stage.getByRole('button', { name: 'Pause' })).toBeVisible()
  await expect.poll(at).toBeGreaterThan(0.05)
  await page.keyboard.press('b')
  await expect(stage.getByRole('slider', { name: 'Position in shield_hit, B' })).toBeVisible()
  await expect(stage.getByRole('button', { name: 'Pause' })).toBeVisible()
  await stage.getByRole('button', { name: 'Pause' }).click()
  const stood = await at()
  await page.waitForTimeout(150)
  expect(await at()).toBe(stood)
  await slider.focus()
  await page.keyboard.press('Home')
  await expect(slider).toHaveAttribute('aria-valuetext', '0.000 seconds')
  await page.keyboard.press('Shift+ArrowRight')
  await expect(slider).toHaveAttribute('aria-valuetext', '0.100 seconds')
})
