/** The first minute of each role in Firefox, with a sound server of its own: without one Firefox plays nothing. */
import { execFileSync } from 'node:child_process'
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { tmpdir } from 'node:os'
import { join } from 'node:path'

import { expect } from '@playwright/test'
import { type Browser, launch, type Page } from 'puppeteer-core'

import { test } from './fixtures'
import { wav } from './sounds'

const AXE = createRequire(import.meta.url).resolve('axe-core/axe.min.js')
const FIREFOX = process.env.FIREFOX ?? '/usr/bin/firefox-esr'

/** Run something with Firefox and a sound server that plays to nowhere. */
async function withFirefox(work: (browser: Browser) => Promise<void>): Promise<void> {
  const folder = await mkdtemp(join(tmpdir(), 'firefox-'))
  const env = { ...process.env, HOME: folder, XDG_RUNTIME_DIR: folder }
  const modules = ['-L', 'module-null-sink', '-L', 'module-native-protocol-unix']
  execFileSync('pulseaudio', ['-n', '--daemonize=yes', '--exit-idle-time=-1', ...modules], { env, stdio: 'ignore' })
  const extraPrefsFirefox = { 'media.autoplay.default': 0, 'media.autoplay.blocking_policy': 0 }
  const browser = await launch({ browser: 'firefox', executablePath: FIREFOX, headless: true, env, extraPrefsFirefox })
  try {
    await work(browser)
  } finally {
    await browser.close()
    execFileSync('pulseaudio', ['--kill'], { env, stdio: 'ignore' })
    await rm(folder, { recursive: true, force: true })
  }
}

async function opened(browser: Browser, url: string, part: string, faults: string[]): Promise<Page> {
  const page = await browser.newPage()
  page.on('console', (message) => message.type() === 'error' && faults.push(`${part}: ${message.text()}`))
  page.on('pageerror', (error) => faults.push(`${part}: ${String(error)}`))
  await page.setViewport({ width: 1440, height: 900 })
  await browser.setCookie({ name: 'soundlist_demo_part', value: part, domain: new URL(url).hostname })
  await page.goto(url)
  return page
}

const says = (page: Page, words: string) =>
  page.waitForFunction((wanted) => document.body.innerText.includes(wanted), { timeout: 120_000 }, words)

async function expectUsable(page: Page, where: string): Promise<void> {
  await page.evaluate(await readFile(AXE, 'utf8'))
  for (const scheme of ['light', 'dark']) {
    await page.evaluate(async (one) => {
      document.documentElement.setAttribute('data-mantine-color-scheme', one)
      await new Promise(requestAnimationFrame)
      await Promise.allSettled(document.getAnimations().map(({ finished }) => finished)) // colours on their way
    }, scheme)
    const found = await page.evaluate(
      'axe.run(document, { resultTypes: ["violations"] }).then((found) => found.violations.map(({ id, nodes }) => id + nodes.map(({ html }) => html)))',
    )
    expect(found, `axe on ${where}, ${scheme}`).toEqual([])
  }
  await page.setViewport({ width: 390, height: 844 })
  const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)
  expect(over, `${where} is wider than a phone`).toBeLessThanOrEqual(0)
  await page.setViewport({ width: 1440, height: 900 })
}

test('in Firefox an approver hears and decides, a designer delivers, a producer reads the list', async ({ demo }) => {
  const faults: string[] = []
  await withFirefox(async (browser) => {
    const approver = await opened(browser, demo.url, 'approver', faults)
    await says(approver, 'Pick one of three for shield_hit')
    await approver.keyboard.press(' ')
    await approver.waitForFunction(
      () => Number(getComputedStyle(document.querySelector('[role=slider]')!).getPropertyValue('--at')) > 0.05,
      { timeout: 120_000 },
    )
    await approver.keyboard.press('a')
    await says(approver, 'Heard.')
    await approver.keyboard.press('a')
    await says(approver, 'shield_hit A approved.')
    await approver.keyboard.press('u')
    await says(approver, 'Pick one of three for shield_hit')
    await expectUsable(approver, 'Today')
    await approver.close()

    const designer = await opened(browser, demo.url, 'designer', faults)
    await says(designer, 'Your desk')
    const files = await mkdtemp(join(tmpdir(), 'deliver-'))
    const path = join(files, 'not_on_the_list.wav')
    await writeFile(path, wav({ seconds: 1 }))
    const chooser = await designer.waitForSelector('input[type=file][aria-label="Files to deliver"]')
    await (await chooser!.toElement('input')).uploadFile(path)
    await says(designer, 'not_on_the_list')
    await expectUsable(designer, 'the desk')
    await rm(files, { recursive: true })
    await designer.close()

    const producer = await opened(browser, `${demo.url}/projects/${demo.projectId}/sound-list`, 'producer', faults)
    await says(producer, 'drone_swarm_loop')
    await expectUsable(producer, 'the sound list')
  })
  expect(faults).toEqual([])
})
