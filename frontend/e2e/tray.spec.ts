import { mkdir, writeFile } from 'node:fs/promises'
import { join } from 'node:path'

import { expect, type Page } from '@playwright/test'

import { ask } from './api'
import { atWork, visit } from './atWork'
import { expectAccessible } from './axe'
import { test } from './fixtures'
import { wav } from './sounds'

const CUES = [
  { name: 'Bell', file_name: 'perc_bell' },
  { name: 'Second bell', file_name: 'perc_bell2' },
  { name: 'Steps on grass', file_name: 'step_grass', variations: 4 },
]
const MESSY = ['PercBell2 FINAL.wav', 'perc-bell_v03.wav', 'Step Grass 3 (1).wav', 'perc bell 2.wav']

let pitchHz = 200
const sound = (): Buffer => wav({ seconds: 0.3, pitchHz: (pitchHz += 37) })
const named = (name: string, buffer = sound()) => ({ name, mimeType: 'audio/wav', buffer })
const toast = (page: Page, text: string) => expect(page.getByRole('status').filter({ hasText: text })).toBeVisible()

test('messy names find their cues, a wrong folder goes away, and every act comes back @slow', async ({
  server: { url },
  browser,
}, testInfo) => {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(producer, designer, url, [{ name: 'Airlock' }])
  const tray = designer.getByRole('region', { name: 'Unmatched files' })
  const headline = designer.getByText(/no cue yet/).first()
  const folder = testInfo.outputPath('old game')

  await test.step('files that the list does not know wait, by folder', async () => {
    await mkdir(folder, { recursive: true })
    for (const name of ['a.wav', 'b.wav']) await writeFile(join(folder, name), sound())
    await designer.getByLabel('Files to deliver').setInputFiles(MESSY.map((name) => named(name)))
    await designer.getByLabel('Folder to deliver').setInputFiles(folder)
    await expect(tray.getByText('6 files without a cue')).toBeVisible()
    await expect(tray.getByRole('group', { name: 'Folder old game' })).toContainText('2 files')
    await expect(tray.getByRole('button', { name: /^Accept/ })).toBeHidden()
  })

  await test.step('sure ones are accepted in one act, and come back', async () => {
    await ask(producer.context(), `${url}/v1/projects/${project}/cues`, 'POST', { cues: CUES })
    await designer.reload()
    const accept = tray.getByRole('button', { name: 'Accept 3 sure matches' })
    await expect(accept).toBeVisible()
    await expectAccessible(designer)
    await accept.click()
    await toast(designer, '3 files matched.')
    await expect(tray.getByText('3 files without a cue')).toBeVisible()
    await expect(headline).toContainText(/three files have no cue yet/i)
    await designer.getByRole('button', { name: /Undo/ }).click()
    await expect(tray.getByText('6 files without a cue')).toBeVisible()
    await accept.click()
    await expect(tray.getByText('3 files without a cue')).toBeVisible()
  })

  await test.step('a wrong folder goes away in one act', async () => {
    await tray.getByRole('group', { name: 'Folder old game' }).getByRole('button', { name: 'Discard folder' }).click()
    await toast(designer, '2 files discarded; their masters are kept.')
    await expect(tray.getByText('1 file without a cue')).toBeVisible()
  })

  await test.step('of two near cues a person chooses', async () => {
    await expect(tray.getByRole('button', { name: /^Bell/ })).toBeVisible()
    await tray.getByRole('button', { name: /^Second bell/ }).click()
    await toast(designer, 'perc bell 2.wav is for Second bell and will be named for it.')
    await expect(tray).toBeHidden()
  })

  await test.step('each file is where its name said', async () => {
    const { items } = await ask<{ items: { file_name: string; cue: { name: string }; variation: number }[] }>(
      designer.context(),
      `${url}/v1/projects/${project}/takes?unmatched=false`,
    )
    expect(Object.fromEntries(items.map((take) => [take.file_name, `${take.cue.name} ${take.variation}`]))).toEqual({
      'PercBell2 FINAL.wav': 'Second bell 1',
      'perc-bell_v03.wav': 'Bell 1',
      'Step Grass 3 (1).wav': 'Steps on grass 3',
      'perc bell 2.wav': 'Second bell 1',
    })
  })

  await test.step('the same bytes under another name are already here', async () => {
    const twice = sound()
    await designer.getByLabel('Files to deliver').setInputFiles([named('something.wav', twice)])
    await expect(tray.getByText('1 file without a cue')).toBeVisible()
    await designer.reload()
    await designer.getByLabel('Files to deliver').setInputFiles([named('something else.wav', twice)])
    await expect(designer.getByText('Already here').first()).toBeVisible()
    await expect(tray.getByText('1 file without a cue')).toBeVisible()
  })
})
