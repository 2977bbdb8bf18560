import { createHash } from 'node:crypto'
import { writeFile } from 'node:fs/promises'

import { expect, type Page, type TestInfo } from '@playwright/test'

import { ask, bytesAt } from './api'
import { test } from './fixtures'
import { addressOf, PASSWORD } from './party'
import { wav } from './sounds'

const LINE_BYTES_PER_S = 300_000
/** Nearly nothing: what is on its way stays there, however long the test takes to look. */
const HELD_BYTES_PER_S = 10_000
const BUCKET_BYTES_PER_S = 8_000_000
const PART_BYTES = 16 * 2 ** 20

const ambience = (seconds: number) => wav({ seconds, channels: 2, pitchHz: 70 })
const sha256Of = (bytes: Buffer) => createHash('sha256').update(bytes).digest('hex')

interface Take {
  id: string
  state: string
  master_sha256: string
  master_bytes: number
}

/** A designer at the desk of a new project, whose list asks for one long sound. */
async function atDesk(page: Page, url: string, seconds: number): Promise<string> {
  const context = page.context()
  const email = addressOf('designer')
  await page.goto(`${url}/sign-up`)
  await page.getByLabel('Your name').fill('Producer')
  await page.getByLabel('Email').fill(addressOf('producer'))
  await page.getByLabel('Password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { name: 'What is the game called?' })).toBeVisible()

  const me = await ask<{ studios: { id: string }[] }>(context, `${url}/v1/me`)
  const studioId = me.studios[0]?.id ?? ''
  const opened = { studio_id: studioId, name: 'Deep Field', cue_prefix: 'DF', preset: '44k1' }
  const { id: projectId } = await ask<{ id: string }>(context, `${url}/v1/projects`, 'POST', opened)
  const project = `${url}/v1/projects/${projectId}`
  await ask(context, `${project}/cues`, 'POST', {
    cues: [{ name: 'amb_bridge_loop', category: 'ambience', duration_s: seconds, loop: true }],
  })
  await ask(context, `${project}/invitations`, 'POST', { email })
  let link = ''
  await expect(async () => {
    const { mails } = await ask<{ mails: { recipient: string; link: string | null }[] }>(
      context,
      `${url}/v1/studios/${studioId}/outbox`,
    )
    link = mails.find(({ recipient }) => recipient === email)?.link ?? ''
    expect(link).not.toBe('')
  }).toPass()

  await context.clearCookies()
  await page.goto(link)
  await page.getByRole('button', { name: 'Start delivering' }).click()
  await page.getByLabel('Your name').fill('Sound designer')
  await page.getByLabel('New password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { name: 'Your desk' })).toBeVisible()
  return projectId
}

/** Choose file of the disk, as people do: bytes would be handed to the browser as text, which takes it long. */
async function send(page: Page, bytes: Buffer, testInfo: TestInfo): Promise<void> {
  const path = testInfo.outputPath('amb_bridge_loop.wav')
  await writeFile(path, bytes)
  await page.getByLabel('Files to deliver').setInputFiles(path)
}

const row = (page: Page) =>
  page
    .getByRole('list', { name: 'Files in this delivery' })
    .getByRole('listitem')
    .filter({ hasText: 'amb_bridge_loop' })

/** Expect that the stored master is the file, to the byte. */
async function expectWhole(page: Page, url: string, projectId: string, sent: Buffer): Promise<void> {
  await expect(page.getByText('1 file checked')).toBeVisible()
  const { items } = await ask<{ items: Take[] }>(page.context(), `${url}/v1/projects/${projectId}/takes`)
  expect(items).toHaveLength(1)
  expect(items[0]).toMatchObject({ state: 'conforming', master_bytes: sent.length })
  const stored = await bytesAt(page.request, `${url}/v1/takes/${items[0]?.id}/master`)
  expect(sha256Of(stored)).toBe(sha256Of(sent))
}

test('an upload goes on where it was after the line dropped and the web process was killed @slow', async ({
  behindLine: { line, server },
  page,
}, testInfo) => {
  const file = ambience(12)
  const projectId = await atDesk(page, server.url, 12)
  const beforeBytes = line.carriedBytes
  const sent = async (bytes: number) => {
    line.bytesPerS = LINE_BYTES_PER_S
    await expect.poll(() => line.carriedBytes - beforeBytes, { intervals: [50] }).toBeGreaterThan(bytes)
    line.bytesPerS = HELD_BYTES_PER_S
  }
  line.bytesPerS = LINE_BYTES_PER_S
  await send(page, file, testInfo)

  await sent(0.2 * file.length)
  await expect(row(page)).toContainText('Uploading')
  line.cut()
  await expect(row(page)).toContainText('Reconnecting')
  await expect(row(page)).toContainText(/Connection lost at .+ MB\. The upload resumes by itself\./)
  line.fix()
  await expect(row(page)).toContainText(/resumed at \d/)

  await sent(0.6 * file.length)
  await server.killWeb()
  await expect(row(page)).toContainText('Reconnecting')
  await server.startWeb()
  await expect(row(page)).toContainText(/resumed at \d/)

  line.bytesPerS = Infinity
  await expectWhole(page, server.url, projectId, file)
  expect(line.carriedBytes - beforeBytes, 'nearly nothing was sent twice').toBeLessThan(1.5 * file.length)
})

test('a large file goes to the bucket in parts, and goes on with the part that was lost @slow', async ({
  withBucket: { bucket, server },
  page,
}, testInfo) => {
  const file = ambience(100)
  expect(file.length).toBeGreaterThan(1.5 * PART_BYTES)
  const projectId = await atDesk(page, server.url, 100)
  bucket.line.bytesPerS = BUCKET_BYTES_PER_S
  await send(page, file, testInfo)

  await expect.poll(() => bucket.line.carriedBytes, { intervals: [50] }).toBeGreaterThan(PART_BYTES + 1_000_000)
  bucket.line.cut()
  await expect(row(page)).toContainText('Reconnecting')
  bucket.line.bytesPerS = Infinity
  bucket.line.fix()
  await expect(row(page)).toContainText('resumed at 16.8 MB')
  await expectWhole(page, server.url, projectId, file)
  expect(bucket.line.carriedBytes, 'the part that was there was not sent again').toBeLessThan(1.5 * file.length)
})
