import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import type { CueReview, QueueItem } from '@/judging/api'
import { HandContext } from '@/test/audioContext'
import {
  aDraft,
  aFinding,
  aMe,
  aNote,
  anItem,
  aPreview,
  aReview,
  aServer,
  aTake,
  APPROVER,
  PROJECT,
  somePeaks,
} from '@/test/review'
import { openApp } from '@/test/openApp'
import { answer, type Asked, refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))

const shield = anItem(
  { id: 'shield', name: 'shield_hit' },
  [aTake('a', { number: 1, findings: [aFinding()] }), aTake('b', { number: 2 })],
  { accepted_after: '2030-03-15' },
)
const walk = anItem(
  { id: 'walk', name: 'foot_deck_walk', label: 'SW-008', variations: 2 },
  [aTake('w1', { variation: 1 }), aTake('w2', { variation: 2 })],
  { accepted_after: '2030-03-15' },
)

let server: ReturnType<typeof aServer>
let queue: QueueItem[]

const serveReview = (review: CueReview) => server.on(`GET /v1/cues/${review.cue.id}/review`, review)

beforeEach(() => {
  dismissToast()
  vi.stubGlobal('AudioContext', HandContext)
  queue = [shield, walk]
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', () => ({ items: queue, next: null }))
    .on('GET /v1/review-queue/count', () => ({ cues: queue.length, is_all: true }))
    .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
    .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
    .on(`GET /v1/projects/${PROJECT}/judged-lately`, [
      {
        cue: { id: 'clamp', label: 'SW-009', name: 'dock_clamp' },
        status: 'accepted',
        since: new Date().toISOString(),
      },
    ])
  for (const id of ['a', 'b', 'w1', 'w2', 'old']) {
    server.on(`GET /v1/sounds/${id}/preview`, aPreview).on(`GET /v1/sounds/${id}/peaks.json`, somePeaks)
  }
  serveReview(aReview(shield))
  serveReview(aReview(walk))
})

const open = (path = '/shield') => openApp(`/projects/${PROJECT}/review${path}`)
const opened = async (path?: string) => {
  const drawn = open(path)
  await screen.findByRole('region', { name: 'Verdict' })
  return drawn
}
const alternate = (letter: string) =>
  within(screen.getByRole('group', { name: 'Alternates' })).getByRole('button', { name: new RegExp(`^${letter}`) })
const posts = () => server.asked.filter(({ method }) => method === 'POST')

test('references of the cue stand beside its notes, where there are any', async () => {
  const splash = {
    id: 'r1',
    project_id: PROJECT,
    cue: { id: 'shield', number: 7, name: 'shield_hit' },
    category: null,
    caption: 'The clank we mean',
    terms: '',
    start_s: null,
    end_s: null,
    added_at: '2026-11-20T10:00:00Z',
    may_change: false,
    version: {
      id: 'v1',
      number: 1,
      kind: 'link',
      media_type: 'x',
      file_name: 'example.com',
      url: 'https://example.com/clank',
      file_bytes: null,
      excerpt: '',
      preview: 'none',
      problem: '',
      width_px: null,
      height_px: null,
      added_at: '2026-11-20T10:00:00Z',
      added_by: APPROVER,
    },
  }
  server.on(`GET /v1/projects/${PROJECT}/references`, { items: [splash], next: null })
  await opened()
  await userEvent.click(await screen.findByText('1 reference'))
  const strip = await screen.findByRole('region', { name: 'References' })
  expect(within(strip).getByText('The clank we mean')).toBeTruthy()
  const [asked] = server.of(`GET /v1/projects/${PROJECT}/references`)
  expect(asked?.query.get('cue_id')).toBe('shield')
})

test('the waves of the next cue are fetched once those of the cue in hand are here', async () => {
  let answer: (peaks: unknown) => void = () => undefined
  server.on('GET /v1/sounds/a/peaks.json', () => new Promise((resolve) => (answer = resolve)))
  await opened()
  await waitFor(() => expect(server.of('GET /v1/sounds/a/peaks.json')).toHaveLength(1))
  expect(server.of('GET /v1/sounds/w1/peaks.json')).toHaveLength(0)
  answer(somePeaks)
  await waitFor(() => expect(server.of('GET /v1/sounds/w1/peaks.json')).toHaveLength(1))
  await userEvent.keyboard('j')
  expect(await screen.findByRole('heading', { name: walk.cue.name })).toBeTruthy()
  expect(server.of('GET /v1/sounds/w1/peaks.json')).toHaveLength(1)
})

describe('a version that answers a change', () => {
  const before = aTake('old', { number: 1, state: 'change_requested' })
  const after = aTake('a', { number: 2 })
  const change = { ...aDraft(before, anItem({}, []).cue, 'Add a dull clank'), sent_at: '2026-11-20T09:30:00Z' }

  beforeEach(() => {
    queue = [anItem({ id: 'shield', name: 'shield_hit' }, [after])]
    const item = anItem({ id: 'shield', name: 'shield_hit' }, [after, before])
    serveReview(aReview(item, { change_requests: [{ ...change, take_id: before.id }] }))
  })

  test('shows what was asked, and b flips to the version that it was asked of and back', async () => {
    await opened()
    const asked = await screen.findByRole('region', { name: 'What was asked of version 1' })
    expect(asked).toHaveTextContent('“Add a dull clank”')
    await userEvent.keyboard('b')
    expect(await within(asked).findByRole('button', { name: /^Back to the new version/ })).toBeVisible()
    await userEvent.keyboard('b')
    expect(await within(asked).findByRole('button', { name: /^Hear version 1/ })).toBeVisible()
  })

  test('Play stands in the bar with the verdict, for narrow pages', async () => {
    await opened()
    const bar = screen.getByRole('region', { name: 'Verdict' })
    expect(within(bar).getByText('Play')).toBeInTheDocument()
  })
})

describe('the queue', () => {
  test('without a cue the first that waits opens', async () => {
    await opened('')
    expect(screen.getByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
    const waiting = within(screen.getByRole('complementary', { name: 'Queue' }))
    expect(waiting.getByRole('link', { name: /shield_hit/ })).toHaveAttribute('aria-current')
    expect(waiting.getByRole('link', { name: /shield_hit/ })).toHaveTextContent(
      'Auto-accepted after Friday 15 March 2030 if nobody responds',
    )
    expect(waiting.getByRole('link', { name: /foot_deck_walk/ })).not.toHaveTextContent(/if nobody responds/)
    expect(await waiting.findByRole('link', { name: /dock_clamp Approved/ })).toBeVisible()
  })

  test('j and k step through it', async () => {
    await opened()
    await userEvent.keyboard('j')
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
    await userEvent.keyboard('k')
    expect(await screen.findByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
  })

  test('the next one is asked for before it is needed', async () => {
    await opened()
    await waitFor(() => expect(server.of('GET /v1/cues/walk/review')).toHaveLength(1))
    await waitFor(() => expect(server.of('GET /v1/sounds/w2/preview')).toHaveLength(1))
  })

  test('with nothing waiting it says so', async () => {
    queue = []
    open('')
    expect(await screen.findByRole('heading', { name: 'Nothing to review' })).toBeVisible()
  })

  test('a cue out of sight is said', async () => {
    server.on('GET /v1/cues/gone/review', () => refusal(404, 'cue-not-found', 'No cue of that id.'))
    open('/gone')
    expect(await screen.findByRole('alert')).toHaveTextContent('No cue of that id.')
  })
})

describe('alternates', () => {
  test('2 takes the second in the hand, a approves it, and the next cue stands there', async () => {
    server.on('POST /v1/takes/b/verdict', {})
    await opened()
    await userEvent.keyboard('2')
    expect(alternate('B')).toHaveAttribute('aria-pressed', 'true')
    queue = [walk]
    await userEvent.keyboard('a')
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
    expect(screen.getByRole('status')).toHaveTextContent('shield_hit B approved.')
    expect(server.of('POST /v1/takes/b/verdict')[0]?.body).toMatchObject({ kind: 'approve', seen_state: 'conforming' })
  })

  test('undo leads back to it', async () => {
    server.on('POST /v1/takes/a/verdict', {}).on('DELETE /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('a')
    await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })
    await userEvent.keyboard('u')
    expect(await screen.findByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
    expect(server.of('DELETE /v1/takes/a/verdict')).toHaveLength(1)
  })

  test('a refusal leads back to it and is said there', async () => {
    server.on('POST /v1/takes/a/verdict', () => refusal(409, 'stale-view', 'It was set aside meanwhile.'))
    await opened()
    await userEvent.keyboard('a')
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'shield_hit A is not approved. It was set aside meanwhile.',
    )
    expect(screen.getByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
  })

  test('heard blind, what tells them apart is hidden until d or a pick', async () => {
    await opened()
    expect(screen.getByRole('button', { name: /True peak −0.60 dBTP/ })).toBeInTheDocument()
    await userEvent.keyboard('d')
    expect(screen.queryByRole('button', { name: /True peak/ })).toBeNull()
    expect(screen.queryByRole('button', { name: /^Version/ })).toBeNull()
    expect(alternate('A')).not.toHaveTextContent('version')
    await userEvent.keyboard('d')
    expect(alternate('A')).toHaveTextContent('version 1')
  })

  test('levels are matched without a true peak over −1 dBTP, and m lets each be heard as delivered', async () => {
    const takes = [
      aTake('a', { alternate: 1, number: 1, loudness_lufs: -16, true_peak_dbtp: -3 }),
      aTake('b', { alternate: 2, number: 2, loudness_lufs: -20, true_peak_dbtp: -2 }),
    ]
    serveReview(aReview(anItem({ id: 'shield', name: 'shield_hit' }, takes)))
    await opened()
    expect(screen.getByText('matched: A −3.0 dB, B +1.0 dB')).toBeVisible()
    expect(alternate('B')).toHaveTextContent('+1.0 dB')
    await userEvent.keyboard('m')
    expect(screen.queryByText(/^matched:/)).toBeNull()
    expect(screen.getByRole('button', { name: /^Match level/ })).toHaveAttribute('aria-pressed', 'false')
  })

  test('a key chooses how it is heard, which is said and stays over cues until full range is chosen', async () => {
    await opened()
    expect(screen.getByRole('button', { name: 'Full range' })).toHaveAttribute('aria-pressed', 'false')
    fireEvent.keyDown(window, { key: '#', code: 'Digit3', shiftKey: true })
    expect(await screen.findByRole('button', { name: 'Heard as: phone' })).toHaveAttribute('aria-pressed', 'true')
    await userEvent.keyboard('j')
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
    expect(localStorage.getItem('soundlist-heard-as')).toBe('phone')
    await userEvent.click(screen.getByRole('button', { name: 'Heard as: phone' }))
    expect(await screen.findByRole('menuitem', { name: /^Phone, selected .*mono, 700 Hz to 12 kHz/ })).toBeVisible()
    await userEvent.click(screen.getByRole('menuitem', { name: /^Train/ }))
    expect(await screen.findByRole('button', { name: 'Heard as: train' })).toBeVisible()
    fireEvent.keyDown(window, { key: '!', code: 'Digit1', shiftKey: true })
    expect(await screen.findByRole('button', { name: 'Full range' })).toBeVisible()
    expect(localStorage.getItem('soundlist-heard-as')).toBeNull()
  })

  test('older versions can be heard, and get no verdict', async () => {
    const old = aTake('old', { number: 3, state: 'change_requested' })
    serveReview(aReview(shield, { takes: [...shield.takes, old] }))
    await opened()
    await userEvent.click(screen.getByRole('button', { name: /^Version 1 of 3/ }))
    await userEvent.click(await screen.findByRole('menuitem', { name: /^Version 3/ }))
    expect(await screen.findByText('A change was requested for this version.')).toBeVisible()
    expect(screen.queryByRole('button', { name: /^Approve / })).toBeNull()
    expect(screen.getByRole('slider')).toHaveAccessibleName('Position in shield_hit, version 3')
  })
})

describe('notes on earlier versions', () => {
  const old = aTake('old', { number: 1, state: 'change_requested' })
  const now = aTake('a', { number: 2 })
  const item = anItem({ id: 'shield', name: 'shield_hit' }, [now], { open_notes: 2 })
  const tail = aNote('tail', 'Tail a little shorter.', { start_s: 0.41 })
  const clank = aNote('clank', 'Add a dull metallic clank.', { kind: 'change', start_s: 0.02, end_s: 0.11 })

  test('are asked of the next one, answered by keys one after another, and counted in the queue', async () => {
    let review = aReview(item, { takes: [now, old], carried_notes: [tail, clank] })
    server.on('GET /v1/cues/shield/review', () => review)
    for (const note of [tail, clank]) {
      server.on(`POST /v1/takes/a/carried-notes/${note.id}`, ({ body }: Asked) => {
        const { is_done } = body as { is_done: boolean }
        const answer = { is_done, number: 2, given_by: APPROVER, created_at: new Date().toISOString() }
        const said = { ...note, answer }
        review = { ...review, carried_notes: review.carried_notes.map((one) => (one.id === note.id ? said : one)) }
        return said
      })
    }
    queue = [item]
    await opened()
    const carried = await screen.findByRole('region', { name: 'Carried over from earlier versions' })
    expect(carried).toHaveTextContent('0 of 2 done')
    expect(screen.getByRole('link', { name: /shield_hit/ })).toHaveTextContent('2 notes still open')
    await userEvent.keyboard('{Enter}')
    await waitFor(() => expect(carried).toHaveTextContent('1 of 2 done'))
    expect(carried).toHaveTextContent(/Done in version 2, Audio director/)
    await userEvent.keyboard('n')
    expect(await within(carried).findByText(/Still open in version 2/)).toBeVisible()
    expect(server.of('POST /v1/takes/a/carried-notes/tail')[0]?.body).toEqual({ is_done: true })
    expect(server.of('POST /v1/takes/a/carried-notes/clank')[0]?.body).toEqual({ is_done: false })
    const { violations } = await axe.run(carried, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations).toEqual([])
  })

  test('stay open with the reason when an answer is refused', async () => {
    serveReview(aReview(item, { takes: [now, old], carried_notes: [tail] }))
    server.on('POST /v1/takes/a/carried-notes/tail', () => refusal(404, 'note-not-found', 'No such note.'))
    await opened()
    await userEvent.click(screen.getByRole('button', { name: 'Done: Tail a little shorter.' }))
    expect(await screen.findByText('No such note.')).toBeVisible()
    expect(screen.getByText('0 of 1 done')).toBeVisible()
  })
})

describe('a set', () => {
  test('is accepted with one version of each variation', async () => {
    server.on('POST /v1/cues/walk/accept-set', {})
    await opened('/walk')
    await userEvent.keyboard('a')
    await waitFor(() =>
      expect(server.of('POST /v1/cues/walk/accept-set')[0]?.body).toEqual({ note: '', take_ids: ['w1', 'w2'] }),
    )
    expect(await screen.findByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
  })

  test('is played as the game does, at a rate and with pitch and level that stray, as chosen the last time', async () => {
    await opened('/walk')
    await userEvent.keyboard('{Shift>}h{/Shift}')
    const panel = await screen.findByRole('region', { name: 'How the set is played' })
    await userEvent.click(within(panel).getByRole('button', { name: '600 a minute' }))
    await userEvent.selectOptions(within(panel).getByLabelText('Pitch'), '± 2 semitones')
    await userEvent.selectOptions(within(panel).getByLabelText('Level'), '± 3 dB')
    expect(JSON.parse(localStorage.getItem('soundlist-set-way') ?? '')).toEqual({
      intervalS: 0.1,
      pitchSemitones: 2,
      levelDb: 3,
    })
    expect((await axe.run(panel, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
    await userEvent.click(within(panel).getByRole('button', { name: 'Play the set' }))
    await userEvent.click(await within(panel).findByRole('button', { name: 'Stop' }))
    await userEvent.click(within(panel).getByRole('button', { name: 'One after another' }))
    await userEvent.keyboard('{Escape}')
    expect(screen.queryByRole('region', { name: 'How the set is played' })).toBeNull()
    expect(screen.getByRole('button', { name: 'One after another' })).toHaveAttribute('aria-expanded', 'false')
    localStorage.removeItem('soundlist-set-way')
  })

  test('a noted variation keeps it from being accepted whole', async () => {
    const [w1, w2] = walk.takes
    if (!w1 || !w2) throw new Error('the set has two variations')
    serveReview(aReview({ ...walk, takes: [w1, { ...w2, draft_change: aDraft(w2, walk.cue, 'Too loud.') }] }))
    await opened('/walk')
    expect(screen.queryByRole('button', { name: 'Accept the set' })).toBeNull()
    expect(screen.getByRole('button', { name: 'Approve _01' })).toBeVisible()
  })

  test('selected variations get one change together', async () => {
    server.on('POST /v1/takes/w1/verdict', {}).on('POST /v1/takes/w2/verdict', {})
    await opened('/walk')
    await userEvent.keyboard('xb{Shift>}X{/Shift}')
    expect(screen.getByRole('button', { name: 'Approve 2 variations' })).toBeVisible()
    await userEvent.keyboard('rless scrape{Enter}')
    await waitFor(() =>
      expect(posts().map(({ path }) => path)).toEqual(['/v1/takes/w1/verdict', '/v1/takes/w2/verdict']),
    )
    expect(posts()[1]?.body).toMatchObject({ kind: 'request_change', note: 'less scrape' })
  })
})

test('what was noted last does not come again while the queue is read', async () => {
  const [w1, w2] = walk.takes
  if (!w1 || !w2) throw new Error('the set has two variations')
  let reads = 0
  server.on('GET /v1/review-queue', () =>
    reads++ === 0 ? { items: [walk], next: null } : new Promise(() => undefined),
  )
  for (const take of [w1, w2]) {
    server.on(`POST /v1/takes/${take.id}/verdict`, { draft: aDraft(take, walk.cue, 'less scrape') })
  }
  await opened('/walk')
  await userEvent.keyboard('xb{Shift>}X{/Shift}')
  await userEvent.keyboard('rless scrape{Enter}')
  expect(await screen.findByRole('heading', { name: 'Nothing to review' })).toBeVisible()
  expect(reads).toBeGreaterThan(1)
})

describe('what is said', () => {
  test('c writes at once: no letter of it is taken for a verdict', async () => {
    server.on('POST /v1/takes/a/comments', {
      id: 'c1',
      take_id: 'a',
      text: 'a clear attack',
      start_s: null,
      end_s: null,
      author: APPROVER,
      decides: true,
      created_at: '2026-11-20T10:00:00Z',
      resolved_at: null,
      mentions: [],
      acknowledgements: [],
    })
    await opened()
    await userEvent.keyboard('ca clear attack{Control>}{Enter}{/Control}')
    await waitFor(() => expect(posts()).toHaveLength(1))
    expect(posts()[0]).toMatchObject({ path: '/v1/takes/a/comments', body: { text: 'a clear attack' } })
  })

  test('stays in its field when it is refused', async () => {
    server.on('POST /v1/takes/a/comments', () => refusal(422, 'range-invalid', 'It is beyond the end of the sound.'))
    await opened()
    await userEvent.keyboard('cclear{Control>}{Enter}{/Control}')
    expect(await screen.findByRole('alert')).toHaveTextContent('It is beyond the end of the sound.')
    expect(screen.getByRole('textbox', { name: /^Comment/ })).toHaveValue('clear')
  })

  test('those who advise say which they would take, and are told who decides', async () => {
    serveReview(aReview(shield, { may_approve: false }))
    server.on('POST /v1/takes/a/comments', { id: 'c1', take_id: 'a' })
    await opened()
    expect(screen.getByText('You can comment. Audio director approves.')).toBeVisible()
    expect(screen.queryByRole('button', { name: /^Approve |^Request/ })).toBeNull()
    await userEvent.keyboard('a')
    await waitFor(() => expect(posts()).toHaveLength(1))
    expect(posts()[0]).toMatchObject({ path: '/v1/takes/a/comments', body: { text: 'I’d pick A.' } })
  })

  test('a deputy sees for whom they decide, and everybody else who may', async () => {
    serveReview(aReview(shield, { deputies: [{ id: 'x1', name: 'Producer' }], on_behalf_of: APPROVER }))
    await opened()
    expect(screen.getByText(/^Your call, for Audio director\./)).toBeVisible()
  })

  test('who advises sees the deputy too', async () => {
    serveReview(aReview(shield, { deputies: [{ id: 'x1', name: 'Producer' }], may_approve: false }))
    await opened()
    expect(screen.getByText('You can comment. Audio director or Producer approves.')).toBeVisible()
  })

  test('findings stand in their tab with the limit and what to do', async () => {
    await opened()
    await userEvent.click(screen.getByRole('tab', { name: 'Findings 1' }))
    const finding = screen.getByRole('article', { name: 'True peak −0.60 dBTP, limit −1 dBTP' })
    expect(finding).toHaveTextContent('Lower the level by 0.40 dB or more.')
    expect(within(finding).getByRole('button', { name: 'Go to position' })).toBeVisible()
  })
})

describe('a version that came back', () => {
  const came = aTake('a', {
    state: 'returned',
    findings: [aFinding({ severity: 'error', message: 'sample peak 0.00 dBFS, limit -0.1 dBFS' })],
  })

  test('is let through by the approver alone, with a reason', async () => {
    serveReview(aReview(shield, { takes: [came] }))
    server.on('POST /v1/takes/a/waiver', {})
    await opened()
    await userEvent.click(screen.getByRole('tab', { name: 'Findings 1' }))
    const through = screen.getByRole('button', { name: 'Waive version 1' })
    expect(through).toBeDisabled()
    await userEvent.type(screen.getByRole('textbox', { name: 'Waive the findings: reason' }), 'meant to clip')
    await userEvent.click(through)
    await waitFor(() => expect(posts()).toHaveLength(1))
    expect(posts()[0]).toMatchObject({ path: '/v1/takes/a/waiver', body: { reason: 'meant to clip' } })
  })

  test('is not offered to those who advise', async () => {
    serveReview(aReview(shield, { takes: [came], may_approve: false }))
    await opened()
    await userEvent.click(screen.getByRole('tab', { name: 'Findings 1' }))
    expect(screen.queryByRole('button', { name: /through/ })).toBeNull()
  })
})

describe('what a pick makes due', () => {
  const MONEY = {
    contract_id: 'contract',
    currency: 'USD',
    milestone: 'Alpha',
    amount_minor: 18_000,
    would_owe_minor: 18_000,
    accepted: 3,
    accepted_then: 4,
    wanted: 10,
    rounds_included: 2,
    extra_round_minor: 4_500,
    extra_rounds: [],
  }
  const bar = () => screen.getByRole('region', { name: 'Verdict' })
  const asked = () => server.of('GET /v1/cues/shield/money')

  test('is said to a producer', async () => {
    server.on('GET /v1/me', aMe({ is_producer: true })).on('GET /v1/cues/shield/money', MONEY)
    await opened()
    await waitFor(() => expect(bar()).toHaveTextContent('$180.00 is due then, and Alpha is 4 of 10.'))
  })

  test('is no sum where it is due once the milestone is whole', async () => {
    server
      .on('GET /v1/me', aMe({ is_producer: true }))
      .on('GET /v1/cues/shield/money', { ...MONEY, would_owe_minor: 0 })
    await opened()
    await waitFor(() => expect(bar()).toHaveTextContent('Alpha is 4 of 10 then.'))
    expect(bar()).not.toHaveTextContent('$')
  })

  test('is nothing more for a cue that is accepted already, or that no contract covers', async () => {
    const settled = { ...MONEY, would_owe_minor: 0, accepted_then: 3 }
    server.on('GET /v1/me', aMe({ is_producer: true })).on('GET /v1/cues/shield/money', settled)
    server.on('GET /v1/cues/walk/money', answer(null))
    await opened()
    await waitFor(() => expect(asked()).toHaveLength(1))
    expect(bar()).not.toHaveTextContent('Alpha')
    await userEvent.keyboard('j')
    await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })
    await waitFor(() => expect(server.of('GET /v1/cues/walk/money')).toHaveLength(1))
    expect(bar()).toHaveTextContent('Approves all 2 variations at once.')
    expect(bar()).not.toHaveTextContent('due')
  })

  test('waits for the whole set', async () => {
    const one = aReview({ ...walk, takes: walk.takes.slice(0, 1) })
    serveReview(one)
    server.on('GET /v1/me', aMe({ is_producer: true })).on('GET /v1/cues/walk/money', MONEY)
    await opened('/walk')
    await waitFor(() => expect(server.of('GET /v1/cues/walk/money')).toHaveLength(1))
    expect(await screen.findByText('1 variation of the set is missing.')).toBeVisible()
    expect(bar()).not.toHaveTextContent('due')
  })

  test('is not even asked for by who decides without sight of money', async () => {
    server.on('GET /v1/cues/shield/money', MONEY)
    await opened()
    expect(bar()).toHaveTextContent('Your call.')
    expect(bar()).not.toHaveTextContent('$')
    expect(asked()).toEqual([])
  })
})

describe('cutting', () => {
  beforeEach(() => {
    server.on('GET /v1/me', aMe({ is_producer: true }))
  })
  const cut = async () => {
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: 'More for shield_hit' }))
    await userEvent.click(await screen.findByRole('menuitem', { name: 'Cut this cue' }))
    expect(await screen.findByRole('textbox', { name: 'Why cut shield_hit?' })).toHaveFocus()
    // As slowly as a closing menu takes to put the focus elsewhere: each letter of it would be a shortcut there.
    await userEvent.setup({ delay: 5 }).keyboard('No shields any more')
    await userEvent.click(screen.getByRole('button', { name: 'Cut shield_hit' }))
  }

  test('takes a reason, and goes on to the next', async () => {
    server.on('POST /v1/cues/shield/cut', {})
    await cut()
    await waitFor(() =>
      expect(server.of('POST /v1/cues/shield/cut')[0]?.body).toEqual({ reason: 'No shields any more' }),
    )
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
  })

  test('keeps the reason when it is refused', async () => {
    server.on('POST /v1/cues/shield/cut', () => refusal(409, 'cue-is-cut', 'The cue is cut already.'))
    await cut()
    expect(await screen.findByRole('alert')).toHaveTextContent('The cue is cut already.')
    expect(screen.getByRole('textbox', { name: 'Why cut shield_hit?' })).toHaveValue('No shields any more')
  })
})

test.each(['/shield', '/walk'])('axe finds nothing in %s', async (path) => {
  await opened(path)
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
})
