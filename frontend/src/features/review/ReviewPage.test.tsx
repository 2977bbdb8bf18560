import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test } from 'vitest'

import { aDraft, aMe, APPROVER, PROJECT, somePeaks } from '@/test/review'
import { open, opened, queueIs, server, serveReviewPage, walk } from '@/test/reviewPage'
import { refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

test('references of the cue stand beside its notes, where there are any', async () => {
  const splash = {
    id: 'r1',
    project_id: PROJECT,
    cue: { id: 'shield', number: 7, name: 'shield_hit' },
    category: null,
    caption: 'The clank we mean',
    terms: '',
    words: '',
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
  await userEvent.click(await screen.findByRole('tab', { name: 'Details' }))
  await userEvent.click(await screen.findByText('1 reference'))
  const strip = await screen.findByRole('region', { name: 'References' })
  expect(within(strip).getByText('The clank we mean')).toBeTruthy()
  const asked = server.of(`GET /v1/projects/${PROJECT}/references`).map(({ query }) => query.get('cue_id'))
  expect(asked).toContain('shield')
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
    queueIs()
    open('')
    expect(await screen.findByRole('heading', { name: 'Nothing to review' })).toBeVisible()
  })

  test('a cue out of sight is said', async () => {
    server.on('GET /v1/cues/gone/review', () => refusal(404, 'cue-not-found', 'No cue of that id.'))
    open('/gone')
    expect(await screen.findByRole('alert')).toHaveTextContent('No cue of that id.')
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

describe('cutting', () => {
  beforeEach(() => {
    server.on('GET /v1/me', aMe({ is_producer: true }))
  })
  const cut = async () => {
    await opened()
    await userEvent.keyboard('.')
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

test.each(['/shield', '/walk'])('axe finds nothing in %s', { tags: ['slow'] }, async (path) => {
  await opened(path)
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
})
