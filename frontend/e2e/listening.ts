import { type BrowserContext, expect, type Page } from '@playwright/test'

import { ask, send } from './api'

/** Approve by the key what the person has not heard: it is played first, and the second press decides. */
export async function listenAndApprove(page: Page): Promise<void> {
  await page.keyboard.press('a')
  await expect(page.getByText(/^Heard\. Press Approve/)).toBeVisible({ timeout: 30_000 })
  await page.keyboard.press('a')
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
