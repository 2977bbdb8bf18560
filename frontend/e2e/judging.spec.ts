import { type BrowserContext, expect } from '@playwright/test'

import { ask } from './api'
import { atWork, visit } from './atWork'
import { test } from './fixtures'
import { Hand } from './hand'
import { wav } from './sounds'

const APPROVED = 24
const CHANGED = 16
const PAIRS = 10
/** Keys that decide: approve, undo and approve again; reason and send of a change; the choice among alternates. */
const VERDICT_KEYS = 3 * APPROVED + 3 * CHANGED + 6 * PAIRS
const MOST_REQUESTS = 2_000
const COMMENT = 'A clear attack, are the rest as dry?'

const names = (kind: string, many: number) =>
  Array.from({ length: many }, (_, index) => `${kind}_${'abcdefghijklmnopqrstuvwx'[index]}`)
const SINGLE = [...names('good', APPROVED), ...names('loud', CHANGED)]
const DOUBLE = names('pair', PAIRS)
const FILES = [...SINGLE, ...DOUBLE.flatMap((name) => [name, `${name}_altB`])].map((name) => `${name}.wav`)

/** Deliver as the designer's page does, and wait until all are checked and rendered. */
async function deliver(
  designer: BrowserContext,
  producer: BrowserContext,
  url: string,
  project: string,
): Promise<void> {
  const { id } = await ask<{ id: string }>(designer, `${url}/v1/projects/${project}/deliveries`, 'POST', { note: '' })
  const csrf = (await designer.cookies(url)).find(({ name }) => name === 'soundlist_csrf')?.value ?? ''
  for (const [index, name] of FILES.entries()) {
    const answer = await designer.request.post(`${url}/v1/deliveries/${id}/files`, {
      params: { file_name: name },
      data: wav({ seconds: 0.1, pitchHz: 300 + 7 * index }),
      headers: { 'X-CSRF-Token': csrf, 'Content-Type': 'application/octet-stream' },
    })
    expect(answer.ok(), await answer.text()).toBe(true)
  }
  const waiting = async () =>
    (await ask<{ cues: number }>(producer, `${url}/v1/review-queue/count?project_id=${project}`)).cues
  await expect.poll(waiting, { timeout: 150_000 }).toBe(SINGLE.length + DOUBLE.length)
}

test('an approver judges 60 versions by keys alone', async ({ server: { url }, browser }, testInfo) => {
  test.setTimeout(300_000)
  const [page, designer] = await Promise.all([visit(browser), visit(browser)])
  const cues = [...SINGLE, ...DOUBLE].map((name) => ({ name }))
  const project = await atWork(page, designer, url, cues)
  await deliver(designer.context(), page.context(), url, project)
  await designer.context().close()
  const approver = new Hand(page)
  const head = page.getByRole('heading', { level: 1, name: /^(good|loud|pair)_|^Nothing to review$/ })
  const toast = (text: string | RegExp) => expect(page.getByRole('status').filter({ hasText: text })).toBeVisible()
  let decided = 0
  const decide = async (...keys: string[]) => {
    decided += keys.length
    for (const key of keys) await approver.press(key)
  }
  const shown = async (name: string) => {
    await expect(head).toHaveText(name)
    await expect(page.getByRole('button', { name: /^Approve / })).toBeVisible()
  }

  await page.goto(`${url}/projects/${project}/review`)
  await expect(head).toHaveText(/_/)

  await test.step('a comment is sent, and the next key decides', async () => {
    const name = await head.innerText()
    await approver.press('c')
    await page.keyboard.type(COMMENT)
    await approver.press('Control+Enter')
    await approver.press('j')
    await expect(head).not.toHaveText(name)
    await approver.press('k')
    await shown(name)
    await expect(page.getByRole('list', { name: 'Comments' })).toContainText(COMMENT)
    await expect(page.getByText('comment at the playhead')).toBeVisible() // what was sent is no draft any more
  })

  const judge = async (name: string) => {
    await shown(name)
    if (name.startsWith('loud')) {
      await decide('r', '1', 'Enter')
    } else {
      const chosen = name.startsWith('pair') ? ['1', '2'] : []
      if (chosen.length > 0) await expect(page.getByRole('group', { name: 'Alternates' })).toBeVisible()
      await decide(...chosen, 'a')
      await toast(new RegExp(`^${name} .*approved`))
      await decide('u')
      await shown(name)
      await decide(...chosen.slice(1), 'a')
    }
    await expect(head).not.toHaveText(name)
  }
  const judged: string[] = []
  const judgeUntil = async (isEnough: () => boolean) => {
    while (!isEnough()) {
      const name = await head.innerText()
      if (name === 'Nothing to review') return
      await judge(name)
      judged.push(name)
    }
  }
  const noted = () => judged.filter((name) => name.startsWith('loud')).length

  await test.step('on a narrow page drafts are in sight, and two keys send them', async () => {
    await judgeUntil(() => noted() === 2)
    await page.setViewportSize({ width: 390, height: 844 })
    await expect(page.getByRole('button', { name: '2 changes to send' }).first()).toBeInViewport({ ratio: 1 })
    await page.screenshot({ path: testInfo.outputPath('drafts-narrow.png') })
    await approver.press('s')
    await expect(page.getByLabel(/^Message to the designer/)).toBeInViewport({ ratio: 1 })
    await expect(page.getByRole('button', { name: 'Send 2 changes to the designer' })).toBeInViewport({ ratio: 1 })
    await page.screenshot({ path: testInfo.outputPath('sending-narrow.png') })
    await expect(page.getByLabel(/^Message to the designer/)).toBeFocused()
    await approver.press('Enter')
    await toast('2 changes sent.')
    await approver.press('Escape')
    await page.setViewportSize({ width: 1440, height: 900 })
  })

  await test.step('the others follow, and none is judged twice', async () => {
    await judgeUntil(() => noted() === CHANGED - 1)
    await expect(page.getByRole('button', { name: /^\d+ changes to send/ }).last()).toBeInViewport({ ratio: 1 })
    await page.screenshot({ path: testInfo.outputPath('drafts-wide.png') })
    await judgeUntil(() => false)
    expect([...judged].sort()).toEqual(cues.map(({ name }) => name).sort())
    await approver.press('s')
    await approver.press('Enter')
    await toast(`${CHANGED - 2} changes sent.`)
  })

  approver.report(`${FILES.length} versions, ${decided} keys that decide`)
  expect(approver.clicks + approver.fields).toBe(0)
  expect(decided).toBeLessThanOrEqual(VERDICT_KEYS)
  expect(approver.keys - decided).toBeLessThanOrEqual(9)
  expect(approver.requests).toBeLessThanOrEqual(MOST_REQUESTS)
})
