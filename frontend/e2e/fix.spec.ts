import { expect } from '@playwright/test'

import { ask, bytesAt } from './api'
import { atWork, visit } from './atWork'
import { expectAccessible } from './axe'
import { test } from './fixtures'
import { wav } from './sounds'

/** Its highest sample stands at full scale: the check returns it, and a fix is enough. */
const LOUD = wav({ seconds: 0.8, peak: 1, pitchHz: 620 })

interface Take {
  id: string
  number: number
  state: string
  fix_of_id: string | null
}

test('what was returned as too loud is fixed in one press, and the approver gets it without a round @slow', async ({
  server: { url },
  browser,
}) => {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const projectId = await atWork(producer, designer, url, [
    { name: 'airlock_cycle', category: 'foley', duration_s: 0.8 },
  ])
  const takes = async () =>
    (await ask<{ items: Take[] }>(designer.context(), `${url}/v1/projects/${projectId}/takes`)).items

  await test.step('the desk shows before and fixed, to see and to hear', async () => {
    await designer
      .getByLabel('Files to deliver')
      .setInputFiles({ name: 'airlock_cycle.wav', mimeType: 'audio/wav', buffer: LOUD })
    await designer.getByRole('button', { name: 'Upload airlock_cycle.wav' }).click()
    const back = designer.getByRole('article', { name: 'airlock_cycle' })
    await expect(back.getByText('Returned')).toBeVisible()
    await expect(back.getByRole('slider', { name: 'Position in airlock_cycle, fixed', exact: true })).toBeVisible()
    await expect(back.getByText('level lowered by 1.00 dB', { exact: false })).toBeVisible()
    await expect(back.getByText('Sample peak', { exact: true })).toBeVisible()
    await expectAccessible(designer, 'the desk with a fix')
    await designer.keyboard.press('b')
    await expect(back.getByRole('button', { name: 'Play original' })).toBeVisible()
  })

  await test.step('one press makes it version 2; version 1 and its master stay', async () => {
    await designer.keyboard.press('t')
    await expect(designer.getByText('airlock_cycle version 2 is the fixed copy. It is being checked.')).toBeVisible()
    await expect(designer.getByText('Nothing to fix.')).toBeVisible()
    await expect.poll(async () => (await takes()).map(({ state }) => state)).toEqual(['conforming', 'returned'])
    const [second, first] = await takes()
    expect(second).toMatchObject({ number: 2, fix_of_id: first?.id })
    expect(await bytesAt(designer.request, `${url}/v1/takes/${first?.id}/master`)).toEqual(LOUD)
  })

  await test.step('the approver sees who agreed, and no round was counted', async () => {
    const [second] = await takes()
    await producer.goto(`${url}/takes/${second?.id}`)
    await expect(producer.getByRole('heading', { level: 1, name: 'airlock_cycle' })).toBeVisible()
    await expect(producer.getByText(/, with the consent of Sound designer: level lowered by 1\.00 dB\.$/)).toBeVisible()
    await expect(producer.getByText('Conforming', { exact: true }).first()).toBeVisible()
    await expectAccessible(producer, 'the page of a fixed version')
    await producer.getByRole('link', { name: 'version 1', exact: true }).click()
    await expect(producer.getByText('is its fix, with the consent of Sound designer', { exact: false })).toBeVisible()
    await expect(producer.getByRole('button', { name: /^Use auto-fix/ })).toHaveCount(0)
    await expect
      .poll(async () => {
        const queue = `${url}/v1/review-queue?project_id=${projectId}`
        const { items } = await ask<{ items: { rounds_so_far: number }[] }>(producer.context(), queue)
        return items.map(({ rounds_so_far: rounds }) => rounds)
      })
      .toEqual([0])
  })
})
