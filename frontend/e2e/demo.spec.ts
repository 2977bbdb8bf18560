import { expect, type Locator, type Page } from '@playwright/test'

import { test } from './fixtures'
import { listenAndApprove } from './listening'

const first = (page: Page) => page.getByRole('heading', { level: 2, name: 'Pick one of three for shield_hit' })

async function playAs(page: Page, part: string | RegExp): Promise<void> {
  await page.getByRole('button', { name: /: account and settings$/ }).click()
  await page.getByRole('menuitemradio', { name: part }).click()
}

/** Note from now on how far a playhead comes: a short sound may be over before a busy machine looks again. */
async function watchPlayhead(slider: Locator): Promise<() => Promise<number>> {
  await slider.evaluate((element) => {
    const note = () => {
      const at = Number(getComputedStyle(element).getPropertyValue('--at'))
      if (at > Number(document.documentElement.dataset.farthest ?? 0))
        document.documentElement.dataset.farthest = `${at}`
      requestAnimationFrame(note)
    }
    note()
  })
  return () => slider.evaluate(() => Number(document.documentElement.dataset.farthest))
}

test('the first screen is one sound to hear and to decide by one key, and can be taken back', async ({
  demo,
  page,
}) => {
  await page.goto(demo.url)
  await expect(page).toHaveURL(/\/today$/)
  await expect(first(page)).toBeVisible()
  const slider = page.getByRole('slider', { name: 'shield_hit' })
  const farthest = await watchPlayhead(slider)
  await page.keyboard.press('Space')
  await expect.poll(farthest).toBeGreaterThan(0.05)
  await page.keyboard.press('b')
  await expect(page.getByRole('slider', { name: 'Position in shield_hit, B' })).toBeVisible()
  await page.keyboard.press('1')
  await expect(page.getByRole('slider', { name: 'Position in shield_hit, A' })).toBeVisible()

  await listenAndApprove(page, 'shield_hit A approved.')
  await expect(first(page)).toBeHidden()
  await expect(page.getByText('First because it has waited longest')).toBeVisible()
  await page.keyboard.press('u')
  await expect(first(page)).toBeVisible()
})

test('Review has twelve controls in sight at most beside its queue, and a change is requested by keys alone', async ({
  demo,
  page,
}) => {
  await page.goto(demo.url)
  await page
    .getByRole('link', { name: /^Review/ })
    .first()
    .click()
  await expect(page).toHaveURL(/\/review\/.+/)
  await expect(page.getByRole('button', { name: 'Request change' })).toBeVisible()
  const controls = page.locator('main').locator('button, input, select, textarea, [role=tab]').filter({ visible: true })
  expect(await controls.count()).toBeLessThanOrEqual(12)
  const cue = await page.getByRole('heading', { level: 1 }).innerText()
  await page.keyboard.press('r')
  await page.keyboard.type('duller')
  await page.keyboard.press('Enter')
  await expect(page.getByRole('status').filter({ hasText: `Change requested: ${cue}` })).toBeVisible()
  await page.keyboard.press('u')
  await expect(page.getByRole('heading', { level: 1, name: cue })).toBeVisible()
})

test('the menu switches between approver, producer, designer and build', async ({ demo, page }) => {
  await page.goto(demo.url)
  await expect(page.getByRole('button', { name: /^Approve A/ })).toBeVisible()

  await playAs(page, 'Producer')
  await expect(page.getByRole('region', { name: /^With the approver/ })).toBeVisible()
  await expect(page.getByRole('region', { name: /^Questions for you/ })).toBeVisible()
  await expect(page.getByRole('button', { name: /^Approve/ })).toBeHidden()

  await playAs(page, 'Sound designer')
  await expect(page.getByRole('heading', { level: 1, name: 'Your desk' })).toBeVisible()
  const back = page.getByRole('region', { name: /Needs your fix/ })
  await expect(back.getByRole('heading', { name: 'airlock_cycle' })).toBeVisible()
  await expect(back.getByRole('list', { name: 'Check results' })).toContainText(/peak/i)
  const tray = page.getByRole('region', { name: 'Unmatched files' })
  await expect(tray.getByRole('button', { name: /^victory_sting/ })).toBeVisible()

  await page.getByRole('button', { name: /: account and settings$/ }).click()
  await page.getByRole('menuitem', { name: /^Build/ }).click()
  await expect(page.getByRole('heading', { level: 1, name: 'Builds' })).toBeVisible()
  await expect(page.getByText('soundlist.pyz ci').first()).toBeVisible()

  await playAs(page, 'Approver')
  await expect(page.getByRole('button', { name: /^Approve A/ })).toBeVisible()
})

test('the game’s CI gets spec and list by the demo’s token', async ({ demo, request }) => {
  const headers = { Authorization: `Bearer ${demo.token}` }
  for (const [file, holds] of [
    ['spec.toml', '[targets.handheld]'],
    ['sound-list.csv', 'shield_hit'],
  ] as const) {
    const answer = await request.get(`${demo.url}/v1/projects/${demo.projectId}/${file}`, { headers })
    expect(answer.status()).toBe(200)
    expect(await answer.text()).toContain(holds)
  }
})

test('j and k keep the selected cue in sight where the queue is longer than its panel', async ({ demo, page }) => {
  await page.setViewportSize({ width: 1440, height: 420 })
  await page.goto(demo.url)
  await page.getByRole('link', { name: /^Review/ }).click()
  const queue = page.getByRole('complementary', { name: 'Queue' })
  const current = queue.locator('[aria-current]')
  await expect(current).toBeInViewport()
  const cues = await queue.getByRole('list').first().getByRole('listitem').count()
  expect(cues).toBeGreaterThan(3)
  for (let at = 1; at < cues; at++) {
    const before = await current.textContent()
    await page.keyboard.press('j')
    await expect(current).not.toHaveText(before ?? '')
    // Past whatever puts the list elsewhere once the page is drawn.
    await expect(page.getByRole('heading', { level: 1 })).toHaveText(await current.locator('.strong').innerText())
    await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))))
    await expect(current).toBeInViewport({ ratio: 0.9 })
  }
})
