import { expect, type Page } from '@playwright/test'

import { ask } from './api'
import { test } from './fixtures'
import { Line } from './line'
import { addressOf, PASSWORD } from './party'

const SOON_MS = 2_000 // a second, and the browser's own time on a busy machine

async function openProject(page: Page, url: string): Promise<string> {
  await page.goto(`${url}/sign-up`)
  await page.getByLabel('Your name').fill('Producer')
  await page.getByLabel('Email').fill(addressOf('producer'))
  await page.getByLabel('Password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { name: 'What is the game called?' })).toBeVisible()
  const me = await ask<{ studios: { id: string }[] }>(page.context(), `${url}/v1/me`)
  const opened = { studio_id: me.studios[0]?.id ?? '', name: 'Deep Field', cue_prefix: 'DF', preset: '44k1' }
  return (await ask<{ id: string }>(page.context(), `${url}/v1/projects`, 'POST', opened)).id
}

async function signIn(page: Page, url: string): Promise<void> {
  await page.goto(`${url}/sign-in`)
  await page.getByLabel('Email').fill(addressOf('producer'))
  await page.getByLabel('Password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(page.getByRole('heading', { name: 'Sign in' })).toBeHidden()
}

test('a cue stands in another browser and in another tab at once, whichever process answers @slow', async ({
  severalWeb: { url },
  page,
  browser,
}) => {
  const projectId = await openProject(page, url)
  const list = `${url}/projects/${projectId}/sound-list`
  const addCue = (name: string) =>
    ask(page.context(), `${url}/v1/projects/${projectId}/cues`, 'POST', { cues: [{ name }] })
  const other = await (await browser.newContext()).newPage()
  await signIn(other, url)
  await other.goto(list)
  const tab = await page.context().newPage()
  await tab.goto(list)
  await page.goto(list)
  await addCue('first_cue')
  for (const each of [other, tab, page]) await expect(each.getByText('first_cue').first()).toBeVisible()
  await page.waitForTimeout(6_000) // a calm
  await addCue('second_cue')
  const seen = [other, tab, page].map((each) =>
    expect(each.getByText('second_cue').first()).toBeVisible({ timeout: SOON_MS }),
  )
  await Promise.all(seen)
  await other.context().close()
  await tab.close()
})

test('nothing typed is lost', async ({ server, page }) => {
  const line = await Line.open()
  line.leadTo(server.port)
  const { url } = line
  const projectId = await openProject(page, url)
  const list = `${url}/projects/${projectId}/sound-list`
  const note = page.getByLabel('Message (optional)')
  await ask(page.context(), `${url}/v1/projects/${projectId}/cues`, 'POST', { cues: [{ name: 'second_cue' }] })

  await test.step('a form is restored after a reload', async () => {
    await page.goto(`${url}/projects/${projectId}/people`)
    await note.fill('You know the engine room.')
    await page.reload()
    await expect(note).toHaveValue('You know the engine room.')
    await expect(page.getByText('Draft restored')).toBeVisible()
  })

  await test.step('a session that ended is opened again in place, and the request sent again', async () => {
    await page.context().clearCookies({ name: 'soundlist_session' })
    const form = page.getByRole('form', { name: 'Invite a designer' })
    await form.getByLabel('Email').fill(addressOf('designer'))
    const send = form.getByRole('button', { name: 'Send invitation' })
    await expect(send).toBeEnabled() // the address is read by now
    // A read of the page may have opened the dialog already; the request waits for it all the same.
    await send.dispatchEvent('click')
    const dialog = page.getByRole('dialog', { name: 'Sign in to go on' })
    await expect(dialog.getByLabel('Email')).toHaveValue(addressOf('producer'))
    await dialog.getByLabel('Password', { exact: true }).fill(PASSWORD)
    await page.keyboard.press('Enter')
    await expect(page.getByText(`${addressOf('designer')} is invited.`)).toBeVisible()
    await expect(dialog).toBeHidden()
    await expect(note).toHaveValue('')
  })

  await test.step('while the server is away the page keeps what it shows, and then goes on', async () => {
    await page.goto(list)
    await expect(page.getByText('second_cue').first()).toBeVisible()
    line.cut()
    await expect(page.getByText('Can’t reach Soundlist. Retrying…')).toBeVisible()
    await expect(page.getByText('second_cue').first()).toBeVisible()
    await expect(page.getByRole('alert')).toHaveCount(0)
    line.fix()
    await expect(page.getByText('Can’t reach Soundlist. Retrying…')).toBeHidden()
  })
  line.close()
})
