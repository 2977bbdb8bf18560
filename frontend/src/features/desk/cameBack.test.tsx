import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { atDesk, CHANGED, CUE, DESK, FINDINGS, RETURNED, UNMATCHED, WARP } from '@/test/desk'
import { openApp } from '@/test/openApp'
import { answer, type Answers, serve, wrote } from '@/test/server'
import { aFix, someSounds } from '@/test/take'

beforeAll(() => import('./DeskPage'))

describe('what came back', () => {
  test('stands with its findings, errors first, each with figure, limit, what to do and its page', async () => {
    serve(atDesk())
    openApp('/desk')
    const card = await screen.findByRole('article', { name: 'airlock_cycle' })
    const found = within(within(card).getByRole('list', { name: 'Check results' })).getAllByRole('listitem')
    expect(found[0]).toHaveTextContent(
      /^Error: Sample peak 0\.00 dBFS\s*Limit −0\.1 dBFS\. Lower the level by 0\.10 dB or more\./,
    )
    expect(found[1]).toHaveTextContent(/^Warning: 412\.0 ms of silence before the sound\s*Limit 5 ms\./)
    expect(within(card).getByRole('link', { name: /^sample-peak/ })).toHaveAttribute('href', '/checks/sample-peak')
    expect(within(card).getByRole('slider', { name: 'Position in airlock_cycle' })).toBeInTheDocument()
  })

  test('its picture comes when it is drawn, a moment after the check', async () => {
    const drawn = [{ ...RETURNED, since: new Date().toISOString() }]
    const { answers: given } = serve(
      atDesk({
        'GET /v1/projects/p1/desk': { ...DESK, came_back: drawn.map((one) => ({ ...one, preview_url: null })) },
      }),
    )
    openApp('/desk')
    expect(await screen.findByText(/^No waveform: the file could not be read/)).toBeInTheDocument()
    given['GET /v1/projects/p1/desk'] = { ...DESK, came_back: drawn }
    expect(await screen.findByRole('slider')).toBeInTheDocument()
  })

  test('the next one opens by its key, with what is to change and where', async () => {
    serve(atDesk())
    const user = userEvent.setup()
    openApp('/desk')
    await screen.findByRole('article', { name: 'airlock_cycle' })
    await user.keyboard('j')
    const card = await screen.findByRole('article', { name: 'missile_launch' })
    expect(card).toHaveTextContent('“Thrust comes too late”')
    expect(within(card).getByRole('button', { name: '0.500 s' })).toBeInTheDocument()
    expect(within(card).getByRole('button', { name: 'Comment 1 at 0.500 seconds' })).toBeInTheDocument()
    expect(within(card).getByText('Round 1.')).toBeInTheDocument()
  })

  test('what a person asked stands before what the check found, and is answered in place', async () => {
    const both = { ...CHANGED, findings: FINDINGS }
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/desk': { ...DESK, came_back: [both] },
        'POST /v1/takes/t19/comments': answer({}, 201),
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const card = await screen.findByRole('article', { name: 'missile_launch' })
    const changes = within(card).getByRole('list', { name: 'Requested changes' })
    const findings = within(card).getByRole('list', { name: 'Check results' })
    expect(changes.compareDocumentPosition(findings)).toBe(Node.DOCUMENT_POSITION_FOLLOWING)
    await user.click(within(card).getByRole('button', { name: /^Reply\s*to the approver/ }))
    await user.keyboard('Before the flash, or with it?{Enter}')
    await waitFor(() =>
      expect(wrote(asked, 'POST /v1/takes/t19/comments')[0]?.body).toEqual({
        text: 'Before the flash, or with it?',
        change_request_id: 'change-1',
        mentions: [],
      }),
    )
  })

  test('all that a fix is enough for is fixed in one press', async () => {
    const offer = (id: string) => ({
      take_id: id,
      cue: CUE,
      variation: 1,
      number: 1,
      take_state: 'returned',
      state: 'made',
      says: 'Level lowered.',
    })
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/fixes': [offer('t9'), offer('t10'), { ...offer('t11'), state: 'making' }],
        'POST /v1/takes/t9/fix/use': answer({}, 201),
        'POST /v1/takes/t10/fix/use': answer({}, 201),
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    await user.click(await screen.findByRole('button', { name: 'Fix 2' }))
    expect(await screen.findByText(/^2 sounds fixed\./)).toBeInTheDocument()
    expect(asked.filter(({ method, path }) => method === 'POST' && path.endsWith('/fix/use'))).toHaveLength(2)
  })

  test('a check that broke is our fault, and is asked for again by one press', async () => {
    const unjudged = { ...RETURNED, status: 'unjudged', findings: [] }
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/desk': { ...DESK, came_back: [unjudged] },
        'POST /v1/takes/t9/recheck': answer({ ...UNMATCHED, id: 't9' }, 202),
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    expect(await screen.findByText(/not your file’s, and no round is counted/)).toBeInTheDocument()
    await user.click(screen.getByRole('button', { name: 'Run the check again' }))
    await waitFor(() => expect(asked.some(({ path }) => path === '/v1/takes/t9/recheck')).toBe(true))
  })

  test('nothing: said so', async () => {
    serve(atDesk({ 'GET /v1/projects/p1/desk': { ...DESK, came_back: [] } }))
    openApp('/desk')
    expect(await screen.findByRole('heading', { name: 'Nothing to fix.' })).toBeInTheDocument()
  })
})

describe('the fix of what came back', () => {
  const fixed = (more: Answers = {}): Answers =>
    atDesk({
      'GET /v1/takes/t9/fix': { ...aFix(), take_id: 't9' },
      'GET /v1/takes/t9/sounds': someSounds({ take_id: 't9' }),
      ...more,
    })

  test('stands before and after on one axis, and is used by one press', async () => {
    const { asked } = serve(
      fixed({ 'POST /v1/takes/t9/fix/use': answer({ ...UNMATCHED, id: 't10', cue: CUE, number: 2 }, 201) }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    expect(await screen.findByRole('slider', { name: 'Position in airlock_cycle, original' })).toBeInTheDocument()
    expect(screen.getByRole('slider', { name: 'Position in airlock_cycle, fixed' })).toBeInTheDocument()
    expect(screen.getByText('407.0 ms trimmed from the start, level lowered by 1.62 dB.')).toBeInTheDocument()
    expect(screen.getByText('It becomes version 2; version 1 is kept. No round is counted.')).toBeInTheDocument()
    expect(screen.getByRole('link', { name: 'All figures' })).toHaveAttribute('href', '/takes/t9')
    await user.keyboard('t')
    expect(await screen.findByText(/version 2 is the fixed copy. It is being checked/)).toBeInTheDocument()
    expect(asked.filter(({ path }) => path === '/v1/takes/t9/fix/use')).toHaveLength(1)
  })

  test('that would not be enough is not offered', async () => {
    serve(fixed({ 'GET /v1/takes/t9/fix': { ...aFix({ state: 'none' }), take_id: 't9' } }))
    openApp('/desk')
    expect(await screen.findByRole('button', { name: /^Upload new version/ })).toBeInTheDocument()
    expect(screen.queryByRole('button', { name: /^Use auto-fix/ })).not.toBeInTheDocument()
  })

  test('what only warned is listed with what a fix does, and leads to its page', async () => {
    const offer = {
      take_id: 't7',
      cue: WARP,
      variation: 2,
      number: 3,
      take_state: 'conforming',
      state: 'offered',
      says: 'Trims 45.0 ms from the start.',
    }
    serve(fixed({ 'GET /v1/projects/p1/fixes': [{ ...offer, take_id: 't9', take_state: 'returned' }, offer] }))
    openApp('/desk')
    const card = await screen.findByRole('region', { name: 'Auto-fix available' })
    expect(within(card).getAllByRole('listitem')).toHaveLength(1)
    expect(card).toHaveTextContent('warp_in_02 version 3')
    expect(card).toHaveTextContent('Trims 45.0 ms from the start.')
    expect(within(card).getByRole('link', { name: 'warp_in_02' })).toHaveAttribute('href', '/takes/t7')
  })
})
