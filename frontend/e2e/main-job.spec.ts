import { execFile } from 'node:child_process'
import { mkdir, readFile, writeFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import { promisify } from 'node:util'

import { type Browser, expect, type Page } from '@playwright/test'

import { ask } from './api'
import { expectAccessible } from './axe'
import { test } from './fixtures'
import { listenAndApprove } from './listening'
import { addressOf, PASSWORD } from './party'
import { ROOT } from './server'
import { unzip, wav, wavFacts, zip } from './sounds'

const SHEET = [
  'name\tcategory\tuse in the game\tlength\tvariations\tdescription',
  'shield_hit\tweapon\tEnemy shot meets the shield\t0.8\t1\tMust read over laser fire',
  'laser_fire\tweapon\tPlayer’s turret\tshort\t1\tThin and bright',
  'door_open\tfoley\tEvery cabin door\t0.4\t2\tServo and a bolt',
  'victory_sting\tmusic\tFleet wins the sector\t1.0\t1\tThree rising chords',
].join('\n')

/** What passes the check, by the name that it is delivered under. */
const GOOD: Record<string, Buffer> = {
  'shield_hit.wav': wav({ seconds: 0.8, pitchHz: 620 }),
  'shield_hit_altB.wav': wav({ seconds: 0.8, pitchHz: 410, rateHz: 96_000 }),
  'final_FINAL_sting2.wav': wav({ seconds: 1, pitchHz: 520, channels: 2, rateHz: 44_100, bits: 16 }),
  'doors.zip': zip({
    'doors/door_open_01.wav': wav({ seconds: 0.4, pitchHz: 300 }),
    'doors/door_open_02.wav': wav({ seconds: 0.4, pitchHz: 310 }),
  }),
}
const MP3_AS_WAV = Buffer.concat([Buffer.from('ID3\x04\x00\x00\x00\x00\x00\x00', 'latin1'), Buffer.alloc(2_000, 0x55)])

/** Let files go over the middle of the page, as from a folder of the desktop. */
async function dropFiles(page: Page, files: readonly string[]): Promise<void> {
  const devtools = await page.context().newCDPSession(page)
  const data = { items: [], files: [...files], dragOperationsMask: 1 }
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
    await devtools.send('Input.dispatchDragEvent', { type, x: 500, y: 400, data })
  }
}

/** A slow line, so that a file is seen on its way; 0 takes the brake off again. */
async function brake(page: Page, bytesPerS: number): Promise<void> {
  const devtools = await page.context().newCDPSession(page)
  const throughput = bytesPerS || -1
  await devtools.send('Network.emulateNetworkConditions', {
    offline: false,
    latency: 0,
    downloadThroughput: -1,
    uploadThroughput: throughput,
  })
}

/** A browser of somebody's own. */
async function arrive(browser: Browser, url: string): Promise<Page> {
  const context = await browser.newContext({ baseURL: url, viewport: { width: 1440, height: 900 } })
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  const page = await context.newPage()
  // From the start: a key opens the window for files sooner than a later listener could take it over.
  page.on('filechooser', () => undefined)
  return page
}

/** Give a file to the window that a key opens. */
async function chooseBy(key: string, page: Page, name: string, buffer: Buffer): Promise<void> {
  const choosing = page.waitForEvent('filechooser')
  await page.keyboard.press(key)
  const chooser = await choosing
  await chooser.setFiles({ name, mimeType: 'audio/wav', buffer })
}

const copied = (page: Page) => page.evaluate(() => navigator.clipboard.readText())
const toast = (page: Page, text: string | RegExp) =>
  expect(page.getByRole('status').filter({ hasText: text })).toBeVisible()
const projectOf = (page: Page) => /\/projects\/[0-9a-f-]{36}/.exec(page.url())?.[0] ?? ''
const card = (page: Page, name: string | RegExp) => page.getByRole('region', { name })
const line = (page: Page, file: string) =>
  page.getByRole('list', { name: 'Files in this delivery' }).getByRole('listitem').filter({ hasText: file })

/** Where the playhead stands in the sound on the stage, in seconds. */
const playhead = (page: Page) =>
  page
    .getByRole('slider')
    .first()
    .evaluate((slider) => Number(getComputedStyle(slider).getPropertyValue('--at')))

/** Open Review once so many cues wait there: game files are made after the check. */
async function openQueue(page: Page, url: string, project: string, waiting: number): Promise<void> {
  const queue = `${url}/v1/review-queue?project_id=${project.split('/').at(-1)}`
  await expect.poll(async () => (await ask<{ items: [] }>(page.context(), queue)).items.length).toBe(waiting)
  await page.goto(`${project}/review`)
  await expect(page.getByText(`${waiting} waiting`).first()).toBeAttached()
}

test('the main job, from an empty studio to a build that passed', async ({ server, browser }, testInfo) => {
  const [producer, approver, designer] = await Promise.all([
    arrive(browser, server.url),
    arrive(browser, server.url),
    arrive(browser, server.url),
  ])
  let project = ''

  await test.step('the producer opens a studio and a project', async () => {
    await producer.goto('/')
    await producer.getByRole('link', { name: 'Create an account' }).click()
    await producer.getByLabel('Your name').fill('Producer')
    await producer.getByLabel('Email').fill(addressOf('producer'))
    await producer.getByLabel('Password', { exact: true }).fill(PASSWORD)
    await producer.keyboard.press('Enter')
    await expect(producer.getByRole('heading', { name: 'What is the game called?' })).toBeVisible()
    await producer.getByLabel('Game title').fill('Deep Field')
    await producer.getByRole('button', { name: 'More options' }).click()
    await producer.getByLabel('Description (optional)').fill('Salvage in deep space, on headphones.')
    await producer.getByRole('radio', { name: 'CD rate: 44.1 kHz / 16 bit' }).check()
    await producer.getByRole('button', { name: 'Create project' }).click()
    await expect(producer.getByRole('heading', { name: 'Which sounds do you need?' })).toBeVisible()
    project = projectOf(producer)
  })

  await test.step('imports the list: a dry run names the faulty row, which stops no other, and it is fixed first', async () => {
    await producer.keyboard.press('i')
    await producer.getByLabel('Pasted rows').fill(SHEET)
    const faulty = producer.getByRole('row').filter({ hasText: 'found "short"' })
    await expect(faulty).toContainText('Error')
    await expect(faulty.getByRole('cell').first()).toHaveText('3')
    await expect(producer.getByRole('button', { name: 'Import 3 cues' })).toBeEnabled()
    await producer.getByLabel('Pasted rows').fill(SHEET.replace('\tshort\t', '\t0.3\t'))
    await expect(producer.getByText('4 cues to add, 0 to change, 0 the same')).toBeVisible()
    await producer.getByRole('button', { name: 'Import 4 cues' }).click()
    await toast(producer, '4 cues added')
    await expect(producer.getByRole('row').filter({ hasText: 'victory_sting' })).toContainText('To do')
  })

  await test.step('the audio director joins by the link from the outbox and is the approver now', async () => {
    await producer.goto('/studio')
    const invite = card(producer, 'Invite a team member')
    await invite.getByLabel('Email').fill(addressOf('director'))
    await invite.getByRole('checkbox', { name: /Audio lead/ }).check()
    await invite.getByRole('button', { name: 'Invite', exact: true }).click()
    await producer.getByRole('button', { name: new RegExp(`Copy link of .+ to ${addressOf('director')}`) }).click()
    await toast(producer, 'Link copied.')
    await approver.goto(await copied(producer))
    await approver.getByLabel('Your name').fill('Audio director')
    await approver.getByLabel('Password', { exact: true }).fill(PASSWORD)
    await approver.getByRole('button', { name: /^Join Producer/ }).click()
    await expect(approver.getByRole('navigation', { name: 'Areas' })).toBeVisible()

    await producer.goto(`${project}/people`)
    await producer.getByRole('button', { name: /^Make audio lead.*Audio director/ }).click()
    await toast(producer, 'Audio director is an audio lead now.')
    await producer.goto(`${project}/approvers`)
    await producer.getByRole('button', { name: 'Change approver' }).click()
    await expect(producer.getByLabel('New approver').first()).toHaveValue('Audio director')
    await producer.getByLabel('Reason (logged)').fill('Knows the palette best')
    await producer.getByRole('button', { name: 'Make approver' }).click()
    await toast(producer, 'Audio director is the approver now.')
  })

  await test.step('the designer sees the list by the link alone, and makes an account to deliver', async () => {
    await producer.goto(`${project}/people`)
    const invite = producer.getByRole('form', { name: 'Invite a designer' })
    await invite.getByLabel('Email').fill(addressOf('designer'))
    await invite.getByLabel(/^Message/).fill('Start with the shield.')
    await invite.getByRole('button', { name: 'Send invitation' }).click()
    await producer.getByRole('button', { name: new RegExp(`^Copy link.*${addressOf('designer')}`) }).click()
    await toast(producer, 'Link copied.')
    await designer.goto(await copied(producer))
    await expect(designer.getByText('Start with the shield.')).toBeVisible()
    await expect(designer.getByRole('row').filter({ hasText: 'shield_hit' })).toContainText('Must read over laser fire')
    await designer.getByRole('button', { name: 'Start delivering' }).click()
    await designer.getByLabel('Your name').fill('Sound designer')
    await designer.getByLabel('New password', { exact: true }).fill(PASSWORD)
    await designer.getByRole('button', { name: 'Create account and go to your desk' }).click()
    await expect(designer.getByRole('heading', { name: 'Your desk' })).toBeVisible()
    await expect(card(designer, 'To do')).toContainText('laser_fire')
  })

  await test.step('drops good and bad files, sees them on their way and what came of each', async () => {
    const folder = testInfo.outputPath('masters')
    await mkdir(folder, { recursive: true })
    const files = { ...GOOD, 'laser_fire.wav': wav({ peak: 1, pitchHz: 1_400 }), 'ui_confirm.wav': MP3_AS_WAV }
    for (const [name, bytes] of Object.entries(files)) await writeFile(join(folder, name), bytes)
    await brake(designer, 20_000)
    await dropFiles(
      designer,
      Object.keys(files).map((name) => join(folder, name)),
    )
    await expect(line(designer, 'shield_hit_altB.wav')).toContainText('Uploading')
    await expect(line(designer, 'shield_hit_altB.wav').getByRole('img', { name: /\d+ % here/ })).toBeVisible()
    await brake(designer, 0)
    await expect(line(designer, 'ui_confirm.wav')).toContainText('Not uploaded')
    await expect(line(designer, 'ui_confirm.wav')).toContainText('This is an MP3 named .wav.')

    const held = card(designer, 'Check before the upload')
    await expect(held).toContainText('1 file fixable after the upload')
    const loud = held.getByRole('listitem').filter({ hasText: 'Sample peak' })
    await expect(loud).toContainText(/laser_fire\.wav.*Sample peak −?0\.0+ dBFS\. Limit −0\.1 dBFS\./)
    await expectAccessible(designer, 'the desk with a file that a fix puts right')
    await held.getByRole('button', { name: 'Upload laser_fire.wav' }).click()
    await expect(held.getByLabel('New name of final_FINAL_sting2.wav')).toHaveValue('victory_sting.wav')
    await held.getByRole('button', { name: 'Upload anyway: final_FINAL_sting2.wav' }).click()
    await expect(held).toBeHidden()

    const back = card(designer, /Needs your fix/)
    await expect(back.getByRole('heading', { name: 'laser_fire' })).toBeVisible()
    await expect(back.getByRole('list', { name: 'Check results' })).toContainText(/Sample peak −?0\.0+ dBFS/)
    await expect(back.getByRole('list', { name: 'Check results' })).toContainText('−0.1')
    await expect(back.getByRole('slider', { name: /laser_fire/ }).first()).toBeVisible() // and those of the fix, once it is made
    await expect(back.getByRole('link', { name: /^sample-peak/ })).toHaveAttribute('href', '/checks/sample-peak')

    const tray = card(designer, 'Unmatched files')
    await expect(tray).toContainText('final_FINAL_sting2.wav')
    await expect(tray.getByRole('button', { name: /^victory_sting/ })).toBeVisible()
    await designer.keyboard.press('1')
    await toast(designer, 'final_FINAL_sting2.wav is for victory_sting and will be named for it.')
    await expect(tray).toBeHidden()
    await expect(card(designer, /Delivery 1/)).toContainText('6 files checked')
  })

  await test.step('sends a version that is not too loud', async () => {
    await chooseBy('s', designer, 'laser_fire.wav', wav({ peak: 0.8, pitchHz: 1_400 }))
    await expect(card(designer, /Needs your fix/)).toContainText('Nothing to fix.')
    await expect(card(designer, 'In review')).toContainText('4 cues, 6 files')
  })

  await test.step('the approver hears two alternates and picks the second, by keys alone', async () => {
    await openQueue(approver, server.url, project, 4)
    await approver.getByRole('link', { name: /shield_hit/ }).click()
    await expect(approver.getByRole('heading', { level: 1, name: 'shield_hit' })).toBeVisible()
    await expect(approver.getByText('Your call. No revision round yet.')).toBeVisible()
    await approver.keyboard.press('l')
    await approver.keyboard.press('Space')
    await expect(approver.getByRole('button', { name: 'Pause' })).toBeVisible()
    await expect.poll(() => playhead(approver)).toBeGreaterThan(0.05)
    await approver.keyboard.press('2')
    await expect(approver.getByRole('slider', { name: /shield_hit, B/ }).first()).toBeVisible()
    await approver.keyboard.press('Space')
    await listenAndApprove(approver, 'shield_hit B approved.')
  })

  await test.step('asks for a change where the playhead stopped, and sends it', async () => {
    await approver.getByRole('link', { name: /victory_sting/ }).click()
    await expect(approver.getByRole('heading', { level: 1, name: 'victory_sting' })).toBeVisible()
    const play = approver.getByRole('button', { name: 'Play' }) // it plays by itself where it follows a verdict
    if (await play.isVisible()) await approver.keyboard.press('Space')
    await expect.poll(() => playhead(approver)).toBeGreaterThan(0.1)
    await approver.keyboard.press('r')
    await approver.keyboard.type('Third chord higher')
    await expect(approver.getByRole('button', { name: /^At 0\.\d{3} s$/, pressed: true })).toBeVisible()
    await approver.keyboard.press('Enter')
    await toast(approver, /^Change requested: victory_sting/)
  })

  await test.step('the designer reads it and sends the next version', async () => {
    const back = card(designer, /Needs your fix/)
    await expect(async () => {
      await designer.reload() // it leaves after ten seconds, in which it can be undone
      await expect(back.getByRole('heading', { name: 'victory_sting' })).toBeVisible({ timeout: 10_000 })
    }).toPass({ timeout: 300_000 })
    await expect(back.getByRole('list', { name: 'Requested changes' })).toContainText('Third chord higher')
    await expect(back.getByRole('button', { name: /^0\.\d{3} s$/ })).toBeVisible()
    await chooseBy('s', designer, 'sting with third chord.wav', wav({ seconds: 1, pitchHz: 660, channels: 2 }))
    await expect(back).toContainText('Nothing to fix.')
  })

  await test.step('the approver approves what is left', async () => {
    await openQueue(approver, server.url, project, 3)
    for (const [name, done] of [
      ['victory_sting', 'victory_sting version 2 approved.'],
      ['laser_fire', 'laser_fire version 2 approved.'],
      ['door_open', 'The set of 2 for door_open accepted.'],
    ] as const) {
      await approver.getByRole('link', { name: new RegExp(name) }).click()
      await expect(approver.getByRole('heading', { level: 1, name })).toBeVisible()
      await listenAndApprove(approver, done)
    }
    await expect(approver.getByRole('heading', { name: 'Nothing to review' })).toBeVisible()
  })

  let pack = new Map<string, Buffer>()
  await test.step('the producer downloads the pack: the names that the game expects, at its rate and depth', async () => {
    await producer.goto(`${project}/progress`)
    await expect(card(producer, 'Approved pack')).toContainText('4 of 4')
    const downloading = producer.waitForEvent('download')
    await producer.getByRole('link', { name: 'Download game' }).click()
    pack = unzip(await readFile(await (await downloading).path()))
    const sounds = [...pack.keys()].filter((name) => name.endsWith('.wav'))
    expect(sounds.map((path) => path.split('/').at(-1)).toSorted()).toEqual([
      'door_open_01.wav',
      'door_open_02.wav',
      'laser_fire.wav',
      'shield_hit.wav',
      'victory_sting.wav',
    ])
    for (const path of sounds) {
      const bytes = pack.get(path) ?? Buffer.alloc(0)
      const channels = path.endsWith('victory_sting.wav') ? 2 : 1
      const seconds = { shield_hit: 0.8, laser_fire: 0.3, victory_sting: 1 }[/(\w+)\.wav$/.exec(path)?.[1] ?? ''] ?? 0.4
      expect(wavFacts(bytes), path).toEqual({
        rateHz: 44_100,
        bits: 16,
        channels,
        dataBytes: Math.ceil(seconds * 44_100) * channels * 2,
      })
    }
  })

  await test.step('the game’s CI checks the pack by the lines shown, and its report stands on the project page', async () => {
    const builds = card(producer, 'Builds')
    await expect(builds.getByText('soundlist.pyz ci')).toBeVisible()
    await builds.getByRole('button', { name: 'Create token' }).click()
    await builds.getByRole('button', { name: 'Create token' }).click()
    const token = await builds.getByText(/^slt_/).textContent()

    const folder = testInfo.outputPath('game')
    const headers = { Authorization: `Bearer ${token}` }
    for (const [path, bytes] of pack) {
      const place = join(folder, 'assets', path)
      await mkdir(dirname(place), { recursive: true })
      await writeFile(place, bytes)
    }
    for (const [name, path] of [
      ['spec.toml', 'spec.toml'],
      ['sounds.csv', 'sound-list.csv'],
    ] as const) {
      const answer = await fetch(`${server.url}/v1${project}/${path}`, { headers })
      expect(answer.status).toBe(200)
      await writeFile(join(folder, name), await answer.text())
    }
    const check = ['check', '--spec', 'spec.toml', '--list', 'sounds.csv', '--target', 'game', '--format', 'json']
    const { stdout } = await promisify(execFile)(join(ROOT, '.venv/bin/audio-checks'), [...check, 'assets/'], {
      cwd: folder,
    })
    const posted = await fetch(`${server.url}/v1${project}/builds`, {
      method: 'POST',
      headers: { ...headers, 'Content-Type': 'application/json' },
      body: JSON.stringify({ label: '12', commit: 'f00dcafe', target: 'game', report: JSON.parse(stdout) as unknown }),
    })
    expect(posted.status).toBe(201)
    await producer.reload()
    await expect(card(producer, 'Builds')).toContainText(/Passed/)
    await expect(card(producer, 'Builds')).toContainText('5 files checked')
  })
})
