import { expect, type Locator, type Page } from '@playwright/test'

import { ask } from './api'
import { atWork, visit } from './atWork'
import { test } from './fixtures'
import { PASSWORD } from './party'
import { wav } from './sounds'

/** A form that people fill in, and what shows that it was sent. */
interface Typed {
  name: string
  path: string
  /** Show the form, where its page does not do so by itself. */
  open?: () => Promise<void>
  field: Locator
  /** What is typed, and what it becomes when the person goes on. */
  first: string
  then: string
  /** Escape leaves the page; of what was restored nothing is asked. */
  escapes?: boolean
  /** What is chosen beside the text. */
  choose?: () => Promise<void>
  chosen?: () => Promise<void>
  send: Locator
  sent: Locator
  /** What was sent is what the form shows from then on. */
  keeps?: boolean
}

const signInAgain = (page: Page) => page.getByRole('dialog', { name: 'Sign in to go on' })
const leaveDialog = (page: Page) => page.getByRole('dialog', { name: 'Leave this page?' })
const toast = (page: Page, text: string | RegExp) => page.getByRole('status').filter({ hasText: text })

/** Type into a form, leave it in every way that people leave forms, and send it after the session has ended. */
async function leaveAndSend(page: Page, form: Typed): Promise<void> {
  const show = async (text: string) => {
    await form.open?.()
    await expect(form.field, `${form.name} after ${text}`).toHaveValue(text)
    await form.chosen?.()
  }
  await page.goto(form.path)
  await form.open?.()
  await form.field.fill(form.first)
  await form.choose?.()

  await page.reload()
  await show(form.first)

  await form.field.press('Escape')
  if (form.escapes) {
    await expect(page).not.toHaveURL(form.path)
    await page.goBack()
  }
  await show(form.first)

  await form.field.fill(form.then)
  const elsewhere = page.getByRole('navigation', { name: 'Areas' }).getByRole('link', { name: /^Today/ })
  await elsewhere.click()
  await expect(leaveDialog(page), `${form.name} is left`).toBeVisible()
  await leaveDialog(page).getByRole('button', { name: 'Leave', exact: true }).click()
  await expect(leaveDialog(page)).toBeHidden()
  await expect(page).not.toHaveURL(form.path)

  await page.goBack()
  await show(form.then)
  await form.field.fill(form.first)
  await page.goForward()
  await leaveDialog(page).getByRole('button', { name: 'Stay' }).click()
  await show(form.first)

  await form.field.fill(form.then)
  await expect(form.send).toBeEnabled() // what was typed is read by now
  await page.context().clearCookies({ name: 'soundlist_session' })
  // A comment shows before the server has it: the page is left once the server has answered.
  const answer = page.waitForResponse(
    (response) => response.request().method() !== 'GET' && response.ok() && !response.url().endsWith('/v1/sign-in'),
  )
  // A read of the page may have opened the dialog already; the request waits for it all the same.
  await form.send.dispatchEvent('click')
  await signInAgain(page).getByLabel('Password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
  await expect(signInAgain(page)).toBeHidden()
  await expect(form.sent.first(), `${form.name} is sent`).toBeVisible()
  await answer
  // What was typed is kept until the page has read the answer.
  await expect
    .poll(() => page.evaluate(() => Object.keys(localStorage).filter((key) => key.includes('-draft:'))))
    .toEqual([])

  await page.goto(form.path)
  await form.open?.()
  await expect(page.getByText('Draft restored')).toBeHidden()
  if (!form.keeps) await expect(form.field, `${form.name} starts empty`).not.toHaveValue(form.then)
}

test('whatever is typed is there again, however a form is left @slow', async ({ server: { url }, browser }) => {
  const [page, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(page, designer, url, [{ name: 'airlock' }])
  const at = `${url}/projects/${project}`
  const producer = page.context()

  const { id: delivery } = await ask<{ id: string }>(
    designer.context(),
    `${url}/v1/projects/${project}/deliveries`,
    'POST',
    { note: '' },
  )
  const csrf = (await designer.context().cookies(url)).find(({ name }) => name === 'soundlist_csrf')?.value ?? ''
  await designer.request.post(`${url}/v1/deliveries/${delivery}/files`, {
    params: { file_name: 'airlock.wav' },
    data: wav({ seconds: 0.3 }),
    headers: { 'X-CSRF-Token': csrf, 'Content-Type': 'application/octet-stream' },
  })
  const { engagements } = await ask<{ engagements: { id: string }[] }>(producer, `${url}/v1/projects/${project}`)
  const begun = { engagement_id: engagements[0]?.id, kind: 'single', title: 'Effects', currency: 'EUR' }
  const { id: contract } = await ask<{ id: string }>(producer, `${url}/v1/projects/${project}/contracts`, 'POST', begun)
  const queue = `${url}/v1/review-queue?project_id=${project}`
  let cue = ''
  await expect(async () => {
    const { items } = await ask<{ items: { cue: { id: string } }[] }>(producer, queue)
    cue = items[0]?.cue.id ?? ''
    expect(cue).not.toBe('')
  }).toPass({ timeout: 300_000 })

  const select = page.getByRole('combobox', { name: 'Map Mood to' })
  const plan = page.getByRole('group', { name: /alpha|milestone 1/i })
  const inList = page.getByRole('row').filter({ hasText: 'airlock' })
  const forms: Typed[] = [
    {
      name: 'an invitation',
      path: `${at}/people`,
      field: page.getByRole('form', { name: 'Invite a designer' }).getByLabel('Email'),
      first: 'second@tones.example',
      then: 'other@tones.example',
      send: page.getByRole('button', { name: 'Send invitation' }),
      sent: toast(page, 'other@tones.example is invited.'),
    },
    {
      name: 'the spec',
      path: `${at}/spec?view=all`,
      field: page.getByLabel('Pattern (regular expression) without the extension'),
      first: '[a-z]+',
      then: '[a-z_]+',
      send: page.getByRole('button', { name: 'Save version 2' }),
      sent: toast(page, 'Version 2 of the spec saved.'),
      keeps: true,
    },
    {
      name: 'an import with its mapping',
      path: `${at}/sound-list/import`,
      field: page.getByLabel('Pasted rows'),
      first: 'Sound\tMood\nhatch\tcalm',
      then: 'Sound\tMood\nhatch\tcalmer',
      choose: async () => {
        await select.selectOption('description')
      },
      escapes: true,
      chosen: () => expect(select).toHaveValue('description'),
      send: page.getByRole('button', { name: 'Import 1 cue' }),
      sent: toast(page, '1 cue added'),
    },
    {
      name: 'a new cue',
      path: `${at}/sound-list`,
      open: async () => {
        await expect(inList.first()).toBeVisible()
        if (!(await page.getByRole('region', { name: 'New cues' }).isVisible())) await page.keyboard.press('n')
      },
      field: page.getByLabel('Name, row 1'),
      first: 'reactor',
      then: 'reactor_hum',
      send: page.getByRole('button', { name: 'Add 1 cue' }),
      sent: toast(page, '1 cue added'),
    },
    {
      name: 'a cue',
      path: `${at}/sound-list/cues/${cue}`,
      open: async () => {
        await expect(page.getByRole('heading', { level: 1, name: 'airlock' })).toBeVisible()
        if (!(await page.getByRole('form', { name: 'Edit airlock' }).isVisible())) await page.keyboard.press('e')
      },
      field: page.getByRole('form', { name: 'Edit airlock' }).getByLabel('Use in the game'),
      first: 'Every cabin door',
      then: 'Every cabin door and lock',
      send: page.getByRole('button', { name: 'Save airlock' }),
      sent: toast(page, 'airlock saved.'),
      keeps: true,
    },
    {
      name: 'a plan',
      path: `${at}/contracts/${contract}/plan`,
      open: async () => {
        await expect(page.getByRole('heading', { level: 1, name: /^Plan: / })).toBeVisible()
        if (!(await plan.first().isVisible())) await page.getByRole('button', { name: 'Add milestone' }).first().click()
      },
      field: plan.first().getByLabel('Name'),
      first: 'Alpha',
      then: 'Alpha of the game',
      send: page.getByRole('button', { name: 'Save plan' }),
      sent: toast(page, 'Plan saved.'),
      keeps: true,
    },
    {
      name: 'the clauses of a draft',
      path: `${at}/contracts/${contract}/draft?view=text`,
      field: page.getByLabel('Title', { exact: true }),
      first: 'Effects for the game',
      then: 'Effects for Deep Field',
      send: page.getByRole('button', { name: 'Save version' }),
      sent: toast(page, /^Saved as version \d/),
      keeps: true,
    },
    {
      name: 'a comment',
      path: `${at}/review/${cue}`,
      open: async () => {
        await expect(page.getByRole('region', { name: 'Verdict' })).toBeVisible()
        if (!(await page.getByRole('button', { name: 'Send', exact: true }).isVisible())) await page.keyboard.press('c')
      },
      field: page.getByRole('textbox', { name: /^Comment/ }),
      first: 'A clear attack',
      then: 'A clear attack, and dry',
      send: page.getByRole('button', { name: 'Send', exact: true }),
      sent: page.getByRole('list', { name: 'Comments' }).filter({ hasText: 'A clear attack, and dry' }),
    },
    {
      name: 'a change request',
      path: `${at}/review/${cue}`,
      open: async () => {
        await expect(page.getByRole('region', { name: 'Verdict' })).toBeVisible()
        if (!(await page.getByRole('form', { name: /^What to change/ }).isVisible())) await page.keyboard.press('r')
      },
      field: page.getByRole('textbox', { name: /^What to change/ }),
      first: 'Later thrust',
      then: 'Later thrust, and longer',
      send: page.getByRole('button', { name: /^Send to / }),
      sent: page.getByRole('status').filter({ hasText: /^Change requested/ }),
    },
  ]
  for (const form of forms) await test.step(form.name, () => leaveAndSend(page, form))
})
