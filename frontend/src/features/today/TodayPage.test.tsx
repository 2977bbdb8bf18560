import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import type { QueueItem } from '@/judging/api'
import { HandContext } from '@/test/audioContext'
import { aDraft, aMe, anItem, aPreview, aServer, aTake, PROJECT, somePeaks } from '@/test/review'
import { openApp } from '@/test/openApp'
import { type Asked, refusal } from '@/test/server'

import type { TodayAnswer } from './api'
import { headline } from './headline'

beforeAll(() => import('./TodayPage'))

const TODAY = `/v1/projects/${PROJECT}/today`
const DRAFTS = `/v1/projects/${PROJECT}/change-requests`

const alternates = anItem({ id: 'shield', name: 'shield_hit' }, [
  aTake('a', { number: 1 }),
  aTake('b', { number: 2, loudness_lufs: -13.9 }),
])
const single = anItem({ id: 'suit', name: 'suit_hit', label: 'SW-011' }, [aTake('s', { number: 2 })], {
  waiting_since: '2026-11-20T11:00:00Z',
})

function day(answer: Partial<TodayAnswer> = {}): TodayAnswer {
  return {
    questions: [],
    with_others: [],
    builds: [],
    counts: {},
    draft_changes: 0,
    placeholders: 0,
    unsent_mails: 0,
    ...answer,
  }
}

const question = {
  id: 'question-1',
  cue: { id: 'coolant', label: 'SW-010', name: 'coolant_splash' },
  text: 'What falls in: a drop, a tool, a person?',
  asked_by: { id: 'designer', name: 'Sound designer' },
  asked_at: '2026-11-15T10:00:00Z',
  answer: null,
  answered_at: null,
}

let server: ReturnType<typeof aServer>
let queue: QueueItem[]

beforeEach(() => {
  dismissToast()
  vi.stubGlobal('AudioContext', HandContext)
  queue = [alternates, single]
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', () => ({ items: queue, next: null }))
    .on('GET /v1/review-queue/count', () => ({ cues: queue.length, is_all: true }))
    .on(`GET ${TODAY}`, day())
    .on(`GET ${DRAFTS}`, { items: [], next: null })
    .on('GET /v1/sounds/a/peaks.json', somePeaks)
  for (const id of ['a', 'b', 's']) server.on(`GET /v1/sounds/${id}/preview`, aPreview)
})

const open = () => openApp(`/projects/${PROJECT}/today`)
const opened = async () => {
  const drawn = open()
  await screen.findByRole('button', { name: /^Approve / })
  return drawn
}

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
    const group = await screen.findByRole('group', { name: 'Alternates' })
    expect(within(group).getByRole('button', { name: /^B/ })).toHaveTextContent('0.80 s, −2.1 dB')
  })

  test('what blocks an approval is said before the key is pressed, of the first and of the rest', async () => {
    const why = '1 comment is not resolved'
    queue = [
      { ...alternates, blocked: [{ take_id: 'a', why }] },
      { ...single, blocked: [{ take_id: 's', why: '“No clicks” is not checked' }] },
    ]
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
    queue = [{ ...single, blocked: [{ take_id: 's', why: '1 comment is not resolved' }] }]
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
    queue = []
    server.on(`GET ${TODAY}`, day({ counts: { returned: 2, to_make: 10 } }))
    open()
    expect(await screen.findByRole('heading', { name: 'Nothing to do' })).toBeVisible()
    expect(screen.getByText('Next come what designers deliver: 2 with designers, 10 to do.')).toBeVisible()
  })

  test('a refusal is said, and can be asked again', async () => {
    server.on('GET /v1/review-queue', () => refusal(403, 'team-needed', 'Only the team has a queue.'))
    open()
    expect(await screen.findByRole('alert')).toHaveTextContent('Only the team has a queue.')
    server.on('GET /v1/review-queue', { items: queue, next: null })
    await userEvent.click(screen.getByRole('button', { name: 'Try again' }))
    expect(await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
  })

  test('axe finds nothing', async () => {
    server.on(`GET ${TODAY}`, day({ questions: [question], placeholders: 2 }))
    await opened()
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
  })
})

describe('a verdict', () => {
  test('shows at once, before the server answered, and says as what the take was seen', async () => {
    let letGo = () => undefined as void
    const reply = new Promise<object>((resolve) => {
      letGo = () => resolve({})
    })
    server.on('POST /v1/takes/b/verdict', () => reply)
    await opened()
    await userEvent.keyboard('b')
    await userEvent.keyboard('a')
    expect(await screen.findByRole('heading', { name: 'Review version 2 of suit_hit' })).toBeVisible()
    expect(screen.getByRole('status')).toHaveTextContent('shield_hit B approved.')
    queue = [single]
    letGo()
    await waitFor(() =>
      expect(server.of('POST /v1/takes/b/verdict')[0]?.body).toMatchObject({
        kind: 'approve',
        seen_state: 'conforming',
      }),
    )
  })

  test('u takes it back', async () => {
    server.on('POST /v1/takes/a/verdict', {}).on('DELETE /v1/takes/a/verdict', {})
    await opened()
    queue = [single]
    await userEvent.keyboard('a')
    await screen.findByRole('heading', { name: 'Review version 2 of suit_hit' })
    queue = [alternates, single]
    await userEvent.keyboard('u')
    expect(await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
    expect(server.of('DELETE /v1/takes/a/verdict')).toHaveLength(1)
  })

  test('what is refused comes back with its reason, and no toast says otherwise', async () => {
    server.on('POST /v1/takes/a/verdict', () =>
      refusal(409, 'stale-view', 'Since you looked, this version was set aside; nothing was changed.', {
        fix: 'Load the page again.',
      }),
    )
    await opened()
    await userEvent.keyboard('a')
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'shield_hit A is not approved. Since you looked, this version was set aside; nothing was changed. Load the page again.',
    )
    expect(await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
    expect(screen.getByRole('status')).toBeEmptyDOMElement()
  })

  test('an undo that comes too late is said', async () => {
    server
      .on('POST /v1/takes/a/verdict', {})
      .on('DELETE /v1/takes/a/verdict', () => refusal(409, 'too-late-to-undo', 'The minute is over.'))
    await opened()
    queue = [single]
    await userEvent.keyboard('a')
    await userEvent.click(await screen.findByRole('button', { name: 'Undo' }))
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'shield_hit A approved. It stays so. The minute is over.',
    )
  })

  test('those who advise are not offered it', async () => {
    server.on('GET /v1/me', aMe({ is_approver: false }))
    open()
    expect(await screen.findByText('The approver decides. You can comment.')).toBeInTheDocument()
    expect(screen.queryByRole('button', { name: /^Approve / })).toBeNull()
    await userEvent.keyboard('a')
    expect(server.asked.filter(({ method }) => method === 'POST')).toEqual([])
  })
})

describe('a change', () => {
  test('is noted by r, a digit, a line and Enter, letters typed at once included', async () => {
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('r13 dB less, at bass{Enter}')
    await waitFor(() => expect(server.of('POST /v1/takes/a/verdict')).toHaveLength(1))
    expect(server.of('POST /v1/takes/a/verdict')[0]?.body).toMatchObject({
      kind: 'request_change',
      note: 'Too loud. 3 dB less, at bass',
    })
    await waitFor(() => expect(screen.queryByRole('form')).toBeNull())
  })

  test('says what is missing when nothing was said', async () => {
    await opened()
    await userEvent.keyboard('r{Enter}')
    expect(screen.getByRole('alert')).toHaveTextContent('Choose a reason or write what to change.')
    await userEvent.keyboard('{Escape}')
    expect(screen.queryByRole('form')).toBeNull()
  })

  test('keeps what was typed when it is refused', async () => {
    server.on('POST /v1/takes/a/verdict', () => refusal(409, 'cue-is-cut', 'The cue is cut.'))
    await opened()
    await userEvent.keyboard('rmore body{Enter}')
    expect(await screen.findByRole('alert')).toHaveTextContent('The cue is cut.')
    expect(screen.getByRole('textbox', { name: 'What to change in shield_hit A' })).toHaveValue('more body')
  })

  test('drafts go out together, after saying which rounds they count', async () => {
    const drafts = [aDraft(aTake('a'), alternates.cue, 'Too loud.'), aDraft(aTake('s'), single.cue, 'More body.')]
    server
      .on(`GET ${DRAFTS}`, { items: drafts, next: null })
      .on(`POST /v1/projects/${PROJECT}/feedback`, { change_requests: drafts, rounds: [], held_back: [] })
    await opened()
    const card = await screen.findByRole('region', { name: 'Changes to send' })
    await userEvent.click(within(card).getByRole('button', { name: '2 changes to send' }))
    expect(within(card).getByRole('textbox')).toHaveFocus()
    expect(card).toHaveTextContent('This counts as one round each for shield_hit and suit_hit. You can’t undo sending.')
    expect(server.of(`POST /v1/projects/${PROJECT}/feedback`)).toEqual([])
    await userEvent.type(within(card).getByRole('textbox'), 'Good direction')
    await userEvent.click(within(card).getByRole('button', { name: 'Send 2 changes to the designer' }))
    await waitFor(() =>
      expect(server.of(`POST /v1/projects/${PROJECT}/feedback`)[0]?.body).toEqual({ note: 'Good direction' }),
    )
    expect(screen.getByRole('status')).toHaveTextContent('2 changes sent.')
  })

  test('a draft can be dropped, and why it could not is said', async () => {
    const draft = aDraft(aTake('a'), alternates.cue, 'Too loud.')
    server
      .on(`GET ${DRAFTS}`, { items: [draft], next: null })
      .on('DELETE /v1/change-requests/draft-a', () => refusal(409, 'already-sent', 'It was sent meanwhile.'))
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: 'Delete draft for shield_hit' }))
    expect(await screen.findByRole('alert')).toHaveTextContent('It was sent meanwhile.')
  })
})

describe('a question', () => {
  const answering = async () => {
    server.on(`GET ${TODAY}`, day({ questions: [question] }))
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: /coolant_splash/ }))
    await userEvent.keyboard('A spanner, into a tank{Enter}')
  }

  test('is answered in place', async () => {
    server.on('POST /v1/questions/question-1/answer', {})
    await answering()
    await waitFor(() =>
      expect(server.of('POST /v1/questions/question-1/answer')[0]?.body).toEqual({
        text: 'A spanner, into a tank',
        joins: true,
      }),
    )
    expect(await screen.findByText('Answered. It was added to the description of coolant_splash.')).toBeVisible()
  })

  test('keeps the answer when it is refused', async () => {
    server.on('POST /v1/questions/question-1/answer', () =>
      refusal(409, 'question-answered', 'It was answered already.'),
    )
    await answering()
    expect(await screen.findByRole('alert')).toHaveTextContent('It was answered already.')
    expect(screen.getByRole('textbox', { name: 'Answer for coolant_splash' })).toHaveValue('A spanner, into a tank')
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
    const tabs = screen.getByRole('navigation', { name: 'Screens' })
    expect(within(tabs).getByRole('link', { name: /^Contract\s*3/ })).toBeVisible()
    expect(within(tabs).getByRole('link', { name: /^Today\s*3/ })).toBeVisible()
  })

  test('of a producer who does not judge is no sound', async () => {
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

const waits = (cues: number, is_all = true) => ({ cues, is_all })

test.each([
  [{ cues: waits(0), questions: 0, drafts: 0, mayApprove: true, mayAnswer: true }, 'Nothing to do.'],
  [
    { cues: waits(1), questions: 0, drafts: 1, mayApprove: true, mayAnswer: true },
    'One cue waits for you. One change is drafted and not sent yet.',
  ],
  [
    { cues: waits(14), questions: 2, drafts: 0, mayApprove: false, mayAnswer: false },
    '14 cues and two questions wait for the approver.',
  ],
  [
    { cues: waits(14), questions: 2, drafts: 0, mayApprove: false, mayAnswer: true },
    'Two questions wait for you, 14 cues for the approver.',
  ],
  [
    { cues: waits(0), questions: 0, drafts: 0, mayApprove: false, mayAnswer: true, steps: 2 },
    'Two steps are yours to take.',
  ],
  [
    { cues: waits(99, false), questions: 0, drafts: 0, mayApprove: true, mayAnswer: true },
    'More than 99 cues wait for you.',
  ],
])('the headline of %o', (counts, words) => {
  expect(headline(counts)).toBe(words)
})
