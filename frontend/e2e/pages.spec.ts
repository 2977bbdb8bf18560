import { type BrowserContext, expect, type Page } from '@playwright/test'

import { ask } from './api'
import { expectAccessible } from './axe'
import { test } from './fixtures'
import type { Demo } from './server'

interface Place {
  name: string
  path: string
  /** What the page shows once it has what it needs. */
  shows: string | RegExp
}

const SIZES = { wide: { width: 1440, height: 900 }, narrow: { width: 390, height: 844 } }
const SCHEMES = ['light', 'dark'] as const

type Part = 'producer' | 'rooms' | 'approver' | 'designer' | 'guest'
/** Who looks: the producer has more pages than one walk should take. */
const LOOKS = { producer: 'producer', rooms: 'producer', approver: 'approver', designer: 'designer', guest: 'producer' }

async function placesOf(part: Part, context: BrowserContext, demo: Demo, size: string): Promise<Place[]> {
  const { url, projectId } = demo
  const project = `/projects/${projectId}`
  const { cues } = await ask<{ cues: { id: string; name: string }[] }>(context, `${url}/v1${project}/sound-list`)
  const cue = (name: string) => cues.find((one) => one.name === name)?.id ?? ''
  const returned = `${url}/v1${project}/takes?state=returned`
  const { items: takes } = await ask<{ items: { id: string; cue: object | null }[] }>(context, returned)
  const take = takes.find((one) => one.cue !== null)?.id ?? ''
  const contracts = await ask<{ id: string; title: string }[]>(context, `${url}/v1${project}/contracts`)
  const agreed = contracts.find(({ title }) => title === 'Effects')
  const divided = contracts.find(({ title }) => title === 'Voice lines')
  const contract = `${project}/contracts/${agreed?.id}`
  const { milestones } = await ask<{ milestones: { id: string; name: string }[] }>(
    context,
    `${url}/v1/contracts/${agreed?.id}/milestones`,
  )
  const between: Place[] = [
    { name: 'contracts', path: `${project}/contracts`, shows: agreed?.title ?? '' },
    { name: 'contract', path: contract, shows: 'Signed by' },
    { name: 'contract-record', path: `${contract}/record`, shows: /sha256|SHA-256/i },
    { name: 'money', path: `${project}/money`, shows: /Invoice/ },
    { name: 'milestone', path: `${project}/milestones/${milestones[0]?.id}`, shows: milestones[0]?.name ?? '' },
  ]
  const list: Place[] = [
    { name: 'take', path: `/takes/${take}`, shows: 'Spectrum of the whole sound' },
    { name: 'sound-list', path: `${project}/sound-list`, shows: 'drone_swarm_loop' },
    {
      name: 'cue',
      path: `${project}/sound-list/cues/${cue('shield_hit')}`,
      shows: 'An enemy shot meets the shield; must read over laser fire.',
    },
    { name: 'compare', path: `${project}/sound-list/compare`, shows: 'Compare revisions' },
    { name: 'project', path: project, shows: 'Sounds' },
    { name: 'progress', path: `${project}/progress`, shows: 'Delivery spec' },
    { name: 'activity', path: `${project}/activity`, shows: 'Recent activity' },
    { name: 'notifications', path: '/account/notifications', shows: 'Emails' },
    { name: 'reasons', path: `${project}/reasons`, shows: 'Reasons' },
    { name: 'spec-versions', path: `${project}/spec/versions`, shows: /version/i },
    { name: 'account', path: '/account', shows: 'Password' },
  ]
  const team: Place[] = [
    { name: 'today', path: `${project}/today`, shows: 'Waiting on others' },
    { name: 'review', path: `${project}/review/${cue('shield_hit')}`, shows: 'Compare' },
    { name: 'review-set', path: `${project}/review/${cue('thruster_burst')}`, shows: 'Randomise' },
    { name: 'people', path: `${project}/people`, shows: 'Invite a designer' },
    { name: 'approvers', path: `${project}/approvers`, shows: 'approves or returns every sound' },
    { name: 'approval', path: `${project}/approval`, shows: 'Before approval' },
    { name: 'builds', path: `${project}/builds`, shows: 'soundlist.pyz ci' },
    { name: 'projects', path: '/projects', shows: 'Shield Wing' },
    { name: 'studio', path: '/studio', shows: 'Shield Wing studio' },
    ...list,
  ]
  switch (part) {
    case 'producer':
      return [
        ...team,
        ...between,
        { name: 'game-files', path: `${project}/game-files`, shows: /handheld/i },
        { name: 'packs', path: `${project}/packs`, shows: /pack/i },
        { name: 'placeholders', path: `${project}/placeholders`, shows: /placeholder/i },
        { name: 'import', path: `${project}/sound-list/import`, shows: 'Spreadsheet' },
        { name: 'spec', path: `${project}/spec`, shows: 'Every sound' },
        { name: 'new-project', path: '/projects/new', shows: 'Create project' },
        { name: 'tokens', path: `${project}/tokens`, shows: 'Tokens' },
        { name: 'settings', path: `${project}/settings`, shows: 'Cue ID prefix' },
        { name: 'operations', path: '/operations', shows: 'Jobs and storage' },
        { name: 'nowhere', path: '/no/such/page', shows: 'Page not found' },
      ]
    case 'rooms':
      return [
        { name: 'brief', path: `${project}/brief`, shows: 'Next topic' },
        { name: 'brief-versions', path: `${project}/brief/versions`, shows: 'Versions of the brief' },
        { name: 'kits', path: `${project}/sound-list/kits`, shows: 'Start from a kit' },
        { name: 'adopt', path: `${project}/sound-list/adopt`, shows: 'Choose a folder' },
        { name: 'columns', path: `${project}/sound-list/columns`, shows: 'Add a column' },
        { name: 'references', path: `${project}/references`, shows: 'References' },
        { name: 'postings', path: `${project}/postings`, shows: 'Awarded' },
        { name: 'joint-work', path: `${project}/contracts/${divided?.id}`, shows: 'Joint work' },
        { name: 'hours', path: `${project}/hours`, shows: 'Hours' },
        { name: 'roster', path: '/roster', shows: 'Add a person' },
        { name: 'roster-import', path: '/roster/import', shows: 'Import into the roster' },
        { name: 'voice-lines', path: `${project}/voice-lines`, shows: 'By the light of a thousand suns.' },
        { name: 'voice-script', path: `${project}/voice-lines/import`, shows: 'Import a script' },
        { name: 'changes', path: `${contract}/changes`, shows: 'Propose a change order' },
        { name: 'ending', path: `${contract}/ending`, shows: 'Forecast' },
        { name: 'redlines', path: `${contract}/redlines`, shows: 'Redlines' },
        { name: 'drift', path: `${project}/drift`, shows: 'Volume' },
        { name: 'listening', path: `${project}/listening`, shows: 'Notes of this pass' },
        { name: 'recording', path: `${project}/recording`, shows: 'Recording of the game' },
        { name: 'game-tasks', path: `${project}/game-tasks`, shows: 'Implementation tasks' },
        { name: 'credits', path: `${project}/credits`, shows: 'Add a name' },
        { name: 'verify', path: '/verify', shows: 'Verify a contract' },
      ]
    case 'approver':
      return team
    case 'designer':
      return [
        { name: 'desk', path: `${project}/desk`, shows: 'final_FINAL_sting2.wav' },
        { name: 'work', path: '/work', shows: 'Your work' },
        { name: 'voice-lines', path: `${project}/voice-lines`, shows: 'By the light of a thousand suns.' },
        ...between,
        ...list,
      ]
    case 'guest':
      return [
        { name: 'sign-in', path: '/sign-in', shows: 'Forgot password?' },
        { name: 'sign-up', path: '/sign-up', shows: 'Create your account' },
        { name: 'forgotten-password', path: '/forgotten-password', shows: 'Email' },
        { name: 'new-password', path: '/new-password/none', shows: 'New password' },
        { name: 'join', path: await joinPath(context, demo, size), shows: 'Join Shield Wing studio' },
        { name: 'invitation', path: await invitationPath(context, demo, size), shows: 'File requirements' },
        { name: 'check', path: '/checks/true-peak', shows: 'true-peak' },
      ]
  }
}

async function linkTo(context: BrowserContext, { url }: Demo, studioId: string, email: string): Promise<string> {
  let link: string | null | undefined
  await expect(async () => {
    const { mails } = await ask<{ mails: { recipient: string; link: string | null }[] }>(
      context,
      `${url}/v1/studios/${studioId}/outbox`,
    )
    link = mails.find(({ recipient }) => recipient === email)?.link
    expect(link).toBeTruthy()
  }).toPass()
  return new URL(link ?? '').pathname
}

const studioOf = async (context: BrowserContext, url: string) =>
  (await ask<{ studios: { id: string }[] }>(context, `${url}/v1/me`)).studios[0]?.id ?? ''

async function joinPath(context: BrowserContext, demo: Demo, size: string): Promise<string> {
  const studioId = await studioOf(context, demo.url)
  const email = `reviewer.${size}@soundlist.example`
  await ask(context, `${demo.url}/v1/studios/${studioId}/invitations`, 'POST', { email, roles: ['reviewer'] })
  return linkTo(context, demo, studioId, email)
}

async function invitationPath(context: BrowserContext, demo: Demo, size: string): Promise<string> {
  const studioId = await studioOf(context, demo.url)
  const email = `second.designer.${size}@soundlist.example`
  const note = 'Ambiences only; the rest is in good hands.'
  await ask(context, `${demo.url}/v1/projects/${demo.projectId}/invitations`, 'POST', { email, kind: 'contract', note })
  return linkTo(context, demo, studioId, email)
}

/** What goes wrong on a page without showing on it. */
function troubles(page: Page): string[] {
  const found: string[] = []
  page.on('pageerror', (error) => found.push(error.message))
  page.on('console', (message) => {
    if (message.type() === 'error') found.push(message.text())
  })
  page.on('request', (request) => {
    if (!/^(http:\/\/127\.0\.0\.1:|blob:|data:)/.test(request.url())) found.push(`asked for ${request.url()}`)
  })
  return found
}

/** Sign in to the demo as whoever looks; returns what goes wrong from then on. */
async function enter(page: Page, demo: Demo, part: Part): Promise<string[]> {
  await page.context().addCookies([{ name: 'soundlist_demo_part', value: LOOKS[part], url: demo.url }])
  await page.goto(`${demo.url}/sign-in`)
  await expect(page.getByText('This is the demo. You need no account:')).toBeVisible()
  return troubles(page)
}

async function open(page: Page, demo: Demo, { path, shows }: Place): Promise<void> {
  await page.goto(demo.url + path)
  await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1)
  await expect(page.getByText(shows).first()).toBeAttached()
  // What a page shows stands below its head, not beside the title.
  await expect.soft(page.locator('header:has(h1) :is(section, table, aside)')).toHaveCount(0)
}

async function expectNoSidewaysScroll(page: Page, name: string): Promise<void> {
  // A layout that follows the width by script follows it after the resize.
  const sideways = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
  await expect.soft.poll(sideways, { message: `${name} scrolls sideways` }).toBeLessThanOrEqual(0)
}

/** The pages that a part alone shows; the others are the same for two roles, and the producer's walk has them. */
const ONLY: Partial<Record<Part, string[]>> = { designer: ['desk', 'work'] }

// The producer's pages are left to the slow part: the walks of the fast one go through the most used of them.
for (const part of ['designer', 'guest'] as const) {
  test(`each page once: those of the ${part}`, async ({ demo, page }) => {
    await page.setViewportSize(SIZES.wide)
    await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce' })
    const broken = await enter(page, demo, part)
    const places = await placesOf(part, page.context(), demo, 'once')
    for (const place of places.filter(({ name }) => ONLY[part]?.includes(name) ?? true)) {
      await test.step(place.name, async () => {
        await open(page, demo, place)
        // Contrast is compared by src/test/contrast.test.ts for all pages, and on each page in the slow part.
        await expectAccessible(page, place.name, 'structure')
        await page.setViewportSize(SIZES.narrow)
        await expectNoSidewaysScroll(page, place.name)
        await page.setViewportSize(SIZES.wide)
        expect.soft(broken.splice(0), `${place.name}: errors in the console`).toEqual([])
      })
    }
  })
}

for (const part of ['producer', 'rooms', 'approver', 'designer', 'guest'] as const) {
  for (const size of ['wide', 'narrow'] as const) {
    test.describe(() => {
      test.describe.configure({ mode: 'parallel' })
      test(`pages of the ${part}, ${size}, light and dark @slow`, async ({ demo, page }) => {
        await page.setViewportSize(SIZES[size])
        const broken = await enter(page, demo, part)
        for (const place of await placesOf(part, page.context(), demo, size)) {
          const { name } = place
          await test.step(name, async () => {
            await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce' })
            await open(page, demo, place)
            for (const scheme of SCHEMES) {
              await page.emulateMedia({ colorScheme: scheme, reducedMotion: 'reduce' })
              await expectAccessible(page, `${name}, ${scheme}`, scheme === 'light' ? 'everything' : 'contrast')
              await expectNoSidewaysScroll(page, name)
            }
            expect.soft(broken.splice(0), `${name}: errors in the console`).toEqual([])
          })
        }
      })
    })
  }
}
