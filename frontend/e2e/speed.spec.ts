import { writeFile } from 'node:fs/promises'

import { type CDPSession, expect, type Page, test as base } from '@playwright/test'

import { ask } from './api'
import { test } from './fixtures'
import { addressOf, PASSWORD } from './party'
import { wav } from './sounds'

/** A slow connection off-site: 1.6 Mbit/s and 150 ms. */
const BYTES_PER_S = 200_000
const LATENCY_MS = 150
/** How many files are dropped: FILES=1000 measures a large delivery. */
const FILES = Number(process.env.FILES ?? 120)

interface Asked {
  path: string
  kind: 'script' | 'style' | 'preview' | 'peaks' | 'other'
  bytes: number
  startedAtS: number
  /** Infinity until then. */
  endedAtS: number
}

interface Loaded {
  /** In the order in which they were asked for, by the browser's clock; later ones are added. */
  requests: Asked[]
  shift: number
  /** Largest contentful paint. */
  paintedS: number
}

const kindOf = (path: string): Asked['kind'] => {
  if (path.endsWith('.js')) return 'script'
  if (path.endsWith('.css')) return 'style'
  if (path.endsWith('/preview')) return 'preview'
  return path.endsWith('/peaks.json') ? 'peaks' : 'other'
}

async function slow(page: Page): Promise<CDPSession> {
  const devtools = await page.context().newCDPSession(page)
  await devtools.send('Network.enable')
  await devtools.send('Network.emulateNetworkConditions', {
    offline: false,
    latency: LATENCY_MS,
    downloadThroughput: BYTES_PER_S,
    uploadThroughput: BYTES_PER_S,
  })
  return devtools
}

/** Open a page over the slow connection with an empty cache, and wait until it shows what it is for. */
async function load(page: Page, url: string, isShown: () => Promise<void>): Promise<Loaded> {
  const devtools = await slow(page)
  const requests: Asked[] = []
  const byId = new Map<string, Asked>()
  devtools.on('Network.requestWillBeSent', ({ requestId, request, timestamp }) => {
    const path = new URL(request.url).pathname
    if (path === '/v1/events') return // open as long as the page
    const one = { path, kind: kindOf(path), bytes: 0, startedAtS: timestamp, endedAtS: Infinity }
    byId.set(requestId, one)
    requests.push(one)
  })
  devtools.on('Network.loadingFinished', ({ requestId, encodedDataLength, timestamp }) => {
    const one = byId.get(requestId)
    if (one) Object.assign(one, { bytes: encodedDataLength, endedAtS: timestamp })
  })
  devtools.on('Network.loadingFailed', ({ requestId, timestamp }) => {
    const one = byId.get(requestId) // the page needs it no more
    if (one) one.endedAtS = timestamp
  })
  await page.addInitScript(() => {
    const seen = { shift: 0, paintedS: 0 }
    Object.assign(globalThis, { seen })
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries() as (PerformanceEntry & { value: number; hadRecentInput: boolean })[]) {
        if (!entry.hadRecentInput) seen.shift += entry.value
      }
    }).observe({ type: 'layout-shift', buffered: true })
    new PerformanceObserver((list) => {
      seen.paintedS = (list.getEntries().at(-1)?.startTime ?? 0) / 1_000
    }).observe({ type: 'largest-contentful-paint', buffered: true })
  })
  await page.goto(url)
  await isShown()
  const waitsFor = () => requests.filter(({ endedAtS }) => endedAtS === Infinity).map(({ path: asked }) => asked)
  await expect.poll(waitsFor).toEqual([])
  const seen = await page.evaluate(() => (globalThis as unknown as { seen: Pick<Loaded, 'shift' | 'paintedS'> }).seen)
  return { ...seen, requests }
}

const bytesOf = (requests: Asked[], kind: string) =>
  requests.filter((asked) => asked.kind === kind).reduce((sum, { bytes }) => sum + bytes, 0)

/** Seconds depend on the machine, so they are reported and not judged. */
function report(name: string, loaded: Loaded): void {
  const kb = (kind: string) => `${Math.round(bytesOf(loaded.requests, kind) / 1_000)} kB ${kind}`
  const description =
    `LCP ${loaded.paintedS.toFixed(1)} s, shift ${loaded.shift.toFixed(3)}, ` +
    `${loaded.requests.length} requests, ${['script', 'style', 'preview', 'other'].map(kb).join(', ')}`
  base.info().annotations.push({ type: `${name}, 1.6 Mbit/s`, description })
  console.log(`${name}: ${description}`)
}

// The build holds what a page needs to start below 200 KiB; Review goes on to load what its first version has.
for (const { name, part, path, shows, most = 200 * 1_024 } of [
  { name: 'sign-in', part: 'producer', path: () => '/sign-in', shows: 'Forgot password?' },
  { name: 'Today', part: 'approver', path: (project: string) => `${project}/today`, shows: 'Waiting on others' },
  { name: 'Review', part: 'approver', path: (project: string) => `${project}/review`, shows: 'Compare', most: 213_000 },
  { name: 'desk', part: 'designer', path: (project: string) => `${project}/desk`, shows: 'Your desk' },
]) {
  test(`${name} over a slow connection @slow`, async ({ demo, context, page }) => {
    await context.addCookies([{ name: 'soundlist_demo_part', value: part, url: demo.url }])
    const loaded = await load(page, demo.url + path(`/projects/${demo.projectId}`), () =>
      expect(page.getByText(shows).first()).toBeAttached(),
    )
    report(name, loaded)
    const base = loaded.requests.find(({ path: at }) => at.startsWith('/assets/base-') && at.endsWith('.js'))
    const data = loaded.requests.find(({ path: at }) => at.startsWith('/v1/'))
    expect.soft(data?.startedAtS, 'data asked for while the script is on its way').toBeLessThan(base?.endedAtS ?? 0)
    expect.soft(bytesOf(loaded.requests, 'script'), 'compressed script').toBeLessThan(most)
    expect.soft(bytesOf(loaded.requests, 'style'), 'compressed styles').toBeLessThan(30_000)
    expect.soft(loaded.shift, 'layout shift').toBeLessThanOrEqual(0.05)
  })
}

test('Review asks for no sound before its peaks are here, and for one at a time @slow', async ({
  demo,
  context,
  page,
}) => {
  await context.addCookies([{ name: 'soundlist_demo_part', value: 'approver', url: demo.url }])
  const { requests } = await load(page, `${demo.url}/projects/${demo.projectId}/review`, () =>
    expect(page.getByText('Compare').first()).toBeAttached(),
  )
  const sounds = () => requests.filter(({ kind }) => kind === 'preview')
  await expect.poll(() => sounds().filter(({ endedAtS }) => endedAtS < Infinity).length).toBeGreaterThan(2)
  const peaks = requests.find(({ kind }) => kind === 'peaks')
  const [first] = sounds()
  expect(peaks?.endedAtS).toBeLessThan(first?.startedAtS ?? 0)
  const overlapping = sounds().filter(({ startedAtS }, index) => startedAtS < (sounds()[index - 1]?.endedAtS ?? 0))
  expect(overlapping).toEqual([])
})

test('Today asks for no sound before one is played @slow', async ({ demo, context, page }) => {
  await context.addCookies([{ name: 'soundlist_demo_part', value: 'approver', url: demo.url }])
  const { requests } = await load(page, `${demo.url}/projects/${demo.projectId}/today`, () =>
    expect(page.getByText('Waiting on others').first()).toBeAttached(),
  )
  const sounds = () => requests.filter(({ kind }) => kind === 'preview')
  expect(sounds()).toEqual([])
  await page.getByRole('button', { name: 'Play' }).first().click()
  await expect.poll(() => sounds().length).toBeGreaterThan(0)
})

test('small files take one request each, and the lists few @slow', async ({ server, page }, testInfo) => {
  const context = page.context()
  await page.goto(`${server.url}/sign-up`)
  await page.getByLabel('Your name').fill('Producer')
  await page.getByLabel('Email').fill(addressOf('producer'))
  await page.getByLabel('Password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { name: 'What is the game called?' })).toBeVisible()
  const me = await ask<{ studios: { id: string }[] }>(context, `${server.url}/v1/me`)
  const opened = { studio_id: me.studios[0]?.id, name: 'Deep Field', cue_prefix: 'DF', preset: '44k1' }
  const { id } = await ask<{ id: string }>(context, `${server.url}/v1/projects`, 'POST', opened)
  await ask(context, `${server.url}/v1/projects/${id}/invitations`, 'POST', { email: addressOf('designer') })
  let link = ''
  await expect(async () => {
    const outbox = `${server.url}/v1/studios/${opened.studio_id}/outbox`
    const { mails } = await ask<{ mails: { recipient: string; link: string | null }[] }>(context, outbox)
    link = mails.find(({ recipient }) => recipient === addressOf('designer'))?.link ?? ''
    expect(link).not.toBe('')
  }).toPass()
  await context.clearCookies()
  await page.goto(link)
  await page.getByRole('button', { name: 'Start delivering' }).click()
  await page.getByLabel('Your name').fill('Sound designer')
  await page.getByLabel('New password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { name: 'Your desk' })).toBeVisible()

  const paths: string[] = []
  for (let index = 0; index < FILES; index += 1) {
    const path = testInfo.outputPath(`step_${index}.wav`)
    await writeFile(path, wav({ seconds: 0.1, pitchHz: 300 + index }))
    paths.push(path)
  }
  const asked: string[] = []
  page.on('request', (request) => asked.push(`${request.method()} ${new URL(request.url()).pathname}`))
  await page.evaluate(() => {
    const tasks: number[] = []
    Object.assign(globalThis, { tasks })
    new PerformanceObserver((list) => tasks.push(...list.getEntries().map(({ duration }) => duration))).observe({
      type: 'longtask',
    })
  })
  const startedAt = performance.now()
  await page.getByLabel('Files to deliver').setInputFiles(paths)
  const taken = async () => {
    const { items } = await ask<{ items: { takes_count: number }[] }>(
      context,
      `${server.url}/v1/projects/${id}/deliveries`,
    )
    return items[0]?.takes_count
  }
  await expect.poll(taken, { timeout: 240_000 }).toBe(FILES)
  const seconds = (performance.now() - startedAt) / 1_000
  const tasks = await page.evaluate(() => (globalThis as unknown as { tasks: number[] }).tasks)
  const longest = tasks.sort((a, b) => b - a).slice(0, 8)
  console.log(
    `${FILES} files: ${seconds.toFixed(1)} s, ${asked.length} requests, ` +
      `${tasks.filter((ms) => ms > 100).length} tasks over 100 ms: ${longest.map(Math.round).join(', ')} ms`,
  )
  expect(asked.filter((one) => one.startsWith('POST') && one.endsWith('/files'))).toHaveLength(FILES)
  // Five lists every 2 s, what is polled every second or less often, and what the tray shows of each file's sound.
  expect(asked.length).toBeLessThan(3 * FILES + 20 + 8 * seconds)
})
