import { type Browser, expect, type Page } from '@playwright/test'

import { ask } from './api'
import { visit } from './atWork'
import { test } from './fixtures'
import { addressOf, PASSWORD } from './party'

/** The link that was mailed to somebody; without a mail server it is in the studio's outbox. */
async function linkTo(producer: Page, url: string, recipient: string, subject: RegExp): Promise<string> {
  const { studios } = await ask<{ studios: { id: string }[] }>(producer.context(), `${url}/v1/me`)
  const outbox = `${url}/v1/studios/${studios[0]?.id}/outbox`
  let link = ''
  await expect(async () => {
    const { mails } = await ask<{ mails: { recipient: string; subject: string; link: string | null }[] }>(
      producer.context(),
      outbox,
    )
    link = mails.find((mail) => mail.recipient === recipient && subject.test(mail.subject))?.link ?? ''
    expect(link).not.toBe('')
  }).toPass()
  return link
}

const NEXT_YEAR = new Date().getFullYear() + 1

/** Give the bid that is open a price a line, hours and dates, and send it. */
async function bid(page: Page, price: string, hours: string): Promise<void> {
  await expect(page.getByRole('heading', { name: 'Your bid' })).toBeVisible()
  for (const field of await page.getByLabel('Price, USD').all()) await field.fill(price)
  await page.getByLabel('Hours in all').fill(hours)
  await page.getByLabel('From', { exact: true }).fill(`${NEXT_YEAR}-01-11`)
  await page.getByLabel('To', { exact: true }).fill(`${NEXT_YEAR}-03-26`)
  await page.keyboard.press('Control+Enter')
  await expect(page.getByRole('button', { name: /^Send again/ })).toBeVisible()
}

/** An account of a name and a password, by a link that was mailed. */
async function arriveBy(page: Page, link: string, name: string): Promise<void> {
  await page.goto(link)
  await page.getByLabel('Your name').fill(name)
  await page.getByLabel('New password', { exact: true }).fill(PASSWORD)
  await page.keyboard.press('Enter')
}

/** From an empty project to a draft contract over the chosen bid. */
async function hire(browser: Browser, url: string): Promise<void> {
  const [producer, ada, ben] = await Promise.all([visit(browser), visit(browser), visit(browser)])

  await test.step('a producer opens a project and answers the first questions of the brief', async () => {
    await producer.goto(`${url}/sign-up`)
    await producer.getByLabel('Your name').fill('Producer')
    await producer.getByLabel('Email').fill(addressOf('producer'))
    await producer.getByLabel('Password', { exact: true }).fill(PASSWORD)
    await producer.keyboard.press('Enter')
    await producer.getByLabel('Game title').fill('Deep Field')
    await producer.keyboard.press('Enter')
    await expect(producer.getByRole('heading', { name: 'Which sounds do you need?' })).toBeVisible()
    await producer.getByRole('navigation', { name: 'Areas' }).getByRole('link', { name: 'Sounds' }).click()
    await producer.getByRole('navigation', { name: 'Pages of Sounds' }).getByRole('link', { name: 'Brief' }).click()
    await producer.getByRole('region', { name: 'What kind of game is it?' }).getByRole('textbox').fill('A platformer')
    await producer.keyboard.press('Escape')
    await producer.getByRole('button', { name: /^Next topic/ }).click()
    await producer.getByRole('button', { name: /phone/i }).first().click()
    await expect(producer.getByText('Saved', { exact: true })).toBeVisible()
    const changes = producer.getByRole('list', { name: 'Changes that the answers ask for' })
    await expect(changes.getByRole('listitem').first()).toBeVisible()
    await producer.getByRole('button', { name: 'Save as version 2 of the spec' }).click()
    await expect(producer.getByText(/^Version 2 of the spec saved/)).toBeVisible()
    await producer.getByRole('button', { name: 'Publish version 1' }).click()
    await expect(producer.getByText('Version 1 of the brief published.')).toBeVisible()
  })

  let cues = 0
  await test.step('fills the list from a kit', async () => {
    await producer.getByRole('navigation', { name: 'Areas' }).getByRole('link', { name: 'Sounds' }).click()
    await producer.getByRole('link', { name: /kit/i }).first().click()
    await producer
      .getByRole('link', { name: /^Look at its cues/ })
      .first()
      .click()
    const add = producer.getByRole('button', { name: /^Add \d+ cues/ })
    cues = Number(/\d+/.exec(await add.innerText())?.[0])
    await add.click()
    await expect(producer.getByText(`${cues} cues added from the`)).toBeVisible()
  })

  const project = /\/projects\/[0-9a-f-]{36}/.exec(producer.url())?.[0] ?? ''
  await test.step('posts the work: one designer is asked by mail, the other comes by the link', async () => {
    await producer.goto(`${url}${project}/postings`)
    await producer.getByLabel('Title').fill('All sounds of Deep Field')
    await producer.keyboard.press('Enter')
    await producer.getByLabel('Budget', { exact: true }).fill('9000')
    await producer.getByLabel('Bids until').fill(`${NEXT_YEAR}-01-05`)
    await producer.getByLabel('Work from').fill(`${NEXT_YEAR}-01-11`)
    await producer.getByLabel('Work to').fill(`${NEXT_YEAR}-03-31`)
    await producer.getByRole('button', { name: 'Save', exact: true }).click()
    await expect(producer.getByText('Posting saved.')).toBeVisible()
    await producer.getByLabel('Email of a designer').fill(addressOf('ada'))
    await producer.keyboard.press('Enter')
    await expect(producer.getByText('asked when it opens')).toBeVisible()
    await producer.getByRole('button', { name: 'Open for bids' }).click()
    await expect(producer.getByText(/^Open\. 0 bids/)).toBeVisible()
    await producer.getByRole('button', { name: 'Make a link for everyone' }).click()
    const link = await producer.getByLabel('Link, shown this once').inputValue()

    const asked = await linkTo(producer, url, addressOf('ada'), /asks you for a bid/)
    await arriveBy(ada, asked, 'Ada Tones')
    await bid(ada, '60', '90')

    await ben.goto(link)
    await expect(ben.getByRole('heading', { name: 'All sounds of Deep Field' })).toBeVisible()
    await ben.getByLabel('Email').fill(addressOf('ben'))
    await ben.getByRole('button', { name: /^(Email me|Ask for) a link$/ }).click()
    await expect(ben.getByText(`the studio hands you a link for ${addressOf('ben')}`)).toBeVisible()
    const own = await linkTo(producer, url, addressOf('ben'), /asks you for a bid/)
    await arriveBy(ben, own, 'Ben Waves')
    await bid(ben, '75', '80')
  })

  await test.step('compares two bids by keys, and awards one', async () => {
    await producer.goto(`${url}${project}/today`)
    await producer.getByRole('link', { name: /Compare 2 bids/ }).click()
    await expect(producer.getByRole('heading', { name: '2 bids on All sounds of Deep Field' })).toBeVisible()
    await producer.keyboard.press('2')
    await expect(producer.getByRole('heading', { name: 'Your scores for Ben Waves' })).toBeVisible()
    await producer.keyboard.press('l')
    await expect(producer.getByRole('button', { name: 'Shortlist Ben Waves' })).toHaveText('Shortlisted')
    await producer.keyboard.press('Shift+Enter')
    const dialog = producer.getByRole('dialog', { name: 'Award All sounds of Deep Field to Ben Waves?' })
    await expect(dialog).toContainText('Ada Tones: thanked')
    await dialog.getByRole('button', { name: 'Award', exact: true }).click()
    await expect(producer).toHaveURL(/\/contracts\/[0-9a-f-]{36}\/draft$/)
  })

  await test.step('both hear of it, the draft has the figures, and the chosen one has a desk', async () => {
    await linkTo(producer, url, addressOf('ada'), /another bid was chosen/)
    const contractId = /contracts\/([0-9a-f-]{36})/.exec(producer.url())?.[1] ?? ''
    const { milestones } = await ask<{ milestones: { amount_minor: number }[] }>(
      producer.context(),
      `${url}/v1/contracts/${contractId}/milestones`,
    )
    const total = milestones.reduce((sum, milestone) => sum + milestone.amount_minor, 0)
    expect(total).toBe(cues * 7_500)
    await ada.reload()
    await expect(ada.getByText('Another bid was chosen. Thank you')).toBeVisible()
    await ben.reload()
    await expect(ben.getByText('Chosen. A contract follows')).toBeVisible()
    await ben.getByRole('link', { name: 'Go to your desk' }).click()
    await expect(ben.getByRole('heading', { name: 'Your desk' })).toBeVisible()
  })
}

test('a producer hires by a posting, on SQLite @slow', async ({ server, browser }) => {
  await hire(browser, server.url)
})

test('a producer hires by a posting, on PostgreSQL @slow', async ({ onPostgres, browser }) => {
  await hire(browser, onPostgres.url)
})
