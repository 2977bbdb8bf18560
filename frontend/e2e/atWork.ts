import { type Browser, expect, type Page } from '@playwright/test'

import { ask } from './api'
import { addressOf, PASSWORD } from './party'

/** A browser of somebody's own. */
export const visit = async (browser: Browser): Promise<Page> =>
  (await browser.newContext({ viewport: { width: 1440, height: 900 } })).newPage()

/** A producer whose project asks for some sounds, and its designer at the desk; returns the project's id. */
export async function atWork(producer: Page, designer: Page, url: string, cues: readonly object[]): Promise<string> {
  await producer.goto(`${url}/sign-up`)
  await producer.getByLabel('Your name').fill('Producer')
  await producer.getByLabel('Email').fill(addressOf('producer'))
  await producer.getByLabel('Password', { exact: true }).fill(PASSWORD)
  await producer.keyboard.press('Enter')
  await expect(producer.getByRole('heading', { name: 'What is the game called?' })).toBeVisible()

  const asProducer = producer.context()
  const { studios } = await ask<{ studios: { id: string }[] }>(asProducer, `${url}/v1/me`)
  const studioId = studios[0]?.id ?? ''
  const { id } = await ask<{ id: string }>(asProducer, `${url}/v1/projects`, 'POST', {
    studio_id: studioId,
    name: 'Deep Field',
    cue_prefix: 'DF',
    preset: '44k1',
  })
  await ask(asProducer, `${url}/v1/projects/${id}/cues`, 'POST', { cues })
  await ask(asProducer, `${url}/v1/projects/${id}/invitations`, 'POST', { email: addressOf('designer') })
  let link = ''
  await expect(async () => {
    const { mails } = await ask<{ mails: { recipient: string; link: string | null }[] }>(
      asProducer,
      `${url}/v1/studios/${studioId}/outbox`,
    )
    link = mails.find(({ recipient }) => recipient === addressOf('designer'))?.link ?? ''
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

/** Deliver sounds as the designer's page does, and wait until all of them are to be reviewed. */
export async function deliver(
  designer: Page,
  producer: Page,
  url: string,
  project: string,
  files: Record<string, Buffer>,
): Promise<void> {
  const from = designer.context()
  const { id } = await ask<{ id: string }>(from, `${url}/v1/projects/${project}/deliveries`, 'POST', { note: '' })
  const csrf = (await from.cookies(url)).find(({ name }) => name === 'soundlist_csrf')?.value ?? ''
  for (const [name, data] of Object.entries(files)) {
    const answer = await from.request.post(`${url}/v1/deliveries/${id}/files`, {
      params: { file_name: name },
      data,
      headers: { 'X-CSRF-Token': csrf, 'Content-Type': 'application/octet-stream' },
    })
    expect(answer.ok(), await answer.text()).toBe(true)
  }
  const counts = `${url}/v1/projects/${project}/sound-list/counts`
  await expect
    .poll(async () => (await ask<{ files_to_review: number }>(producer.context(), counts)).files_to_review, {
      timeout: 100_000,
    })
    .toBe(Object.keys(files).length)
}
