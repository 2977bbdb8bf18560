import { mkdir, writeFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'

import { expect, type Page } from '@playwright/test'

import { ask } from './api'
import { visit } from './atWork'
import { test } from './fixtures'
import { Hand } from './hand'
import { heardAll } from './listening'
import { addressOf, PASSWORD } from './party'
import { wav } from './sounds'

const CUES = 60

/** Figures of the walk that a change may not exceed. */
const MOST = {
  producer: { clicks: 12, fields: 12, requests: 200 },
  designer: { clicks: 5, fields: 4, requests: 100 },
  delivery: { clicks: 1, fields: 1 }, // of 57 files, once the folder is chosen: one has a name that says no cue
}

const nameOf = (index: number): string =>
  `${['laser', 'door', 'step', 'bell'][index % 4]}_${'abcdefghijklmno'[index >> 2]}`
const IN_A_MONTH = new Date(Date.now() + 30 * 24 * 3_600_000).toISOString().slice(0, 10)
const SHEET = [
  'Name\tKind\tPrio\tDur\tDue date',
  ...Array.from({ length: CUES }, (_, index) => `${nameOf(index)}\tui\thigh\t0.3\t${IN_A_MONTH}`),
].join('\n')

/** What designers call their files: each cue by one of these habits. */
const HABITS: ((kind: string, letter: string) => string)[] = [
  (kind, letter) => `${kind}_${letter}_FINAL.wav`.toUpperCase().replace('.WAV', '.wav'),
  (kind, letter) => `${capital(kind)} ${capital(letter)} v03.wav`,
  (kind, letter) => `${kind}-${letter} (1).wav`,
  (kind, letter) => `${capital(kind)}${capital(letter)}_final_FINAL2.wav`,
  (kind, letter) => `old mixes/${kind} ${letter} copy.wav`,
  (kind, letter) => `UI/${kind}.${letter}.wav`,
  (kind, letter) => `2026-11-23_${kind}_${letter}.wav`,
  (kind, letter) => `df_${kind}_${letter}_48k.wav`,
]
const capital = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1)
const MESSY: Record<string, string> = Object.fromEntries(
  Array.from({ length: CUES }, (_, index) => nameOf(index))
    .filter((cue) => cue !== 'laser_c')
    .slice(0, 55)
    .map((cue, index) => {
      const [kind = '', letter = ''] = cue.split('_')
      return [HABITS[index % HABITS.length]?.(kind, letter) ?? '', cue]
    }),
)
const WRONG: Record<string, Buffer> = {
  'laser_c.wav': Buffer.concat([Buffer.from('ID3\x04\x00\x00\x00\x00\x00\x00', 'latin1'), Buffer.alloc(2_000, 0x55)]),
  'notes.txt': Buffer.from('remember the doors'),
}

const badge = (page: Page, tab: string) =>
  page.getByRole('navigation', { name: 'Areas' }).getByRole('link', { name: new RegExp(`^${tab}`) })
const next = (page: Page, head: string | RegExp) => page.getByRole('region', { name: head })

async function linkFor(page: Page, url: string, recipient: string): Promise<string> {
  const { studios } = await ask<{ studios: { id: string }[] }>(page.context(), `${url}/v1/me`)
  let link = ''
  await expect(async () => {
    const outbox = `${url}/v1/studios/${studios[0]?.id}/outbox`
    const { mails } = await ask<{ mails: { recipient: string; link: string | null }[] }>(page.context(), outbox)
    link = mails.find((mail) => mail.recipient === recipient)?.link ?? ''
    expect(link).not.toBe('')
  }).toPass({ timeout: 300_000 })
  return link
}

test('from sign-up to a signed contract, a messy delivery and the verdicts, counted @slow', async ({
  server: { url },
  browser,
}, testInfo) => {
  const producer = new Hand(await visit(browser))
  const designer = new Hand(await visit(browser))
  const { page } = producer

  await test.step('a producer signs up and lists 60 cues', async () => {
    await page.goto(`${url}/sign-up`)
    await producer.type(page.getByLabel('Your name'), 'Producer')
    await producer.type(page.getByLabel('Email'), addressOf('producer'))
    await producer.type(page.getByLabel('Password', { exact: true }), PASSWORD)
    await producer.press('Enter')
    await producer.type(page.getByLabel('Game title'), 'Deep Field')
    await producer.press('Enter')
    await expect(page.getByRole('heading', { name: 'Which sounds do you need?' })).toBeVisible()
    await producer.click(badge(page, 'Today'))
    await producer.click(next(page, 'Add the sounds that the game needs').getByRole('link').first())
    await producer.type(page.getByLabel('Pasted rows'), SHEET)
    await producer.click(page.getByRole('button', { name: `Import ${CUES} cues` }))
    await expect(page.getByText(`${CUES} cues added`)).toBeVisible()
  })

  await test.step('Today says to invite a designer, and then whom it waits for', async () => {
    await producer.click(badge(page, 'Today'))
    await producer.click(next(page, 'Invite a sound designer').getByRole('link').first())
    const invite = page.getByRole('form', { name: 'Invite a designer' })
    await producer.type(invite.getByLabel('Email'), addressOf('designer'))
    await producer.press('Enter')
    await expect(page.getByText(`${addressOf('designer')} is invited.`)).toBeVisible()
    const link = await linkFor(page, url, addressOf('designer'))
    await designer.page.goto(link)
    await designer.click(designer.page.getByRole('button', { name: 'Start delivering' }))
    await designer.type(designer.page.getByLabel('Your name'), 'Ada Tones')
    await designer.type(designer.page.getByLabel('New password', { exact: true }), PASSWORD)
    await designer.press('Enter')
    await expect(designer.page.getByRole('heading', { name: 'Your desk' })).toBeVisible()
  })

  await test.step('a contract over all cues is drafted, planned, sent and signed', async () => {
    await producer.click(badge(page, 'Contract'))
    await producer.click(page.getByRole('button', { name: 'Create draft' }))
    await producer.type(page.getByLabel('Price, deposit included'), '6000')
    await producer.press('Enter')
    await expect(page.getByText('Every question is answered.')).toBeVisible()
    await producer.click(page.getByRole('button', { name: 'Send to Ada Tones' }))
    for (const [hand, name] of [
      [designer, 'Ada Tones'],
      [producer, 'Pat Producer'],
    ] as const) {
      await hand.page.goto(url)
      await hand.click(
        next(hand.page, /^Sign /)
          .getByRole('link')
          .first(),
      )
      const form = hand.page.getByRole('form', { name: 'Accept' })
      await hand.type(form.getByLabel('Your full name'), name)
      await hand.press('Enter')
      await expect(form).toBeHidden()
    }
  })
  producer.report('producer, from sign-up to a signed contract')
  designer.report('designer, from the invitation to a signed contract')
  for (const [hand, most] of [
    [producer, MOST.producer],
    [designer, MOST.designer],
  ] as const) {
    expect(hand.clicks).toBeLessThanOrEqual(most.clicks)
    expect(hand.fields).toBeLessThanOrEqual(most.fields)
    expect(hand.requests).toBeLessThanOrEqual(most.requests)
  }

  const desk = designer.page
  const tray = desk.getByRole('region', { name: 'Unmatched files' })
  await test.step('messy names find their cues; headline, tray and badge count the same', async () => {
    await desk.goto(`${url}/desk`)
    const folder = testInfo.outputPath('delivery')
    let pitchHz = 300
    for (const name of [...Object.keys(MESSY), 'something else.wav']) {
      await mkdir(dirname(join(folder, name)), { recursive: true })
      await writeFile(join(folder, name), wav({ seconds: 0.3, pitchHz: (pitchHz += 41) }))
    }
    for (const [name, bytes] of Object.entries(WRONG)) await writeFile(join(folder, name), bytes)
    await desk.getByLabel('Folder to deliver').setInputFiles(folder)
    await expect(desk.getByText('This is an MP3 named .wav.')).toBeVisible()
    await expect(tray.getByText('1 file without a cue')).toBeVisible()
    await expect(desk.getByText(/^One file has no cue yet/)).toBeVisible()
    await expect(badge(desk, 'Deliveries')).toHaveText(/^Deliveries\s*1/)
    const projectId = /\/projects\/([0-9a-f-]{36})/.exec(page.url())?.[1] ?? ''
    const wanted = Object.entries(MESSY).map(([name, cue]) => [name.split('/').at(-1), cue])
    await expect(async () => {
      const { items } = await ask<{ items: { file_name: string; cue: { name: string } | null }[] }>(
        desk.context(),
        `${url}/v1/projects/${projectId}/takes?unmatched=false&limit=100`,
      )
      const found = items.map(({ file_name: name, cue }) => [name.split('/').at(-1), cue?.name])
      expect(Object.fromEntries(found)).toEqual(Object.fromEntries(wanted))
    }).toPass({ timeout: 300_000 })
    await expect(tray.getByText('1 file without a cue')).toBeVisible()
    await expect(badge(desk, 'Deliveries')).toHaveText(/^Deliveries\s*1/)
  })

  await test.step('Ctrl K finds a cue, a file, a person and a contract from any page', async () => {
    await page.goto(`${url}/studio`)
    await expect(page.getByRole('heading', { level: 1, name: /^Producer/ })).toBeVisible()
    for (const [typed, section, title] of [
      ['bell_c', 'Sounds', 'bell_c'],
      ['something else', 'Files', 'something else.wav'],
      ['ada tones', 'People and contracts', 'Ada Tones'],
    ] as const) {
      await producer.press('Control+k')
      await page.getByRole('combobox', { name: 'Search or run a command' }).fill(typed)
      const results = page.getByRole('listbox', { name: 'Results' })
      await expect(results.getByRole('group', { name: section })).toContainText(title)
      await producer.press('Escape')
    }
    await producer.press('Control+k')
    await page.getByRole('combobox', { name: 'Search or run a command' }).fill('bell_c')
    await expect(page.getByRole('option').first()).toContainText('bell_c')
    await producer.press('Enter')
    await expect(page.getByRole('heading', { level: 1, name: 'bell_c' })).toBeVisible()
  })

  await test.step('every sound that was heard is judged by one key, as fast as they come', async () => {
    const many = Object.keys(MESSY).length
    const projectId = /\/projects\/([0-9a-f-]{36})/.exec(page.url())?.[1] ?? ''
    await expect(async () => {
      await page.goto(`${url}/projects/${projectId}/review`)
      await expect(page.getByText(`${many} waiting`).first()).toBeAttached({ timeout: 10_000 })
    }).toPass({ timeout: 120_000 })
    await heardAll(page.context(), url, projectId)
    await page.reload()
    const judged = new Set<string>()
    for (let left = many; left > 0; left -= 1) {
      const head = page.getByRole('heading', { level: 1, name: /_[a-o]$/ })
      await expect.poll(async () => judged.has(await head.innerText())).toBe(false)
      judged.add(await head.innerText())
      await expect(page.getByRole('button', { name: /^Approve version/ })).toBeVisible()
      await producer.press('a')
    }
    await expect(page.getByRole('heading', { name: 'Nothing to review' })).toBeVisible()
    expect(judged.size).toBe(many)
  })

  await test.step('the one file whose name says no cue is put to its cue', async () => {
    const [clicks, fields] = [designer.clicks, designer.fields]
    await desk.goto(`${url}/desk`)
    await designer.click(tray.getByRole('button', { name: /^Other cue/ }))
    await designer.type(desk.getByRole('combobox', { name: /^Cue for .*something else\.wav$/ }), 'bell_o')
    await expect(desk.getByRole('option', { name: /bell_o$/ })).toBeVisible()
    await designer.press('Enter')
    await expect(tray).toBeHidden()
    expect(designer.clicks - clicks).toBeLessThanOrEqual(MOST.delivery.clicks)
    expect(designer.fields - fields).toBeLessThanOrEqual(MOST.delivery.fields)
  })
})
