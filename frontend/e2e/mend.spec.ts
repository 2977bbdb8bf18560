import { type Browser, expect, type Page } from '@playwright/test'

import { ask, bytesAt } from './api'
import { expectAccessible } from './axe'
import { test } from './fixtures'
import { wav } from './sounds'

const PASSWORD = 'quiet reactor hum'
const DESIGNER = 'designer@tones.example'
/** Its highest sample stands at full scale: the check returns it, and a mend is enough. */
const LOUD = wav({ seconds: 0.8, peak: 1, pitchHz: 620 })

interface Take {
  id: string
  number: number
  state: string
  mend_of_id: string | null
}

const visit = async (browser: Browser): Promise<Page> =>
  (await browser.newContext({ viewport: { width: 1440, height: 900 } })).newPage()

/** A producer whose project asks for one sound, and its designer at the desk. */
async function atWork(producer: Page, designer: Page, url: string): Promise<string> {
  await producer.goto(`${url}/sign-up`)
  await producer.getByLabel('Name of the studio').fill('Lantern Games')
  await producer.getByLabel('Your name').fill('Producer')
  await producer.getByLabel('Mail address').fill('producer@lantern.example')
  await producer.getByLabel('Password', { exact: true }).fill(PASSWORD)
  await producer.keyboard.press('Enter')
  await expect(producer.getByRole('heading', { name: 'New project' })).toBeVisible()

  const asProducer = producer.context()
  const { studios } = await ask<{ studios: { id: string }[] }>(asProducer, `${url}/v1/me`)
  const studioId = studios[0]?.id ?? ''
  const { id } = await ask<{ id: string }>(asProducer, `${url}/v1/projects`, 'POST', {
    studio_id: studioId,
    name: 'Deep Field',
    cue_prefix: 'DF',
    preset: '44k1',
  })
  const cues = [{ name: 'airlock_cycle', category: 'foley', duration_s: 0.8 }]
  await ask(asProducer, `${url}/v1/projects/${id}/cues`, 'POST', { cues })
  await ask(asProducer, `${url}/v1/projects/${id}/invitations`, 'POST', { email: DESIGNER })
  let link = ''
  await expect(async () => {
    const { mails } = await ask<{ mails: { recipient: string; link: string | null }[] }>(
      asProducer,
      `${url}/v1/studios/${studioId}/outbox`,
    )
    link = mails.find(({ recipient }) => recipient === DESIGNER)?.link ?? ''
    expect(link).not.toBe('')
  }).toPass()

  await designer.goto(link)
  await designer.getByRole('button', { name: 'Start delivering' }).click()
  await designer.getByLabel('Your name').fill('Sound designer')
  await designer.getByLabel('New password', { exact: true }).fill(PASSWORD)
  await designer.keyboard.press('Enter')
  await expect(designer.getByRole('heading', { name: 'Your desk' })).toBeVisible()
  return id
}

test('what came back too loud is mended in one press, and the approver gets it without a round', async ({
  server: { url },
  browser,
}) => {
  test.setTimeout(180_000)
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const projectId = await atWork(producer, designer, url)
  const takes = async () =>
    (await ask<{ items: Take[] }>(designer.context(), `${url}/v1/projects/${projectId}/takes`)).items

  await test.step('the desk shows before and mended, to see and to hear', async () => {
    await designer
      .getByLabel('Files to deliver')
      .setInputFiles({ name: 'airlock_cycle.wav', mimeType: 'audio/wav', buffer: LOUD })
    const back = designer.getByRole('article', { name: 'airlock_cycle' })
    await expect(back.getByText('Returned')).toBeVisible({ timeout: 30_000 })
    await expect(back.getByRole('slider', { name: 'Position in airlock_cycle, mended', exact: true })).toBeVisible({
      timeout: 30_000,
    })
    await expect(back.getByText('level lowered by 1.00 dB', { exact: false })).toBeVisible()
    await expect(back.getByText('Sample peak', { exact: true })).toBeVisible()
    await expectAccessible(designer, 'the desk with a mend')
    await designer.keyboard.press('b')
    await expect(back.getByRole('button', { name: 'Hear before' })).toBeVisible()
  })

  await test.step('one press makes it version 2; version 1 and its master stay', async () => {
    await designer.keyboard.press('t')
    await expect(designer.getByText('airlock_cycle version 2 is the mend; it is being checked.')).toBeVisible()
    await expect(designer.getByText('Nothing came back.')).toBeVisible()
    await expect.poll(async () => (await takes()).map(({ state }) => state)).toEqual(['conforming', 'returned'])
    const [second, first] = await takes()
    expect(second).toMatchObject({ number: 2, mend_of_id: first?.id })
    expect(await bytesAt(designer.request, `${url}/v1/takes/${first?.id}/master`)).toEqual(LOUD)
  })

  await test.step('the approver sees who agreed, and no round was counted', async () => {
    const [second] = await takes()
    await producer.goto(`${url}/takes/${second?.id}`)
    await expect(producer.getByRole('heading', { level: 1, name: 'airlock_cycle' })).toBeVisible()
    await expect(producer.getByText(/, with the consent of Sound designer: level lowered by 1\.00 dB\.$/)).toBeVisible()
    await expect(producer.getByText('Conforming', { exact: true }).first()).toBeVisible()
    await expectAccessible(producer, 'the page of a mended version')
    await producer.getByRole('link', { name: 'version 1', exact: true }).click()
    await expect(producer.getByText('is its mend, with the consent of Sound designer', { exact: false })).toBeVisible()
    await expect(producer.getByRole('button', { name: /^Use the mend/ })).toHaveCount(0)
    await expect
      .poll(async () => {
        const queue = `${url}/v1/review-queue?project_id=${projectId}`
        const { items } = await ask<{ items: { rounds_so_far: number }[] }>(producer.context(), queue)
        return items.map(({ rounds_so_far: rounds }) => rounds)
      })
      .toEqual([0])
  })
})
