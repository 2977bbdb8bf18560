import { type Browser, expect } from '@playwright/test'

import { ask } from './api'
import { atWork, visit } from './atWork'
import { test } from './fixtures'
import { addressOf } from './party'
import { wav } from './sounds'

const SCRIPT = [
  'Line ID\tCharacter\tScene\tEnglish\tGerman',
  'captain_010\tCaptain\tBridge\tHold the line.\tHaltet die Stellung.',
  'mate_010\tMate\tBridge\tAye.\tJawohl.',
].join('\n')

async function records(browser: Browser, url: string): Promise<void> {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(producer, designer, url, [{ name: 'Hull door open' }])
  const lines = `${url}/projects/${project}/voice-lines`

  await test.step('a script is pasted, shown, and imported', async () => {
    await producer.goto(`${lines}/import`)
    await producer.getByLabel('Pasted rows').fill(SCRIPT)
    const put = producer.getByRole('button', { name: /^Import 2 lines/ })
    await expect(put).toBeEnabled()
    await put.click()
    const bridge = producer.getByRole('region', { name: 'Bridge' })
    await expect(bridge.getByRole('button', { name: 'Hold the line.' })).toBeVisible()
  })

  await test.step('the designer delivers a line, by its name', async () => {
    const { cues } = await ask<{ cues: { name: string; stems: string[] }[] }>(
      designer.context(),
      `${url}/v1/projects/${project}/sound-list`,
    )
    const stems = cues.flatMap((cue) => cue.stems).filter((stem) => stem.includes('captain_010'))
    expect(stems).toHaveLength(2) // one for each language
    const name = stems.find((stem) => !stem.startsWith('de')) ?? ''
    await designer.getByLabel('Files to deliver').setInputFiles({
      name: `${name}.wav`,
      mimeType: 'audio/wav',
      buffer: wav({ rateHz: 44_100, bits: 16, seconds: 0.8, peak: 0.3 }),
    })
    await producer.goto(lines)
    await expect(async () => {
      await producer.reload()
      await expect(producer.getByRole('button', { name: /^No take 1/ })).toBeVisible({ timeout: 10_000 })
    }).toPass({ timeout: 300_000 })
  })

  await test.step('a changed text makes its take stale, until it is said to fit', async () => {
    await producer.getByRole('button', { name: 'Hold the line.' }).click()
    const dialog = producer.getByRole('dialog', { name: /captain_010/ })
    await dialog.getByRole('textbox', { name: 'Text' }).fill('Hold the line, all of you.')
    await dialog.getByRole('button', { name: 'Save' }).click()
    await expect(producer.getByText('Line saved.')).toBeVisible()
    await expect(producer.getByRole('button', { name: /^Text changed 1/ })).toBeVisible()
    await producer.getByRole('button', { name: 'Hold the line, all of you.' }).click()
    await dialog.getByRole('checkbox', { name: 'Takes that exist still fit this text' }).check()
    await dialog.getByRole('button', { name: 'Save' }).click()
    await expect(producer.getByRole('button', { name: /^Text changed/ })).toHaveCount(0)
  })
}

async function asks(browser: Browser, url: string): Promise<void> {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(producer, designer, url, [{ name: 'Hull door open', category: 'door' }])

  await test.step('a designer is put on file', async () => {
    await producer.goto(`${url}/roster`)
    await producer.getByRole('textbox', { name: 'Name' }).fill('Ada Tones')
    await producer.getByRole('textbox', { name: 'Email' }).fill(addressOf('ada'))
    await producer.getByRole('button', { name: 'Add designer' }).click()
    await expect(producer).toHaveURL(/\/roster\/[0-9a-f-]{36}$/)
  })

  await test.step('a posting asks for a bid from the roster, by mail', async () => {
    await producer.goto(`${url}/projects/${project}/postings`)
    await producer.getByLabel('Title').fill('Doors')
    await producer.keyboard.press('Enter')
    await producer.getByLabel('Choose Ada Tones').check()
    await producer.getByRole('button', { name: 'Ask 1 designer for bids' }).click()
    await expect(producer.getByText('asked when it opens')).toBeVisible()
    await producer.getByRole('button', { name: 'Open for bids' }).click()
    await expect(producer.getByText(/^Open\. 0 bids/)).toBeVisible()
    const { studios } = await ask<{ studios: { id: string }[] }>(producer.context(), `${url}/v1/me`)
    await expect(async () => {
      const { mails } = await ask<{ mails: { recipient: string; subject: string }[] }>(
        producer.context(),
        `${url}/v1/studios/${studios[0]?.id}/outbox`,
      )
      expect(mails.filter(({ recipient }) => recipient === addressOf('ada')).map(({ subject }) => subject)).toEqual([
        expect.stringMatching(/asks you for a bid/),
      ])
    }).toPass()
  })
}

test('a script is imported, delivered and changed @slow', async ({ server, browser }) => {
  await records(browser, server.url)
})

test('a designer on file is asked for a bid @slow', async ({ server, browser }) => {
  await asks(browser, server.url)
})
