import { mkdir, writeFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'

import { expect, type Page } from '@playwright/test'

import { test } from './fixtures'
import { ROOT } from './server'
import { wav } from './sounds'

/** The pictures of the guides: with PICTURES=1 (`make pictures`) they are written among the guides, else only taken. */
const FOLDER = process.env.PICTURES ? join(ROOT, 'docs/pictures') : undefined

/** The sounds of a game, by their paths and pitches in Hz. */
const GAME_SOUNDS = {
  'steps/grass_01.wav': 180,
  'steps/grass_02.wav': 190,
  'steps/grass_03.wav': 200,
  'ui/back.wav': 520,
  'ui/click.wav': 880,
  'weapon/laser.wav': 1_400,
}

interface Shown {
  name: string
  part: string
  person: string
  open: (page: Page, project: string) => Promise<void>
}

const SHOWN: Shown[] = [
  {
    name: 'today',
    part: 'Approver',
    person: 'Audio director',
    open: async (page) => {
      await page.goto('/today')
      await expect(page.getByRole('button', { name: /^Approve/ }).first()).toBeVisible()
    },
  },
  {
    name: 'sounds',
    part: 'Producer',
    person: 'Producer',
    open: async (page, project) => {
      await page.goto(`${project}/sound-list`)
      await expect(page.getByRole('row').filter({ hasText: 'shield_hit' }).first()).toBeVisible()
    },
  },
  {
    name: 'review',
    part: 'Approver',
    person: 'Audio director',
    open: async (page, project) => {
      await page.goto(`${project}/review`)
      await expect(page.getByRole('button', { name: 'Request change' })).toBeVisible()
      await expect(page.getByRole('slider').first()).toBeVisible()
    },
  },
  {
    name: 'desk',
    part: 'Sound designer',
    person: 'Sound designer',
    open: async (page, project) => {
      await page.goto(`${project}/desk`)
      await expect(page.getByRole('region', { name: /Needs your fix/ })).toBeVisible()
    },
  },
  ...producerPages({
    brief: ['brief', 'The game and its feel'],
    spec: ['spec', 'Delivery spec'],
    money: ['money', 'Money'],
    builds: ['builds', 'Builds'],
    game_files: ['game-files', 'Game files'],
    voice_lines: ['voice-lines', 'Voice lines'],
    studio: ['/studio', 'Shield Wing studio'],
    notices: ['/notices', 'Notices'],
  }),
  {
    name: 'contract',
    part: 'Producer',
    person: 'Producer',
    open: async (page, project) => {
      await page.goto(`${project}/contracts`)
      await page.getByRole('link', { name: /Effects/ }).click()
      await expect(page.getByRole('heading', { level: 1, name: /Effects/ })).toBeVisible()
    },
  },
  {
    name: 'bids',
    part: 'Producer',
    person: 'Producer',
    open: async (page, project) => {
      await page.goto(`${project}/postings`)
      await page.getByRole('link', { name: 'Effects' }).click()
      await page.getByRole('link', { name: /^Compare \d+ bids/ }).click()
      await expect(page.getByRole('heading', { level: 1, name: /bids on Effects/ })).toBeVisible()
    },
  },
  {
    name: 'adoption',
    part: 'Producer',
    person: 'Producer',
    open: async (page, project) => {
      const folder = test.info().outputPath('sounds')
      for (const [path, pitchHz] of Object.entries(GAME_SOUNDS)) {
        await mkdir(dirname(join(folder, path)), { recursive: true })
        await writeFile(join(folder, path), wav({ pitchHz }))
      }
      await page.goto(`${project}/sound-list/adopt`)
      await page.getByLabel('Folder', { exact: true }).setInputFiles(folder)
      await expect(page.getByRole('button', { name: /^Adopt \d+ files/ })).toBeVisible()
      await page.getByText(/^Cues/).click()
    },
  },
]

/** Pages of the producer by the name of their picture: path, below the project unless it begins with a slash, and heading. */
function producerPages(pages: Record<string, [string, string]>): Shown[] {
  return Object.entries(pages).map(([name, [path, heading]]) => ({
    name,
    part: 'Producer',
    person: 'Producer',
    open: async (page, project) => {
      await page.goto(path.startsWith('/') ? path : `${project}/${path}`)
      await expect(page.getByRole('heading', { level: 1, name: heading })).toBeVisible()
      await page.waitForLoadState('networkidle')
    },
  }))
}

test('the pictures of the guides, in light and in dark @slow', async ({ demo, browser }, testInfo) => {
  const context = await browser.newContext({ baseURL: demo.url, viewport: { width: 1280, height: 800 } })
  const page = await context.newPage()
  const folder = FOLDER ?? testInfo.outputPath('pictures')
  await mkdir(folder, { recursive: true })
  for (const { name, part, person, open } of SHOWN) {
    await page.goto('/')
    await page.getByRole('button', { name: /: account and settings$/ }).click()
    await page.getByRole('menuitemradio', { name: part }).click()
    await expect(page.getByRole('button', { name: `${person}: account and settings` })).toBeVisible()
    for (const colorScheme of ['light', 'dark'] as const) {
      await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' })
      await open(page, `/projects/${demo.projectId}`)
      await expect(page.getByText('Loading…')).toHaveCount(0)
      await page.evaluate(() => document.fonts.ready)
      await page.screenshot({ path: join(folder, `${name}_${colorScheme}.png`) })
    }
  }
  await context.close()
})
