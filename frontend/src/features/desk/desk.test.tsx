import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { atDesk, CHANGED, CUE, DESK, ME, RETURNED, STING, toMake, UNMATCHED, WARP } from '@/test/desk'
import { openApp } from '@/test/openApp'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

beforeAll(() => import('./DeskPage'))

test('what waits with the approver says when it counts as accepted without a verdict', async () => {
  serve(atDesk())
  openApp('/desk')
  const card = await screen.findByRole('region', { name: 'In review' })
  expect(card).toHaveTextContent('shield_hit: auto-accepted after Friday 15 March 2030 if nobody responds')
})

test('cues that wait until the same day are told in one line', async () => {
  const waiting = (name: string, day: string | null) => ({
    id: name,
    label: name,
    name,
    accepted_after: day,
    silence_paused_by: null,
  })
  const waits = [waiting('alarm', '2030-03-15'), waiting('bell', '2030-03-15'), waiting('chime', '2030-03-18')]
  serve(atDesk({ 'GET /v1/projects/p1/desk': { ...DESK, with_approver: waits, with_approver_cues: 3 } }))
  openApp('/desk')
  const card = await screen.findByRole('region', { name: 'In review' })
  expect(card).toHaveTextContent('alarm, bell: auto-accepted after Friday 15 March 2030 if nobody responds')
  expect(card).toHaveTextContent('chime: auto-accepted after Monday 18 March 2030 if nobody responds')
})

describe('the approved versions', () => {
  const aTake = { ...UNMATCHED, cue: CUE, number: 2, state: 'approved' }
  const TAKES = 'GET /v1/projects/p1/takes'
  const show = async () => {
    openApp('/desk')
    await userEvent.click(await screen.findByRole('button', { name: 'Show approved versions' }))
    return screen.findByRole('list', { name: 'Approved versions' })
  }
  /** Answers the list of approved takes; the tray reads its own by the same address. */
  const approved = (page: (cursor: string | null) => { items: object[]; next: string | null }) => ({
    [TAKES]: ({ query }: Asked) =>
      answer(query.get('state') === 'approved' ? page(query.get('cursor')) : { items: [UNMATCHED], next: null }),
  })

  test('are listed with their labels and why each was chosen, once they are asked for', async () => {
    const because = ['Fits the scene', 'Best timing']
    const first = { ...aTake, id: 't1', label: 'longer', verdict_reasons: because }
    const second = { ...aTake, id: 't2', cue: WARP, variation: 3, number: 1 }
    const { asked } = serve(atDesk(approved(() => ({ items: [first, second], next: null }))))
    const list = await show()
    await waitFor(() => expect(within(list).getAllByRole('listitem')).toHaveLength(2))
    const said = within(list)
      .getAllByRole('listitem')
      .map(({ textContent }) => textContent)
    expect(said).toEqual(['airlock_cycle version 2, longerFits the scene. Best timing.', 'warp_in_03 version 1'])
    expect(within(list).getByRole('link', { name: 'airlock_cycle' })).toHaveAttribute('href', '/takes/t1')
    const read = asked.filter(({ path, query }) => path.endsWith('/takes') && query.get('state') === 'approved')
    expect(read).toHaveLength(1)
    await userEvent.click(screen.getByRole('button', { name: 'Hide approved versions' }))
    expect(list).not.toBeInTheDocument()
  })

  test('come in pages', async () => {
    const first = { items: [{ ...aTake, id: 't1' }], next: 'more' }
    const last = { items: [{ ...aTake, id: 't2', cue: WARP }], next: null }
    serve(atDesk(approved((cursor) => (cursor === 'more' ? last : first))))
    const list = await show()
    await userEvent.click(await screen.findByRole('button', { name: 'More approved versions' }))
    expect(await within(list).findByRole('link', { name: 'warp_in' })).toBeVisible()
    expect(screen.queryByRole('button', { name: 'More approved versions' })).toBeNull()
  })

  test('of a designer without any are said to be none', async () => {
    serve(atDesk(approved(() => ({ items: [], next: null }))))
    await show()
    expect(await screen.findByText('No version of yours is approved yet.')).toBeVisible()
  })
})

describe('long lists come in pages', () => {
  const paged = (more: object) => ({ ...DESK, ...more })

  test('what is to be made: the first ones, all of the first page, then page by page', { tags: ['slow'] }, async () => {
    const first = Array.from({ length: 50 }, (_, place) => toMake({ id: `m${place}`, label: '', name: `cue_${place}` }))
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/desk': paged({ to_make: first, to_make_next: '50.50', to_make_cues: 51 }),
        'GET /v1/projects/p1/desk/to-make': { items: [toMake({ id: 'm50', label: '', name: 'the_last' })], next: null },
      }),
    )
    openApp('/desk')
    const card = await screen.findByRole('region', { name: /^To do/ })
    expect(card).toHaveTextContent('51')
    expect(within(card).getAllByRole('listitem')).toHaveLength(14)
    expect(within(card).getByRole('link', { name: 'REAPER project of what is owed' })).toHaveAttribute(
      'href',
      '/v1/projects/p1/desk/sounds.rpp',
    )
    expect(within(card).getByRole('link', { name: 'Delivery spec as a PDF' })).toHaveAttribute(
      'href',
      '/v1/projects/p1/spec.pdf',
    )
    await userEvent.click(within(card).getByRole('button', { name: 'Show more' }))
    expect(within(card).getAllByRole('listitem')).toHaveLength(50)
    await userEvent.click(within(card).getByRole('button', { name: 'Show more' }))
    await within(card).findByText('the_last')
    expect(within(card).queryByRole('button', { name: 'Show more' })).toBeNull()
    expect(wrote(asked, 'GET /v1/projects/p1/desk/to-make')).toHaveLength(1)
  })

  test('what came back: the key for the next one asks for the page after the last', async () => {
    serve(
      atDesk({
        'GET /v1/projects/p1/desk': paged({ came_back: [RETURNED], came_back_next: 'x', came_back_cues: 900 }),
        'GET /v1/projects/p1/desk/came-back': { items: [CHANGED], next: null },
      }),
    )
    openApp('/desk')
    await screen.findByRole('button', { name: 'More to fix' })
    expect(screen.getByText(/900 cues to fix/)).toBeInTheDocument()
    await userEvent.keyboard('j')
    await screen.findByRole('button', { name: 'Open missile_launch' })
    expect(screen.queryByRole('button', { name: 'More to fix' })).toBeNull()
  })
})

describe('beside it', () => {
  test('what is to make says what is missing and what is not settled', async () => {
    serve(atDesk())
    openApp('/desk')
    const card = await screen.findByRole('region', { name: 'To do' })
    const [warp, laser, whale] = within(card).getAllByRole('listitem')
    expect(warp).toHaveTextContent('warp_in')
    expect(laser).toHaveTextContent('2 of 4 missing')
    expect(whale).toHaveTextContent('not final; ask before you start')
    expect(within(card).getByRole('button', { name: 'Choose files for warp_in' })).toBeInTheDocument()
    expect(screen.getByText('1 cue, 3 files')).toBeInTheDocument()
  })

  test('a question goes to the cue in the hand unless told otherwise; empty ones are not sent', async () => {
    const { asked } = serve(
      atDesk({
        'POST /v1/cues/c9/questions': answer({ ...DESK.questions[0], cue_id: 'c9', cue_name: 'airlock_cycle' }, 201),
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    expect(await screen.findByText('A tool.')).toBeInTheDocument()
    await user.keyboard('q')
    const field = await screen.findByRole('textbox', { name: 'Question' })
    expect(field).toHaveFocus()
    await user.click(screen.getByRole('button', { name: 'Send question' }))
    expect(await screen.findByText('Write your question.')).toBeInTheDocument()
    expect(asked.some(({ method }) => method === 'POST')).toBe(false)
    await user.type(field, 'How heavy is the door?')
    await user.click(screen.getByRole('button', { name: 'Send question' }))
    expect(await screen.findByText(/Question about airlock_cycle/)).toBeInTheDocument()
    expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({
      text: 'How heavy is the door?',
      blocks: false,
    })
  })
})

test('where as many answers came as the desk brings, it says where the earlier ones are', async () => {
  const questions = Array.from({ length: 20 }, (_, place) => ({ ...DESK.questions[0], id: `q${place}` }))
  serve(atDesk({ 'GET /v1/projects/p1/desk': { ...DESK, questions } }))
  openApp('/projects/p1/desk')
  expect(await screen.findByText('Earlier answers are with their cues.')).toBeInTheDocument()
})

test('who is of the team has no desk here', async () => {
  serve(atDesk({ 'GET /v1/projects/p1/desk': refusal(403, 'designer-needed', 'only its designers have a desk') }))
  openApp('/projects/p1/desk')
  expect(
    await screen.findByRole('heading', { name: 'This page is for the project’s sound designers' }),
  ).toBeInTheDocument()
})

test('whom no project engaged is told how it begins', async () => {
  serve(atDesk({ 'GET /v1/me': { ...ME, projects: [] } }))
  openApp('/desk')
  expect(
    await screen.findByRole('heading', { name: 'You are not a sound designer in any project yet.' }),
  ).toBeInTheDocument()
})

describe('sounds by other designers', () => {
  const SOUND = {
    id: 't77',
    cue: STING,
    category: 'music',
    variation: 2,
    variations: 3,
    is_palette: true,
    is_approved: true,
    picture_id: 's77',
    duration_s: 3.02,
    thumb: null,
    preview_url: '/v1/sounds/s77/preview',
    peaks_url: null,
    spectrum_url: null,
  }
  const ASK = 'GET /v1/projects/p1/other-sounds'

  test('are read once asked for, and named by their cue', async () => {
    const { asked } = serve(atDesk({ [ASK]: { items: [SOUND], next: null } }))
    openApp('/desk')
    const card = await screen.findByRole('region', { name: 'Sounds by other designers' })
    expect(asked.some(({ path }) => path.endsWith('/other-sounds'))).toBe(false)
    await userEvent.click(within(card).getByRole('button', { name: 'Show' }))
    const list = await within(card).findByRole('list', { name: 'Sounds by other designers' })
    expect(await within(list).findByRole('button', { name: 'Play victory_sting, variation 2' })).toBeEnabled()
    expect(within(list).getByText('music, palette')).toBeVisible()
    expect(within(list).getByText('Approved')).toBeVisible()
  })

  test('none: who decides is said', async () => {
    serve(atDesk({ [ASK]: { items: [], next: null } }))
    openApp('/desk')
    const card = await screen.findByRole('region', { name: 'Sounds by other designers' })
    await userEvent.click(within(card).getByRole('button', { name: 'Show' }))
    expect(await within(card).findByText(/The studio decides which sounds/)).toBeVisible()
  })
})
