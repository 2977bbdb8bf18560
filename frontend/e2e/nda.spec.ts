import { type Browser, expect } from '@playwright/test'

import { ask } from './api'
import { atWork, visit } from './atWork'
import { test } from './fixtures'
import type { SharedServer } from './server'

const JOURNEY = 'a reference is opened only after the NDA, and the log says who opened which version'

test(`${JOURNEY} @slow`, ({ server, browser }) => journey(server, browser))

test(`${JOURNEY}, on PostgreSQL @slow`, ({ onPostgres, browser }) => journey(onPostgres, browser))

async function journey({ url }: SharedServer, browser: Browser): Promise<void> {
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(producer, designer, url, [{ name: 'Hull door open', category: 'ship' }])
  const board = `${url}/projects/${project}/references`
  const asProducer = producer.context()
  let version = ''

  await test.step('a reference is on the board of a project that asks for an NDA', async () => {
    await producer.goto(board)
    const story = { name: 'ending.txt', mimeType: 'text/plain', buffer: Buffer.from('The hull door opens last.') }
    await producer.getByLabel('Files to add').setInputFiles(story)
    await expect(async () => {
      const added = `${url}/v1/projects/${project}/references`
      const { items } = await ask<{ items: { version: { id: string } }[] }>(asProducer, added)
      version = items[0]?.version.id ?? ''
      expect(version).not.toBe('')
    }).toPass()
    await ask(asProducer, `${url}/v1/projects/${project}`, 'PATCH', { nda_needed: true })
  })

  const statusOf = async (method: 'get' | 'post', part: string) => {
    const cookies = await designer.context().cookies(url)
    const token = cookies.find(({ name }) => name === 'soundlist_csrf')?.value ?? ''
    const headers = { 'X-CSRF-Token': token }
    return (await designer.request[method](`${url}/v1/reference-versions/${version}/${part}`, { headers })).status()
  }

  await test.step('the designer is asked for the NDA in its place, and gets nothing by its address either', async () => {
    await designer.goto(board)
    await expect(designer.getByRole('heading', { name: 'Waiting for the studio’s NDA' })).toBeVisible()
    await expect(designer.getByText('ending.txt')).toBeHidden()
    expect([await statusOf('post', 'openings'), await statusOf('get', 'file')]).toEqual([403, 403])
  })

  await test.step('both sign it', async () => {
    const { engagements } = await ask<{ engagements: { id: string }[] }>(asProducer, `${url}/v1/projects/${project}`)
    const begun = { engagement_id: engagements[0]?.id, kind: 'nda', title: 'NDA' }
    const { id: contract } = await ask<{ id: string }>(
      asProducer,
      `${url}/v1/projects/${project}/contracts`,
      'POST',
      begun,
    )
    await ask(asProducer, `${url}/v1/contracts/${contract}/send`, 'POST', {})
    await designer.reload()
    await expect(designer.getByRole('heading', { name: 'Read and sign the NDA to see this project' })).toBeVisible()
    await designer.getByRole('button', { name: 'Read the NDA' }).click()
    await producer.goto(`${url}/projects/${project}/contracts/${contract}`)
    for (const page of [designer, producer]) {
      const form = page.getByRole('form', { name: 'Accept' })
      await form.getByLabel('Your full name').fill('Full Name')
      await form.getByRole('button', { name: /^Sign version/ }).click()
      await expect(form).toBeHidden()
    }
  })

  await test.step('now the reference opens', async () => {
    await designer.goto(board)
    await designer.getByRole('button', { name: /^Read ending/ }).click()
    await expect(designer.getByRole('dialog').getByText('The hull door opens last.')).toBeVisible()
  })

  await test.step('the log says who opened which version', async () => {
    await producer.goto(board)
    await producer.getByRole('button', { name: 'Edit ending.txt' }).click()
    const openings = producer.getByRole('dialog').getByRole('region', { name: 'Opened by' })
    await expect(openings.getByText('Sound designer, version 1')).toBeVisible()
    await producer.getByLabel('File of the new version').setInputFiles({
      name: 'ending_2.txt',
      mimeType: 'text/plain',
      buffer: Buffer.from('The hull door never opens.'),
    })
    // The line of an upload names the file before the board does.
    await expect(producer.getByRole('button', { name: 'Edit ending_2.txt' })).toBeVisible()
    await designer.reload()
    await designer.getByRole('button', { name: /^Read ending_2/ }).click()
    await expect(designer.getByRole('dialog').getByText('The hull door never opens.')).toBeVisible()
    await producer.reload()
    await producer.getByRole('button', { name: 'Edit ending_2.txt' }).click()
    await expect(openings.getByText('Sound designer, version 2')).toBeVisible()
    await expect(openings.getByText('Sound designer, version 1')).toBeVisible()
  })
}
