import { type Browser, expect, type Page } from '@playwright/test'

import { test } from './fixtures'
import { addressOf, Party, PASSWORD } from './party'
import type { SharedServer } from './server'
import { wav } from './sounds'

const CUES = ['radar_ping', 'mine_arm', 'missile_launch']
const inDays = (days: number) => new Date(Date.now() + days * 86_400_000).toISOString().slice(0, 10)

interface Take {
  id: string
  state: string
}

const JOURNEY = 'a contract from the template to the last payment, in two browsers @slow'

test(JOURNEY, ({ server, browser }) => journey(server, browser))

test(`${JOURNEY}, on PostgreSQL @slow`, ({ onPostgres, browser }) => journey(onPostgres, browser))

async function journey(server: SharedServer, browser: Browser): Promise<void> {
  const viewport = { width: 1440, height: 900 }
  const producer = await Party.arrive(server.url, await browser.newContext({ baseURL: server.url, viewport }))
  const designer = await Party.arrive(server.url, await browser.newContext({ baseURL: server.url, viewport }))
  let project = ''
  let contract = ''
  let cues: Record<string, string> = {}

  await test.step('a producer and a designer are on one project', async () => {
    const signUp = { email: addressOf('producer'), name: 'Producer', password: PASSWORD, studio_name: 'Lantern' }
    await producer.ask('POST', '/sign-up', signUp)
    const me = await producer.ask<{ studios: { id: string }[] }>('GET', '/me')
    const studio = me.studios[0]?.id ?? ''
    const opened = { studio_id: studio, name: 'Deep Field', cue_prefix: 'DF', description: '' }
    project = (await producer.ask<{ id: string }>('POST', '/projects', opened)).id
    const wanted = { cues: CUES.map((name) => ({ name, state: 'locked' })) }
    const added = await producer.ask<{ id: string; name: string }[]>('POST', `/projects/${project}/cues`, wanted)
    cues = Object.fromEntries(added.map(({ id, name }) => [name, id]))
    const invitation = { email: addressOf('designer'), kind: 'contract' }
    await producer.ask('POST', `/projects/${project}/invitations`, invitation)
    let link = ''
    await expect(async () => {
      const outbox = await producer.ask<{ mails: { link: string | null }[] }>('GET', `/studios/${studio}/outbox`)
      link = outbox.mails.find((mail) => mail.link?.includes('/invitation/'))?.link ?? ''
      expect(link).not.toBe('')
    }).toPass()
    const secret = link.split('/').at(-1) ?? ''
    await designer.ask('POST', `/invitations/${secret}/accept`, { name: 'Sound designer', password: PASSWORD })
  })

  await test.step('the producer plans, sends the text and says yes; so does the designer', async () => {
    const { engagements } = await producer.ask<{ engagements: { id: string }[] }>('GET', `/projects/${project}`)
    const begun = { engagement_id: engagements[0]?.id, kind: 'single', title: 'Effects', currency: 'EUR' }
    contract = (await producer.ask<{ id: string }>('POST', `/projects/${project}/contracts`, begun)).id
    const milestones = [
      { name: 'Deposit', amount_minor: 24_000, is_deposit: true },
      { name: 'Alpha', amount_minor: 30_000, due_on: inDays(14), cues: [{ cue_id: cues.radar_ping }] },
      {
        name: 'Beta',
        amount_minor: 60_000,
        due_on: inDays(28),
        cues: [{ cue_id: cues.mine_arm }, { cue_id: cues.missile_launch }],
      },
    ]
    await producer.ask('PUT', `/contracts/${contract}/milestones`, { milestones })
    const address = `/projects/${project}/contracts/${contract}`
    await producer.page.goto(address)
    await producer.page.getByRole('button', { name: 'Send to Sound designer' }).click()
    for (const { page } of [designer, producer]) {
      await page.goto(address)
      const form = page.getByRole('form', { name: 'Accept' })
      await form.getByLabel('Your full name').fill('Full Name')
      await form.getByRole('button', { name: /^Sign version/ }).click()
      await expect(form).toBeHidden()
    }
  })

  const deliver = async (name: string, pitchHz: number): Promise<string> => {
    const delivery = (await designer.ask<{ id: string }>('POST', `/projects/${project}/deliveries`, { note: '' })).id
    const upload = await designer.upload(delivery, `${name}.wav`, wav({ seconds: 0.4, pitchHz }))
    const body = { upload_id: upload, file_name: `${name}.wav` }
    const { id } = await designer.ask<Take>('POST', `/deliveries/${delivery}/takes`, body)
    await expect(async () => {
      expect((await designer.ask<Take>('GET', `/takes/${id}`)).state).toBe('conforming')
    }).toPass()
    return id
  }
  const askChange = async (take: string) => {
    await producer.ask('POST', `/takes/${take}/verdict`, { kind: 'request_change', note: 'Later thrust.' })
    await producer.ask('POST', `/projects/${project}/feedback`, { note: '' })
  }
  const money = (page: Page) => page.getByRole('region', { name: 'Money in EUR' })

  await test.step('an acceptance, a cut in progress and a round too many', async () => {
    await producer.ask('POST', `/takes/${await deliver('radar_ping', 440)}/verdict`, { kind: 'approve', note: '' })
    await askChange(await deliver('mine_arm', 520))
    await producer.ask('POST', `/cues/${cues.mine_arm}/cut`, { reason: 'Mines left the game' })
    for (const pitchHz of [600, 610, 620]) await askChange(await deliver('missile_launch', pitchHz))
    await producer.page.goto(`/projects/${project}/money`)
    await expect(money(producer.page)).toContainText('€690.00') // 240 + 300 + half of 300
    await producer.page.getByRole('button', { name: 'Agree to €75.00 for missile_launch' }).click()
    await expect(money(producer.page)).toContainText('€765.00')
  })

  await test.step('the designer invoices what is due, and the producer records the payment', async () => {
    await designer.page.goto(`/projects/${project}/desk`)
    await designer.page.getByRole('link', { name: 'Draft invoice 1' }).click()
    await designer.page.getByLabel('From: name, address, tax number').fill('Sound designer\n1 Quay Street')
    await designer.page.getByRole('button', { name: 'Issue invoice 1' }).click()
    await expect(designer.page.getByRole('link', { name: 'Invoice 1' })).toBeVisible()
    await producer.page.reload()
    await producer.page.getByRole('button', { name: 'Record payment on invoice 1' }).click()
    const form = producer.page.getByRole('form', { name: 'Payment on invoice 1' })
    await form.getByLabel('Reference').fill('T-1')
    await form.getByRole('button', { name: 'Record payment' }).click()
    await expect(form).toBeHidden()
    await expect(money(producer.page)).toContainText('Paid 765.00')
    await expect(money(producer.page)).toContainText('Due 0.00')
  })

  await test.step('both read the same audit trail, and it is whole', async () => {
    const read = (party: Party) =>
      party.ask<{ faults: string[]; sha256: string }>('GET', `/contracts/${contract}/record`)
    const [theirs, ours] = [await read(designer), await read(producer)]
    expect(theirs).toEqual(ours)
    expect(ours.faults).toEqual([])
  })
}
