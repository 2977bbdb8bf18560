import { type BrowserContext, expect, type Page } from '@playwright/test'

import { ask, send } from './api'

/** Approve by the key: a press approves what was heard already, and plays what was not, or only from its middle. */
export async function listenAndApprove(page: Page, done: string): Promise<void> {
  const heard = page.getByText(/^Heard\. Press Approve/)
  const approved = page.getByRole('status').filter({ hasText: done })
  await expect(async () => {
    await page.keyboard.press('a')
    await expect(heard.or(approved).first()).toBeVisible({ timeout: 8_000 })
  }).toPass({ timeout: 300_000 })
  if (await heard.isVisible()) await page.keyboard.press('a')
  await expect(approved).toBeVisible()
}

interface Queue {
  items: { takes: { id: string }[] }[]
  next: string | null
}

/** Everything that waits in a project was heard by this person, elsewhere. */
export async function heardAll(context: BrowserContext, url: string, project: string): Promise<void> {
  let cursor: string | null = ''
  while (cursor !== null) {
    const after = cursor === '' ? '' : `&cursor=${encodeURIComponent(cursor)}`
    const page: Queue = await ask<Queue>(context, `${url}/v1/review-queue?project_id=${project}${after}`)
    const takeIds = page.items.flatMap(({ takes }) => takes.map(({ id }) => id))
    await send(context, `${url}/v1/projects/${project}/heard-takes`, 'POST', { take_ids: takeIds })
    cursor = page.next
  }
}
