import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { aMe, anItem, aTake, PROJECT } from '@/test/review'
import { openApp } from '@/test/openApp'
import { type Asked, refusal } from '@/test/server'
import {
  alternates,
  day,
  open,
  opened,
  question,
  queueIs,
  server,
  serveTodayPage,
  single,
  TODAY,
} from '@/test/todayPage'

beforeAll(() => import('./TodayPage'))
serveTodayPage()

describe('what waits', () => {
  test('the head counts it, the first stands open, the rest in order of age', async () => {
    server.on(`GET ${TODAY}`, day({ questions: [question] }))
    await opened()
    expect(await screen.findByText('Two cues and one question wait for you.')).toBeVisible()
    expect(screen.getByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
    const then = screen.getByRole('region', { name: 'Next up' })
    expect(
      within(then)
        .getAllByRole('listitem')
        .map(({ textContent }) => /coolant_splash|suit_hit/.exec(textContent)?.[0]),
    ).toEqual(['coolant_splash', 'suit_hit'])
  })

  test('an alternate 2.1 LU above the first says by how much it comes down', async () => {
    await opened()
    const group = await screen.findByRole('radiogroup', { name: 'Alternates' })
    expect(within(group).getByRole('radio', { name: /^B/ })).toHaveTextContent('0.80 s, −2.1 dB')
  })

  test('what blocks an approval is said before the key is pressed, of the first and of the rest', async () => {
    const why = '1 comment is not resolved'
    queueIs(
      { ...alternates, blocked: [{ take_id: 'a', why }] },
      { ...single, blocked: [{ take_id: 's', why: '“No clicks” is not checked' }] },
    )
    server.on('POST /v1/takes/b/verdict', {})
    await opened()
    const first = screen.getByRole('region', { name: /shield_hit/ })
    expect(first).toHaveTextContent(`Not to be approved yet: ${why}.`)
    expect(within(first).getByRole('link', { name: 'Close it in Review' })).toHaveAttribute(
      'href',
      `/projects/${PROJECT}/review/shield`,
    )
    expect(within(first).getByRole('button', { name: /^Approve A/ })).toBeDisabled()
    expect(screen.getByRole('region', { name: 'Next up' })).toHaveTextContent(
      'Not to be approved yet: “No clicks” is not checked.',
    )
    await userEvent.keyboard('a')
    await userEvent.keyboard('2') // the other alternate is free
    expect(within(first).getByRole('button', { name: /^Approve B/ })).toBeEnabled()
    expect(first).not.toHaveTextContent(why)
    await userEvent.keyboard('a')
    await waitFor(() => expect(server.of('POST /v1/takes/b/verdict')).toHaveLength(1))
    expect(server.of('POST /v1/takes/a/verdict')).toEqual([])
  })

  test('who does not decide is not held up by what blocks', async () => {
    queueIs({ ...single, blocked: [{ take_id: 's', why: '1 comment is not resolved' }] })
    server.on('GET /v1/me', aMe({ is_approver: false, approves_all: false }))
    open()
    expect(await screen.findByRole('button', { name: 'Open to comment' })).toBeEnabled()
    expect(screen.queryByText(/Not to be approved yet/)).toBeNull()
  })

  test('a page that comes short is read on', async () => {
    server.on('GET /v1/review-queue', ({ query }: Asked) =>
      query.get('cursor') === 'second' ? { items: [single], next: null } : { items: [alternates], next: 'second' },
    )
    await opened()
    expect(await screen.findByText('Two cues wait for you.')).toBeVisible()
  })

  test('of a long queue its beginning is shown, how many wait, and more when it is asked', async () => {
    const many = Array.from({ length: 32 }, (_, place) =>
      anItem({ id: `cue-${place}`, name: `hit_${place}` }, [aTake(`take-${place}`)]),
    )
    server
      .on('GET /v1/review-queue', ({ query }: Asked) => {
        const to = Number(query.get('cursor') ?? 0) + 12
        return { items: many.slice(to - 12, to), next: to < many.length ? String(to) : null }
      })
      .on('GET /v1/review-queue/count', { cues: 99, is_all: false })
    await opened()
    expect(await screen.findByText('More than 99 cues wait for you.')).toBeVisible()
    const then = within(screen.getByRole('region', { name: 'Next up' }))
    expect(then.getAllByRole('listitem')).toHaveLength(11)
    for (const shown of [23, 31]) {
      await userEvent.click(then.getByRole('button', { name: 'Show more' }))
      await waitFor(() => expect(then.getAllByRole('listitem')).toHaveLength(shown))
    }
    expect(then.queryByRole('button', { name: 'Show more' })).toBeNull()
    expect(server.of('GET /v1/review-queue')).toHaveLength(3)
  })

  test('with nothing waiting it says what comes next', async () => {
    queueIs()
    server.on(`GET ${TODAY}`, day({ counts: { returned: 2, to_make: 10 } }))
    open()
    expect(await screen.findByRole('heading', { name: 'Nothing to do' })).toBeVisible()
    expect(screen.getByText('Next come what designers deliver: 2 with designers, 10 to do.')).toBeVisible()
  })

  test('a refusal is said, and can be asked again', async () => {
    server.on('GET /v1/review-queue', () => refusal(403, 'team-needed', 'Only the team has a queue.'))
    open()
    expect(await screen.findByRole('alert')).toHaveTextContent('Only the team has a queue.')
    server.on('GET /v1/review-queue', { items: [alternates, single], next: null })
    await userEvent.click(screen.getByRole('button', { name: 'Try again' }))
    expect(await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
  })

  test('axe finds nothing', { tags: ['slow'] }, async () => {
    server.on(`GET ${TODAY}`, day({ questions: [question], placeholders: 2 }))
    await opened()
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
  })
})

describe('the next step', () => {
  const NEXT = `GET /v1/projects/${PROJECT}/next-steps`
  const step = (kind: string, more: object = {}) => ({ kind, count: 1, subject: '', who: '', since: null, ...more })

  test('is named first, with what else there is, and what others are to do', async () => {
    server.on(`GET /v1/projects/${PROJECT}`, {
      approver: { id: 'approver', name: 'Audio director' },
      category_approvers: [],
      liaisons: [],
      engagements: [{ designer: { id: 'ada', name: 'Ada' } }],
    })
    server.on(NEXT, {
      steps: [
        step('sign_contract', { subject: 'Effects', who: 'Ada', contract_id: 'c1', since: '2026-11-20T11:00:00Z' }),
        step('pay_invoice', { subject: '3', who: 'Ada', amount_minor: 69_750, currency: 'USD' }),
        step('deposit_due', { subject: 'Effects', who: 'Ada', amount_minor: 30_000, currency: 'USD' }),
        step('review', { count: 2 }),
      ],
      awaited: [
        { kind: 'join', who: 'maker@tones.example', count: 1, subject: '', since: '2026-11-20T11:00:00Z' },
        { kind: 'invoice', who: 'Ada', person_id: 'ada', count: 1, subject: 'Effects', since: '2026-11-20T11:00:00Z' },
      ],
    })
    await opened()
    const next = await screen.findByRole('region', { name: 'Sign Effects' })
    expect(within(next).getByRole('link', { name: 'Read and sign: Sign Effects' })).toHaveAttribute(
      'href',
      `/projects/${PROJECT}/contracts/c1`,
    )
    expect(within(next).getByRole('link', { name: /^Pay invoice 3: \$697\.50/ })).toBeVisible()
    expect(within(next).getByRole('link', { name: /^Deposit due to Ada: \$300\.00 Effects is signed/ })).toBeVisible()
    expect(screen.queryByText(/^Review 2 cues/)).toBeNull()
    const others = screen.getByRole('region', { name: 'Waiting on others' })
    expect(others).toHaveTextContent('maker@tones.example to join')
    await waitFor(() => expect(others).toHaveTextContent(/Ada\s*designer\s*to invoice Effects/))
    const tabs = screen.getByRole('navigation', { name: 'Areas' })
    expect(within(tabs).getByRole('link', { name: /^Contract & money.*3/ })).toBeVisible()
    expect(within(tabs).getByRole('link', { name: /^Today\s*3/ })).toBeVisible()
  })

  test('of a producer who does not judge has no sound', async () => {
    const me = aMe()
    server.on('GET /v1/me', {
      ...me,
      projects: me.projects.map((one) => ({ ...one, is_producer: true, is_approver: false })),
    })
    server.on(`GET ${TODAY}`, day({ questions: [question] }))
    server.on(NEXT, { steps: [], awaited: [] })
    open()
    const asked = await screen.findByRole('region', { name: /^Questions for you/ })
    const sounds = screen.getByRole('region', { name: /^With the approver/ })
    expect(asked.compareDocumentPosition(sounds)).toBe(Node.DOCUMENT_POSITION_FOLLOWING)
    expect(screen.queryByRole('heading', { name: /^Pick one of two/ })).toBeNull()
    expect(screen.getByText('One question waits for you, two cues for the approver.')).toBeVisible()
  })
})

test('the start leads to Today of the team’s project', async () => {
  const { at } = openApp('/')
  await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })
  expect(at()).toBe(`/projects/${PROJECT}/today`)
})

test('j and k step through what waits', async () => {
  await opened()
  await userEvent.keyboard('j')
  expect(screen.getByRole('link', { name: 'Pick one of two for shield_hit' })).toHaveFocus()
  await userEvent.keyboard('j')
  expect(screen.getByRole('link', { name: /suit_hit/ })).toHaveFocus()
  await userEvent.keyboard('k')
  expect(screen.getByRole('link', { name: 'Pick one of two for shield_hit' })).toHaveFocus()
})
