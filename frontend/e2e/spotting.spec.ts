import { type Browser, expect, type Page } from '@playwright/test'

import { ask } from './api'
import { atWork, visit } from './atWork'
import { test } from './fixtures'

// The browser's own test tone instead of a microphone, allowed without asking.
test.use({
  launchOptions: {
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--use-fake-device-for-media-stream',
      '--use-fake-ui-for-media-stream',
      '--autoplay-policy=no-user-gesture-required',
    ],
  },
})

interface Cue {
  id: string
  name: string
  category: string
  duration_s: number | null
}

/** A clip of some seconds, filmed in the browser: a square that moves. */
async function film(page: Page, seconds: number): Promise<Buffer> {
  const base64 = await page.evaluate(async (lengthS) => {
    const canvas = document.createElement('canvas')
    const context = canvas.getContext('2d')
    let frame = 0
    const timer = setInterval(() => {
      context?.clearRect(0, 0, canvas.width, canvas.height)
      context?.fillRect((frame++ * 4) % canvas.width, 40, 40, 40)
    }, 33)
    const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: 'video/webm' })
    const parts: Blob[] = []
    recorder.ondataavailable = ({ data }) => parts.push(data)
    recorder.start()
    await new Promise((resolve) => setTimeout(resolve, lengthS * 1000))
    const stopped = new Promise((resolve) => {
      recorder.onstop = resolve
    })
    recorder.stop()
    await stopped
    clearInterval(timer)
    const bytes = new Uint8Array(await new Blob(parts).arrayBuffer())
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''))
  }, seconds)
  return Buffer.from(base64, 'base64')
}

const cuesOf = async (page: Page, url: string, project: string): Promise<Cue[]> =>
  (await ask<{ cues: Cue[] }>(page.context(), `${url}/v1/projects/${project}/sound-list`)).cues

async function spot(browser: Browser, url: string): Promise<void> {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(producer, designer, url, [{ name: 'Hull door open', category: 'ship' }])
  const board = `${url}/projects/${project}/references`

  await test.step('a clip is added to the board', async () => {
    await producer.goto(board)
    const buffer = await film(producer, 4)
    const clip = { name: 'walkway.webm', mimeType: 'video/webm', buffer }
    await producer.getByLabel('Files to add').setInputFiles(clip)
    await producer.getByRole('link', { name: 'Spot walkway.webm' }).click()
    await expect(producer.getByRole('heading', { name: 'Spotting: walkway.webm' })).toBeVisible()
    await expect(producer.locator('video')).toHaveAttribute('src', /file$/)
    await expect(producer.getByText(/^0:0[3-9]\.\d{3}$/)).toBeVisible() // how long it is
    await expect(producer.getByText('0:00.000')).toBeVisible()
  })

  await test.step('keys mark it while it plays, and the marks outlive a reload', async () => {
    await producer.keyboard.press('Space')
    await producer.waitForTimeout(400)
    await producer.keyboard.press('t')
    await producer.waitForTimeout(400)
    await producer.keyboard.down('t')
    await producer.waitForTimeout(800)
    await producer.keyboard.up('t')
    await producer.keyboard.press('Space')
    await expect(producer.getByLabel('Length of walkway 2')).not.toHaveValue('')
    await producer.keyboard.press('e')
    await producer.keyboard.type('Hull door close')
    await expect(producer.getByLabel('Category of Hull door close')).toHaveValue('ship')
    await producer.reload()
    await expect(producer.getByText('Draft restored')).toBeVisible()
    await expect(producer.getByLabel('Name of mark 2')).toHaveValue('Hull door close')
  })

  await test.step('they become cues in one act, which is undone and done again', async () => {
    await producer.keyboard.press('Control+Enter')
    await expect(producer.getByText('2 cues made from walkway.webm.')).toBeVisible()
    expect((await cuesOf(producer, url, project)).map(({ name }) => name)).toEqual([
      'Hull door open',
      'walkway 1',
      'Hull door close',
    ])
    await producer.keyboard.press('u')
    await expect(async () => expect(await cuesOf(producer, url, project)).toHaveLength(1)).toPass()
    await producer.goto(board)
    await producer.getByRole('link', { name: 'Spot walkway.webm' }).click()
    await expect(producer.getByLabel('Name of mark 2')).toHaveValue('Hull door close')
    await producer.keyboard.press('Control+Enter')
    await expect(producer.getByText('2 cues made from walkway.webm.')).toBeVisible()
  })

  const close = (await cuesOf(producer, url, project)).find(({ name }) => name === 'Hull door close')
  expect(close?.category).toBe('ship')
  const page = `${url}/projects/${project}/sound-list/cues/${close?.id}`
  await test.step('a placeholder is said at one of them', async () => {
    await producer.goto(page)
    await expect(producer.getByRole('article', { name: 'walkway.webm' })).toContainText(/Clip, 0:0/)
    await expect(producer.getByRole('button', { name: /^Record a placeholder/ })).toBeVisible()
    await producer.keyboard.down('v')
    await expect(producer.getByText('Recording, 10 s at most.')).toBeVisible()
    await producer.waitForTimeout(1_500)
    await producer.keyboard.up('v')
    await expect(producer.getByText(/s, said by Producer/)).toBeVisible()
    await producer.getByRole('button', { name: 'Play placeholder' }).click()
    await expect(async () => {
      const position = await producer.evaluate(() => document.querySelector('audio')?.currentTime ?? 0)
      expect(position).toBeGreaterThan(0)
    }).toPass()
  })

  await test.step('the designer sees the part of the clip and hears the placeholder; the team reads who opened it', async () => {
    await designer.goto(page)
    await expect(designer.getByRole('button', { name: 'Play placeholder' })).toBeVisible()
    await expect(designer.getByRole('button', { name: /^Say/ })).toHaveCount(0)
    await designer.getByRole('button', { name: 'Play walkway.webm' }).click()
    await expect(designer.locator('video')).toHaveAttribute('src', /#t=\d/)
    await producer.goto(board)
    const region = producer.getByRole('region', { name: 'Hull door close' })
    await region.getByRole('button', { name: /^Edit/ }).click()
    await expect(producer.getByRole('dialog')).toContainText('Sound designer')
  })
}

test('a clip is spotted, and a placeholder said at one of its cues @slow', async ({ server, browser }) => {
  await spot(browser, server.url)
})
