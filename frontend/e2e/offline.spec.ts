import { expect } from '@playwright/test'

import { ask } from './api'
import { atWork, deliver, visit } from './atWork'
import { test } from './fixtures'
import { heardAll } from './listening'
import { wav } from './sounds'

interface Review {
  takes: { id: string; state: string; draft_change: { text: string } | null }[]
  comments: { text: string }[]
}

const NAMES = ['Hull door open', 'Hull door shut', 'Airlock cycle']

test('verdicts and comments given without a line are sent later, in order, once @slow', async ({ server, browser }) => {
  const { url } = server
  const [producer, designer] = await Promise.all([visit(browser), visit(browser)])
  const project = await atWork(
    producer,
    designer,
    url,
    NAMES.map((name) => ({ name })),
  )
  const asProducer = producer.context()
  const { cues } = await ask<{ cues: { stems: string[] }[] }>(asProducer, `${url}/v1/projects/${project}/sound-list`)
  const files = cues.map(({ stems }, at) => {
    const sound = wav({ rateHz: 44_100, bits: 16, seconds: 0.6 + at / 10, peak: 0.3 })
    return [`${stems[0] ?? ''}.wav`, sound] as const
  })
  await deliver(designer, producer, url, project, Object.fromEntries(files))
  const queue = () =>
    ask<{ items: { cue: { id: string; name: string } }[] }>(asProducer, `${url}/v1/review-queue?project_id=${project}`)
  await expect.poll(async () => (await queue()).items.length).toBe(NAMES.length)
  await heardAll(asProducer, url, project)
  const { items } = await queue()
  const order = items.map(({ cue }) => cue) // checks end in any order
  const review = (at: number) => ask<Review>(asProducer, `${url}/v1/cues/${order[at]?.id ?? ''}/review`)
  const heading = (at: number) => producer.getByRole('heading', { level: 1, name: order[at]?.name })
  await producer.goto(`${url}/projects/${project}/review/${order[0]?.id ?? ''}`)
  await expect(heading(0)).toBeVisible()
  await expect(
    producer.getByRole('radiogroup', { name: 'Alternates' }).or(producer.getByText('Your call')).first(),
  ).toBeVisible()
  await producer.waitForTimeout(1_000) // what is next in the queue is read ahead
  await asProducer.setOffline(true)

  await test.step('a verdict, a change and a comment are given, and the next cue opens each time', async () => {
    await producer.keyboard.press('a')
    await expect(heading(1)).toBeVisible()
    await expect(producer.getByText('1 verdict kept in this browser until it is back.')).toBeVisible()
    await producer.keyboard.press('u') // taken out of what is kept, without a line
    await expect(heading(0)).toBeVisible()
    await expect(producer.getByText('kept in this browser')).toBeHidden()
    await producer.keyboard.press('a')
    await expect(heading(1)).toBeVisible()
    await producer.keyboard.press('r')
    await producer.keyboard.type('duller, please')
    await producer.keyboard.press('Enter')
    await expect(heading(2)).toBeVisible()
    await producer.keyboard.press('c')
    await producer.keyboard.type('the seal is lovely')
    await producer.keyboard.press('Control+Enter')
    await expect(producer.getByText('waits for the connection')).toBeVisible()
    await expect(producer.getByText('2 verdicts and 1 comment kept in this browser until it is back.')).toBeVisible()
  })

  await test.step('the page is closed, and the next one sends them once the line is back', async () => {
    await producer.close()
    await asProducer.setOffline(false)
    const next = await asProducer.newPage()
    const later: string[] = []
    next.on('request', (request) => {
      if (request.method() === 'POST' && /\/(verdict|comments)$/.test(request.url())) later.push(request.url())
    })
    await next.goto(`${url}/projects/${project}`)
    await expect.poll(async () => (await review(2)).comments.map(({ text }) => text)).toEqual(['the seal is lovely'])
    expect((await review(0)).takes.map(({ state }) => state)).toEqual(['approved'])
    expect((await review(1)).takes.map(({ draft_change }) => draft_change?.text)).toEqual(['duller, please'])
    expect(later.map((address) => address.split('/').at(-1))).toEqual(['verdict', 'verdict', 'comments'])
    await next.reload()
    await expect(next.getByRole('heading', { level: 1 })).toBeVisible()
    expect(later).toHaveLength(3)
  })

  await test.step('a verdict that was sent is undone without a line, and the page after that sends the undo', async () => {
    const judging = await asProducer.newPage()
    await judging.goto(`${url}/projects/${project}/review/${order[2]?.id ?? ''}`)
    const cue = judging.getByRole('heading', { level: 1, name: order[2]?.name })
    await expect(judging.getByRole('region', { name: 'Verdict' })).toBeVisible()
    const answer = judging.waitForResponse((one) => one.url().endsWith('/verdict'))
    await judging.keyboard.press('a')
    await answer
    await expect(cue).toBeHidden()
    await asProducer.setOffline(true)
    await judging.keyboard.press('u')
    await expect(cue).toBeVisible()
    await expect(judging.getByText('1 undo kept in this browser until it is back.')).toBeVisible()
    await judging.close()
    await asProducer.setOffline(false)
    expect((await review(2)).takes.map(({ state }) => state)).toEqual(['approved'])
    const next = await asProducer.newPage()
    await next.goto(`${url}/projects/${project}`)
    await expect.poll(async () => (await review(2)).takes.map(({ state }) => state)).toEqual(['conforming'])
  })
})
