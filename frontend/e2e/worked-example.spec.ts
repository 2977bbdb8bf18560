import { type Browser, expect, type Page } from '@playwright/test'

import { test } from './fixtures'
import { addressOf, Party, PASSWORD } from './party'
import type { SharedServer } from './server'
import { wav } from './sounds'

// The amounts of docs/explanation/contracts-and-money.md; nothing here waits for days to pass, so dock_clamp is approved by a person.
const ALPHA = ['radar_ping', 'dock_clamp', 'mine_arm']
const BETA = ['missile_launch', 'hull_hit', 'warp_in']
const RATES = 'Rates beyond the price'
const ROUND = "Price of a further round, as a part of the cue's price"
const inDays = (days: number) => new Date(Date.now() + days * 86_400_000).toISOString().slice(0, 10)

const EXAMPLE = 'a contract from three rounds of redlines to the next designer'

test(`${EXAMPLE} @slow`, ({ server, browser }) => walk(server, browser))

test(`${EXAMPLE}, on PostgreSQL @slow`, ({ onPostgres, browser }) => walk(onPostgres, browser))

interface Story {
  project: string
  studio: string
  cues: Record<string, string>
  producer: Party
  signer: Party
  designer: Party
}

async function walk(server: SharedServer, browser: Browser): Promise<void> {
  test.setTimeout(900_000) // nine sounds are checked and rendered meanwhile
  const arrive = async () => Party.arrive(server.url, await browser.newContext({ baseURL: server.url }))
  const story = await begin(await arrive(), await arrive(), await arrive())
  const { project, cues, producer, signer, designer } = story

  const contract = await test.step('the studio sends the text, and the designer edits it three times', async () => {
    const id = await draft(
      story,
      'Effects',
      { bonus_minor: 12_000, bonus_when: 'no_rejected_take', extra_round_bp: 2_000 },
      [
        { name: 'Deposit', amount_minor: 30_000, is_deposit: true },
        {
          name: 'Alpha',
          amount_minor: 54_001,
          due_on: inDays(11),
          cues: ALPHA.map((name) => ({ cue_id: cues[name] })),
        },
        { name: 'Beta', amount_minor: 94_500, due_on: inDays(28), cues: BETA.map((name) => ({ cue_id: cues[name] })) },
      ],
    )
    const me = async (party: Party) => (await party.ask<{ person: { id: string } }>('GET', '/me')).person.id
    const signers = { person_ids: [await me(producer), await me(signer)], first: 'designer' }
    await producer.ask('PUT', `/contracts/${id}/signers`, signers)
    const address = `/projects/${project}/contracts/${id}`
    await producer.page.goto(address)
    await send(producer.page, 'Sound designer')
    await propose(designer.page, address, '40')
    await answer(producer.page, address, async (page) => {
      await page.getByRole('button', { name: 'Keep as it was, change 1' }).click()
      await page.getByLabel('Why it is refused').fill('That is too much.')
      await page.getByRole('button', { name: 'Refuse the change' }).click()
    })
    await propose(designer.page, address, '30')
    await answer(producer.page, address, async (page) => {
      await page.getByRole('button', { name: 'Counter-propose to change 2' }).click()
      const form = page.getByRole('form', { name: 'Counter change 2' })
      await form.getByLabel(ROUND).fill('25')
      await form.getByRole('button', { name: 'Send the counter' }).click()
    })
    await propose(designer.page, address, '26')
    await answer(producer.page, address, (page) => page.getByRole('button', { name: 'Accept change 3' }).click())
    return id
  })
  const page = `/projects/${project}/contracts/${contract}`

  await test.step('the designer signs first, then the two signers of the studio', async () => {
    for (const party of [designer, producer, signer]) await sign(party.page, page, /^Sign version/)
    await expect(signer.page.getByText('Signed', { exact: false }).first()).toBeVisible()
    const { state } = await producer.ask<{ state: string }>('GET', `/contracts/${contract}`)
    expect(state).toBe('agreed')
  })

  await test.step('two sounds are accepted, one is cut in work, one needs a third round', async () => {
    for (const [name, pitchHz] of [
      ['radar_ping', 440],
      ['dock_clamp', 550],
    ] as const) {
      await approve(producer, await deliver(story, designer, name, pitchHz))
    }
    await askChange(story, await deliver(story, designer, 'mine_arm', 660))
    await producer.ask('POST', `/cues/${cues.mine_arm}/cut`, { reason: 'Mines left the game' })
    for (const pitchHz of [770, 780, 790]) {
      await askChange(story, await deliver(story, designer, 'missile_launch', pitchHz))
    }
  })

  await test.step('Today leads to what changed; the third round and a rush become change orders', async () => {
    await designer.page.goto(`/projects/${project}/desk`)
    await designer.page.getByRole('link', { name: 'See what changed' }).click()
    await expect(designer.page.getByRole('heading', { name: 'Change orders' })).toBeVisible()
    await designer.page.getByRole('button', { name: 'Propose a change order' }).click()
    await designer.page.getByRole('button', { name: 'Propose', exact: true }).click()
    await expect(designer.page.getByRole('heading', { name: 'Change order 1' })).toBeVisible()
    for (const party of [designer, producer, signer]) await sign(party.page, `${page}/changes`, 'Sign change order 1')
    await designer.page.goto(`${page}/changes`)
    const one = designer.page.getByRole('form', { name: 'One change' })
    await one.getByLabel('Change').selectOption('add_work')
    await one.getByLabel('Milestone').selectOption({ label: 'Beta' })
    await one.getByLabel('Work').fill('Rush: hull_hit')
    await one.getByLabel('Price in EUR').fill('94.50')
    await one.getByRole('button', { name: 'Add this change' }).click()
    await designer.page.getByLabel('Reason').fill('hull_hit is needed for the trailer')
    await designer.page.getByRole('button', { name: 'Propose', exact: true }).click()
    for (const party of [designer, producer, signer]) await sign(party.page, `${page}/changes`, 'Sign change order 2')
    await approve(producer, await deliver(story, designer, 'missile_launch', 800))
    await deliver(story, designer, 'hull_hit', 880)
  })

  await test.step('the contract ends at half: both sides agree to one statement', async () => {
    await producer.page.goto(`${page}/ending`)
    await producer.page.getByLabel('Reason').fill('The game is put off.')
    await producer.page.getByRole('button', { name: 'Give notice' }).click()
    await expect(producer.page.getByRole('heading', { name: 'Settlement statement' })).toBeVisible()
    for (const party of [designer, producer, signer]) await sign(party.page, `${page}/ending`, 'Agree to the statement')
    await expect(signer.page.getByRole('heading', { name: 'Settlement', exact: true })).toBeVisible()
    await producer.page.goto(`${page}/ending`)
    const statement = producer.page.getByRole('region', { name: 'Statement', exact: true })
    // 180.01 + 180.00 + 90.00 + 315.00 + 236.25 + 0.00; the round at 26 % of 315.00 is 81.90.
    await expect(statement).toContainText('1,001.26')
    await expect(statement).toContainText('81.90')
    await expect(statement).toContainText('94.50')
    await expect(statement.getByRole('row', { name: /^To pay/ })).toContainText('1,477.66') // with the deposit, 300.00
  })

  await test.step('the designer invoices it, the studio pays, and takes the handover pack', async () => {
    await designer.page.goto(`/projects/${project}/money`)
    await designer.page.getByLabel('From: name, address, tax number').fill('Sound designer\n1 Quay Street')
    await designer.page.getByRole('button', { name: 'Issue invoice 1' }).click()
    await expect(designer.page.getByRole('link', { name: 'Invoice 1' })).toBeVisible()
    await producer.page.goto(`/projects/${project}/money`)
    await producer.page.getByRole('button', { name: 'Record payment on invoice 1' }).click()
    const form = producer.page.getByRole('form', { name: 'Payment on invoice 1' })
    await form.getByLabel('Reference').fill('T-1')
    await form.getByRole('button', { name: 'Record payment' }).click()
    await expect(form).toBeHidden()
    await producer.page.goto(`${page}/ending`)
    const download = producer.page.waitForEvent('download')
    await producer.page.getByRole('link', { name: 'Download handover pack' }).click()
    expect((await download).suggestedFilename()).toMatch(/\.zip$/)
  })

  await test.step('the next designer finishes the list, and earns the bonus that the first one missed', async () => {
    const second = await arrive()
    await join(story, second, addressOf('second.designer'), 'Second designer')
    const rest = await draft(
      { ...story, designer: second },
      'Effects, second part',
      { bonus_minor: 6_000, bonus_when: 'no_rejected_take' },
      [
        { name: 'Deposit', amount_minor: 10_000, is_deposit: true },
        {
          name: 'Rest',
          amount_minor: 63_000,
          due_on: inDays(28),
          cues: BETA.slice(1).map((name) => ({ cue_id: cues[name] })),
        },
      ],
    )
    const address = `/projects/${project}/contracts/${rest}`
    await producer.page.goto(address)
    await send(producer.page, 'Second designer')
    for (const party of [second, producer]) await sign(party.page, address, /^Sign version/)
    for (const [name, pitchHz] of [
      ['hull_hit', 890],
      ['warp_in', 990],
    ] as const) {
      await approve(producer, await deliver(story, second, name, pitchHz))
    }
    const due = async (id: string) =>
      (await producer.ask<{ figures: { accepted_minor: number } }>('GET', `/contracts/${id}/ledger`)).figures
        .accepted_minor
    expect([await due(contract), await due(rest)]).toEqual([147_766, 79_000])
    for (const id of [contract, rest]) {
      expect((await second.context.request.get(`${server.url}/v1/contracts/${id}/ledger`)).status()).toBe(
        id === rest ? 200 : 404,
      )
      const { faults } = await producer.ask<{ faults: string[] }>('GET', `/contracts/${id}/record`)
      expect(faults).toEqual([])
    }
  })
}

/** A studio with two producers, a project with six cues, and its designer. */
async function begin(producer: Party, signer: Party, designer: Party): Promise<Story> {
  const signUp = { email: addressOf('producer'), name: 'Producer', password: PASSWORD, studio_name: 'Lantern' }
  await producer.ask('POST', '/sign-up', signUp)
  const studio = (await producer.ask<{ studios: { id: string }[] }>('GET', '/me')).studios[0]?.id ?? ''
  const invited = { email: addressOf('second.producer'), roles: ['producer'] }
  await producer.ask('POST', `/studios/${studio}/invitations`, invited)
  const secret = await secretFor(producer, studio, invited.email)
  await signer.ask('POST', `/studio-invitations/${secret}/accept`, { name: 'Second producer', password: PASSWORD })
  const opened = { studio_id: studio, name: 'Deep Field', cue_prefix: 'DF', description: '' }
  const project = (await producer.ask<{ id: string }>('POST', '/projects', opened)).id
  const wanted = { cues: [...ALPHA, ...BETA].map((name) => ({ name, state: 'locked' })) }
  const added = await producer.ask<{ id: string; name: string }[]>('POST', `/projects/${project}/cues`, wanted)
  const story = {
    project,
    studio,
    cues: Object.fromEntries(added.map(({ id, name }) => [name, id])),
    producer,
    signer,
    designer,
  }
  await join(story, designer, addressOf('designer'), 'Sound designer')
  return story
}

async function secretFor(producer: Party, studio: string, recipient: string): Promise<string> {
  let link = ''
  await expect(async () => {
    const { mails } = await producer.ask<{ mails: { recipient: string; link: string | null }[] }>(
      'GET',
      `/studios/${studio}/outbox`,
    )
    const isInvitation = /\/(join|invitation)\//
    link = mails.find((mail) => mail.recipient === recipient && isInvitation.test(mail.link ?? ''))?.link ?? ''
    expect(link).not.toBe('')
  }).toPass({ timeout: 300_000 })
  return link.split('/').at(-1) ?? ''
}

async function join({ project, studio, producer }: Story, designer: Party, email: string, name: string): Promise<void> {
  await producer.ask('POST', `/projects/${project}/invitations`, { email, kind: 'contract' })
  const secret = await secretFor(producer, studio, email)
  await designer.ask('POST', `/invitations/${secret}/accept`, { name, password: PASSWORD })
}

interface Version {
  number: number
  clauses: { key: string; stands: boolean }[]
  terms: Record<string, number | string>
}

/** Begin a draft with a bonus and a plan; returns the contract's id. */
async function draft(
  { project, producer, designer }: Story,
  title: string,
  terms: Record<string, number | string>,
  milestones: readonly object[],
): Promise<string> {
  const me = await designer.ask<{ person: { id: string } }>('GET', '/me')
  const { engagements } = await producer.ask<{ engagements: { id: string; designer: { id: string } }[] }>(
    'GET',
    `/projects/${project}`,
  )
  const engagement = engagements.find((one) => one.designer.id === me.person.id)
  const begun = await producer.ask<{
    id: string
    title: string
    currency: string
    release_clause: string
    holdback_bp: number
    version: Version
  }>('POST', `/projects/${project}/contracts`, {
    engagement_id: engagement?.id,
    kind: 'single',
    title,
    currency: 'EUR',
  })
  const { id, currency, release_clause, holdback_bp, version } = begun
  const clauses = version.clauses.map((clause) => (clause.key === 'bonus' ? { ...clause, stands: true } : clause))
  await producer.ask('PUT', `/contracts/${id}/draft`, {
    title,
    currency,
    release_clause,
    holdback_bp,
    clauses,
    terms: { ...version.terms, ...terms },
    based_on_version: version.number,
  })
  await producer.ask('PUT', `/contracts/${id}/milestones`, { milestones })
  return id
}

/** Propose another price of a further round, as the designer. */
async function propose(page: Page, address: string, percent: string): Promise<void> {
  await page.goto(address)
  await page.getByRole('link', { name: 'Propose changes' }).click()
  await page.getByRole('button', { name: `Edit ${RATES}` }).click()
  await page.getByLabel(ROUND).fill(percent)
  await page.getByRole('button', { name: 'Send 1 change to Lantern' }).click()
  await expect(page.getByText('1 change sent to Lantern.')).toBeVisible()
}

/** Answer the change that is open, and send the next version. */
async function answer(page: Page, address: string, act: (page: Page) => Promise<void>): Promise<void> {
  await page.goto(`${address}/redlines`)
  await act(page)
  await expect(page.getByText('Every change is answered. Sound designer receives')).toBeVisible()
  await send(page, 'Sound designer')
}

async function send(page: Page, designer: string): Promise<void> {
  const button = page.getByRole('button', { name: `Send to ${designer}` })
  await button.click()
  await expect(button).toBeHidden()
}

async function sign(page: Page, address: string, button: string | RegExp): Promise<void> {
  await page.goto(address)
  const name = page.getByLabel('Your full name')
  await name.fill('A. Name')
  await page.getByRole('button', { name: button }).click()
  await expect(name).toBeHidden()
}

interface Take {
  id: string
  state: string
}

/** Deliver a sound, and return the take once the checks let it through. */
async function deliver({ project }: Story, designer: Party, name: string, pitchHz: number): Promise<string> {
  const delivery = (await designer.ask<{ id: string }>('POST', `/projects/${project}/deliveries`, { note: '' })).id
  const upload = await designer.upload(delivery, `${name}.wav`, wav({ seconds: 0.4, pitchHz }))
  const body = { upload_id: upload, file_name: `${name}.wav` }
  const { id } = await designer.ask<Take>('POST', `/deliveries/${delivery}/takes`, body)
  await expect(async () => {
    expect((await designer.ask<Take>('GET', `/takes/${id}`)).state).toBe('conforming')
  }).toPass({ timeout: 300_000 })
  return id
}

const approve = (producer: Party, take: string) =>
  producer.ask('POST', `/takes/${take}/verdict`, { kind: 'approve', note: '' })

async function askChange({ project, producer }: Story, take: string): Promise<void> {
  await producer.ask('POST', `/takes/${take}/verdict`, { kind: 'request_change', note: 'Later thrust.' })
  await producer.ask('POST', `/projects/${project}/feedback`, { note: '' })
}
