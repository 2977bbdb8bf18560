import { File as NodeFile } from 'node:buffer'

import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, type Answers, refusal, serve, wrote } from '@/test/server'
import { aFix, someSounds } from '@/test/take'

const CUE = { id: 'c9', label: 'SW-009', name: 'airlock_cycle' }
const WARP = { id: 'c18', label: 'SW-018', name: 'warp_in' }
const STING = { id: 'c13', label: 'SW-013', name: 'victory_sting' }

const FINDINGS = [
  {
    check: 'head-silence',
    code: 'head-silence:over',
    severity: 'warning',
    message: '412.0 ms of silence before the sound, limit 5 ms',
    fix: 'trim 407.0 ms or more from the start',
    measured: 412,
    limit: 5,
    unit: 'ms',
    start_s: 0,
    end_s: 0.412,
  },
  {
    check: 'sample-peak',
    code: 'sample-peak:over',
    severity: 'error',
    message: 'sample peak 0.00 dBFS, limit -0.1 dBFS',
    fix: 'lower the level by 0.10 dB or more',
    measured: 0,
    limit: -0.1,
    unit: 'dBFS',
    start_s: 0.418,
    end_s: 0.418,
  },
]
const RETURNED = {
  take_id: 't9',
  cue: CUE,
  number: 1,
  variation: 1,
  file_name: 'airlock_cycle.wav',
  status: 'returned',
  since: '2026-11-17T09:00:00Z',
  duration_s: 2.412,
  thumb: null,
  preview_url: '/v1/sounds/s9/preview',
  peaks_url: '/v1/sounds/s9/peaks.json',
  findings: FINDINGS,
  changes: [],
  comments: [],
  round: null,
  limit_dbfs: -0.1,
}
const CHANGED = {
  ...RETURNED,
  take_id: 't19',
  cue: { id: 'c19', label: 'SW-019', name: 'missile_launch' },
  number: 2,
  file_name: 'missile_launch.wav',
  status: 'change_requested',
  findings: [],
  changes: [{ id: 'change-1', text: 'Thrust comes too late', start_s: 0.5, end_s: null }],
  round: 1,
}
const toMake = (cue: typeof CUE, more: object = {}) => ({
  cue,
  use: 'Own ship arrives',
  category: 'vehicle',
  duration_s: 1.4,
  loop: false,
  variations: 1,
  missing: 1,
  state: 'locked',
  status: 'to_make',
  ...more,
})
const DESK = {
  came_back: [RETURNED, CHANGED],
  to_make: [
    toMake(WARP),
    toMake({ id: 'c3', label: 'SW-003', name: 'laser_fire' }, { variations: 4, missing: 2 }),
    toMake({ id: 'c21', label: 'SW-021', name: 'void_whale' }, { state: 'concept' }),
  ],
  with_approver: [
    { id: 'c7', label: 'SW-007', name: 'shield_hit', accepted_after: '2030-03-15', silence_paused_by: null },
  ],
  came_back_next: null,
  came_back_cues: 2,
  to_make_next: null,
  to_make_cues: 3,
  with_approver_next: null,
  with_approver_cues: 1,
  with_approver_files: 3,
  accepted: 6,
  cues: 23,
  unmatched: 1,
  checking: 0,
  questions: [
    {
      id: 'q1',
      cue: { id: 'c10', label: 'SW-010', name: 'coolant_splash' },
      text: 'What falls in?',
      asked_by: { id: 'x3', name: 'Sound designer' },
      asked_at: '2026-11-12T09:00:00Z',
      answer: 'A tool.',
      answered_at: '2026-11-13T09:00:00Z',
    },
  ],
}
const aGuess = ({ id, label, name }: typeof CUE, reason: string, variation: number | null = 1, variations = 1) => ({
  cue_id: id,
  label,
  name,
  variation,
  variations,
  reason,
  becomes: variation === null ? null : `${name}.wav`,
})
const UNMATCHED = {
  id: 't30',
  project_id: 'p1',
  delivery_id: 'd3',
  designer: { id: 'x3', name: 'Sound designer' },
  cue: null,
  variation: 1,
  number: null,
  alternate: null,
  state: 'returned',
  late: false,
  file_name: 'final_FINAL_sting2.wav',
  note: '',
  master_sha256: 'a',
  master_bytes: 1000,
  received_at: '2026-11-17T09:00:00Z',
  state_since: '2026-11-17T09:00:00Z',
  guesses: [aGuess(STING, 'the name has "sting"'), aGuess(WARP, 'the name is spelt nearly alike')],
  already_here: false,
  discarded_at: null,
  sure: null,
}
const SOUNDS = {
  take_id: 't30',
  master: {
    picture_id: 's30',
    duration_s: 3.02,
    thumb: null,
    preview_url: '/v1/sounds/s30/preview',
    peaks_url: null,
    spectrum_url: null,
    state: 'drawn',
    facts: { channels: 2, sample_rate_hz: 96_000 },
    file_bytes: 1000,
  },
  renders: [],
  closed: null,
}
const DELIVERY = {
  id: 'd4',
  project_id: 'p1',
  number: 4,
  note: '',
  created_at: '2026-11-17T09:00:00Z',
  closed_at: null,
  designer: { id: 'x3', name: 'Sound designer' },
  takes_count: 0,
}
const ME = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  studios: [],
  projects: [
    {
      id: 'p1',
      name: 'Shield Wing',
      studio_id: 's1',
      studio_name: 'Shield Wing studio',
      cue_prefix: 'SW',
      part: 'designer',
      is_producer: false,
      is_liaison: false,
      is_approver: false,
      engagement_kind: 'contract',
    },
  ],
}
const cue = ({ id, label, name }: typeof CUE) => ({ id, label, name, use: '', stems: [name], cut_at: null })

let personNumber = 0
/** Uploads outlive a page for one person, so every test has another person. */
const answers = (more: Answers = {}): Answers => {
  const person = { id: `x${personNumber++}`, name: 'Sound designer' }
  return {
    'GET /v1/session': { signed_in: true, demo: false, person },
    'GET /v1/me': { ...ME, person },
    'GET /v1/projects/p1/desk': DESK,
    'GET /v1/projects/p1/spec': { tables: { accept: { containers: ['wav'] } } },
    'GET /v1/projects/p1/deliveries': { items: [], next: null },
    'GET /v1/projects/p1/takes': { items: [UNMATCHED], next: null },
    'GET /v1/projects/p1/sound-list': { revision: 7, cues: [CUE, WARP, STING].map(cue) },
    'GET /v1/takes/t30/sounds': SOUNDS,
    ...more,
  }
}
const choose = (label: string, files: NodeFile[]) => {
  const field = screen.getByLabelText(label)
  Object.defineProperty(field, 'files', { value: files, configurable: true })
  fireEvent.change(field)
}
const mp3 = (name: string) => new NodeFile(['ID3\x04 and then some'], name)

describe('what came back', () => {
  test('stands with its findings, errors first, each with figure, limit, what to do and its page', async () => {
    serve(answers())
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
      answers({
        'GET /v1/projects/p1/desk': { ...DESK, came_back: drawn.map((one) => ({ ...one, preview_url: null })) },
      }),
    )
    openApp('/desk')
    expect(await screen.findByText(/^No waveform: the file could not be read/)).toBeInTheDocument()
    given['GET /v1/projects/p1/desk'] = { ...DESK, came_back: drawn }
    expect(await screen.findByRole('slider', {}, { timeout: 3_000 })).toBeInTheDocument()
  })

  test('the next one opens by its key, with what is to change and where', async () => {
    serve(answers())
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
      answers({
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
      answers({
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
      answers({
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
    serve(answers({ 'GET /v1/projects/p1/desk': { ...DESK, came_back: [] } }))
    openApp('/desk')
    expect(await screen.findByRole('heading', { name: 'Nothing to fix.' })).toBeInTheDocument()
  })
})

const MOVED = {
  id: 'a1',
  kind: 'moved',
  done_at: '2026-11-17T09:00:00Z',
  undone_at: null,
  take_ids: ['t30'],
}
const MOVE = 'POST /v1/projects/p1/takes/move'

describe('an unmatched file', () => {
  test('is given to its likeliest cue by one key, and back by Undo', async () => {
    const { asked } = serve(
      answers({ [MOVE]: MOVED, 'POST /v1/tray-actions/a1/undo': { ...MOVED, moved_back: 1, left: 0 } }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    expect(await within(tray).findByText(/3\.02 s, stereo, 96 kHz\. Which cue is it\?/)).toBeInTheDocument()
    await user.keyboard('1')
    expect(await screen.findByText(/final_FINAL_sting2\.wav is for victory_sting/)).toBeInTheDocument()
    expect(asked.find(({ path }) => path.endsWith('/takes/move'))?.body).toEqual({
      moves: [{ take_id: 't30', cue_id: STING.id, variation: 1 }],
    })
    await user.click(screen.getByRole('button', { name: /Undo/ }))
    await waitFor(() => expect(asked.some(({ path }) => path === '/v1/tray-actions/a1/undo')).toBe(true))
  })

  test('of a set has its variation chosen by a person', async () => {
    const guess = aGuess(WARP, 'the name does not say which variation', null, 3)
    const { asked } = serve(
      answers({
        'GET /v1/projects/p1/takes': { items: [{ ...UNMATCHED, guesses: [guess] }], next: null },
        [MOVE]: MOVED,
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.click(within(tray).getByRole('button', { name: /^warp_in/ }))
    expect(asked.some(({ method, path }) => method === 'POST' && path.endsWith('/takes/move'))).toBe(false)
    await user.click(within(tray).getByRole('button', { name: 'Variation 3' }))
    await waitFor(() =>
      expect(asked.find(({ path }) => path.endsWith('/takes/move'))?.body).toEqual({
        moves: [{ take_id: 't30', cue_id: WARP.id, variation: 3 }],
      }),
    )
  })

  test('is given to another cue by searching the list', async () => {
    const { asked } = serve(answers({ [MOVE]: MOVED }))
    const user = userEvent.setup()
    openApp('/desk')
    await screen.findByRole('region', { name: 'Unmatched files' })
    await user.keyboard('/')
    const field = await screen.findByRole('combobox', { name: 'Cue for final_FINAL_sting2.wav' })
    expect(field).toHaveFocus()
    await user.type(field, 'airl')
    await user.click(await screen.findByRole('option', { name: /airlock_cycle/ }))
    await waitFor(() =>
      expect(asked.find(({ path }) => path.endsWith('/takes/move'))?.body).toEqual({
        moves: [{ take_id: 't30', cue_id: CUE.id, variation: null }],
      }),
    )
  })

  test('a refusal is said, and the guesses stay', async () => {
    serve(answers({ [MOVE]: refusal(409, 'wrong-state', 'an approved take cannot become received') }))
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.click(within(tray).getByRole('button', { name: /^warp_in/ }))
    expect(await within(tray).findByRole('alert')).toHaveTextContent('An approved take cannot become received.')
    expect(within(tray).getByRole('button', { name: /^victory_sting/ })).toBeEnabled()
  })

  test('is skipped for now where nobody knows', async () => {
    serve(answers())
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.click(within(tray).getByRole('button', { name: 'Skip for now' }))
    expect(within(tray).getByText('1 skipped for now')).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Show it' }))
    expect(within(tray).getByRole('button', { name: /^victory_sting/ })).toBeInTheDocument()
  })
})

describe('many unmatched files', () => {
  const file = (id: string, name: string, sure: ReturnType<typeof aGuess> | null = null) => ({
    ...UNMATCHED,
    id,
    file_name: name,
    sure,
    guesses: sure ? [] : UNMATCHED.guesses,
  })
  const many = (more: Answers = {}): Answers =>
    answers({
      'GET /v1/projects/p1/desk': { ...DESK, unmatched: 4 },
      'GET /v1/projects/p1/takes': {
        items: [
          file('t1', 'Warp-In FINAL2.wav', aGuess(WARP, 'the name fits no other')),
          file('t2', 'VICTORY_STING (1).wav', aGuess(STING, 'the name fits no other')),
          file('t3', 'old game/a.wav'),
          file('t4', 'old game/b.wav'),
        ],
        next: null,
      },
      ...more,
    })
  const body = (asked: { path: string; body: unknown }[], what: string) =>
    asked.find(({ path }) => path.endsWith(`/takes/${what}`))?.body

  test('sure ones are accepted at once, guesses are not among them', async () => {
    const accepted = { ...MOVED, kind: 'matched', take_ids: ['t1', 't2'] }
    const { asked } = serve(many({ 'POST /v1/projects/p1/takes/accept-sure': accepted }))
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    expect(within(tray).getByText('4 files without a cue')).toBeInTheDocument()
    expect(within(tray).getByText(/Sure: will be named warp_in\.wav\./)).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Accept 2 sure matches' }))
    expect(await screen.findByText('2 files matched.')).toBeInTheDocument()
    expect(body(asked, 'accept-sure')).toEqual({ take_ids: ['t1', 't2'] })
  })

  test('a folder goes away in one act', async () => {
    const { asked } = serve(
      many({ 'POST /v1/projects/p1/takes/discard': { ...MOVED, kind: 'discarded', take_ids: ['t3', 't4'] } }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const folder = await screen.findByRole('group', { name: 'Folder old game' })
    await user.click(within(folder).getByRole('button', { name: 'Discard folder' }))
    expect(await screen.findByText('2 files discarded; their masters are kept.')).toBeInTheDocument()
    expect(body(asked, 'discard')).toEqual({ take_ids: ['t3', 't4'] })
  })

  test('are selected by keys and moved to one cue', async () => {
    const { asked } = serve(many({ [MOVE]: { ...MOVED, take_ids: ['t2', 't3'] } }))
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.keyboard('{ArrowDown}x{Shift>}{ArrowDown}{/Shift}')
    expect(within(tray).getByText('2 selected')).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Move to…' }))
    await user.type(await screen.findByRole('combobox', { name: 'Cue for 2 files' }), 'airl')
    await user.click(await screen.findByRole('option', { name: /airlock_cycle/ }))
    await waitFor(() =>
      expect(body(asked, 'move')).toEqual({
        moves: ['t2', 't3'].map((id) => ({ take_id: id, cue_id: CUE.id, variation: null })),
      }),
    )
  })

  test('Ctrl+A selects all, x takes one out, Shift and a click select a range', async () => {
    const { asked } = serve(
      many({ 'POST /v1/projects/p1/takes/discard': { ...MOVED, kind: 'discarded', take_ids: [] } }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.keyboard('{Control>}a{/Control}')
    expect(within(tray).getByText('4 selected')).toBeInTheDocument()
    await user.keyboard('x')
    expect(within(tray).getByText('3 selected')).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Clear' }))
    await user.click(within(tray).getByRole('checkbox', { name: 'Select VICTORY_STING (1).wav' }))
    await user.keyboard('{Shift>}')
    await user.click(within(tray).getByRole('checkbox', { name: 'Select old game/b.wav' }))
    await user.keyboard('{/Shift}')
    expect(within(tray).getByText('3 selected')).toBeInTheDocument()
    const bar = within(tray).getByText('3 selected').parentElement
    await user.click(within(bar as HTMLElement).getByRole('button', { name: 'Discard' }))
    await waitFor(() => expect(body(asked, 'discard')).toEqual({ take_ids: ['t2', 't3', 't4'] }))
  })
})

describe('the fix of what came back', () => {
  const fixed = (more: Answers = {}): Answers =>
    answers({
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

test('what waits with the approver says when it counts as accepted without a verdict', async () => {
  serve(answers())
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
  serve(answers({ 'GET /v1/projects/p1/desk': { ...DESK, with_approver: waits, with_approver_cues: 3 } }))
  openApp('/desk')
  const card = await screen.findByRole('region', { name: 'In review' })
  expect(card).toHaveTextContent('alarm, bell: auto-accepted after Friday 15 March 2030 if nobody responds')
  expect(card).toHaveTextContent('chime: auto-accepted after Monday 18 March 2030 if nobody responds')
})

describe('long lists come in pages', () => {
  const paged = (more: object) => ({ ...DESK, ...more })

  test('what is to be made: the first ones, all of the first page, then page by page', async () => {
    const first = Array.from({ length: 50 }, (_, place) => toMake({ id: `m${place}`, label: '', name: `cue_${place}` }))
    const { asked } = serve(
      answers({
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
      answers({
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

describe('delivering', () => {
  test('an MP3 named .wav stays in the browser, in words', async () => {
    const { asked } = serve(answers({ 'POST /v1/projects/p1/deliveries': answer(DELIVERY, 201) }))
    openApp('/desk')
    await screen.findByRole('button', { name: 'Choose folder' })
    choose('Files to deliver', [mp3('vo_oath.wav')])
    const list = await screen.findByRole('list', { name: 'Files in this delivery' })
    expect(list).toHaveTextContent('vo_oath.wav')
    expect(list).toHaveTextContent('This is an MP3 named .wav. Export a WAV. Nothing was uploaded.')
    expect(within(list).getByText('Not uploaded')).toBeInTheDocument()
    expect(asked.some(({ path }) => path.startsWith('/v1/uploads'))).toBe(false)
    expect(screen.getByRole('heading', { name: 'Delivery 4' })).toBeInTheDocument()
  })

  test('a project that takes no files from me says so where files go', async () => {
    serve(
      answers({
        'POST /v1/projects/p1/deliveries': refusal(403, 'designer-needed', 'your engagement here has ended', {
          fix: 'ask the producer',
        }),
      }),
    )
    openApp('/desk')
    await screen.findByRole('button', { name: 'Choose folder' })
    choose('Files to deliver', [mp3('a.wav')])
    expect(await screen.findByRole('alert')).toHaveTextContent('Your engagement here has ended. Ask the producer.')
  })

  test('a thousand rows are drawn only where they are seen', async () => {
    serve(answers({ 'POST /v1/projects/p1/deliveries': answer(DELIVERY, 201) }))
    openApp('/desk')
    await screen.findByRole('button', { name: 'Choose folder' })
    choose(
      'Files to deliver',
      Array.from({ length: 1000 }, (_, index) => mp3(`take_${index}.wav`)),
    )
    const region = await screen.findByRole('region', { name: '1,000 files, scrolls' })
    expect(within(region).queryAllByRole('listitem').length).toBeLessThan(100)
  })

  test('sources are asked once for a delivery, and begin with what was stated last', async () => {
    const remembered = {
      from_scratch: false,
      own_recordings: true,
      libraries: [{ name: 'Metal Impacts 2', licence: 'single user', file: '' }],
      generated: [],
      performers: [],
      note: '',
    }
    const { asked } = serve(
      answers({
        'GET /v1/projects/p1/deliveries': { items: [DELIVERY], next: null },
        'GET /v1/deliveries/d4': { ...DELIVERY, takes: [], dry_stems: [], archives: [] },
        'GET /v1/deliveries/d4/sources': { delivery_id: 'd4', stated: null, remembered, takes: [] },
        'PUT /v1/deliveries/d4/sources': { delivery_id: 'd4', stated: null, remembered, takes: [] },
      }),
    )
    openApp('/desk')
    const part = within(await screen.findByRole('region', { name: 'Sources of delivery 4' }))
    expect(part.getByRole('button', { name: 'Same as last time' })).toBeInTheDocument()
    fireEvent.click(part.getByRole('button', { name: 'State sources' }))
    expect(await part.findByLabelText('Own recordings')).toBeChecked()
    expect(part.getByLabelText('Library')).toHaveValue('Metal Impacts 2')
    fireEvent.click(part.getByRole('button', { name: 'Add performer' }))
    fireEvent.change(part.getByLabelText('Performer'), { target: { value: 'A. Voice' } })
    fireEvent.click(part.getByRole('button', { name: 'Add generated part' }))
    fireEvent.click(part.getByRole('button', { name: 'Save sources' }))
    await waitFor(() => expect(asked.some(({ method }) => method === 'PUT')).toBe(true))
    expect(asked.find(({ method }) => method === 'PUT')?.body).toEqual({
      ...remembered,
      performers: [{ name: 'A. Voice', release: '' }],
    })
  })

  test('what the server has is shown with its state; the note is kept, and the delivery closed', async () => {
    const takes = [
      { ...UNMATCHED, id: 'a', cue: WARP, number: 1, state: 'conforming', file_name: 'warp_in.wav' },
      { ...UNMATCHED, id: 'b', cue: CUE, number: 2, state: 'returned', file_name: 'airlock_cycle.wav' },
    ]
    const { asked } = serve(
      answers({
        'GET /v1/projects/p1/deliveries': { items: [DELIVERY], next: null },
        'GET /v1/deliveries/d4': { ...DELIVERY, takes, dry_stems: [], archives: [] },
        'PATCH /v1/deliveries/d4': { ...DELIVERY, note: 'Doors.' },
        'POST /v1/deliveries/d4/close': { ...DELIVERY, closed_at: '2026-11-17T10:00:00Z' },
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const list = await screen.findByRole('list', { name: 'Files in this delivery' })
    expect(within(list).getByText('Returned')).toBeInTheDocument()
    expect(screen.getByText('1 file checked')).toBeInTheDocument()
    await user.click(within(screen.getByRole('region', { name: 'Delivery 4' })).getByRole('button', { name: 'Show' }))
    expect(await screen.findByText('warp_in.wav')).toBeInTheDocument()
    await user.type(screen.getByLabelText('Note on delivery 4'), 'Doors.')
    await user.click(screen.getByRole('button', { name: 'Close delivery' }))
    expect(await screen.findByText('Delivery 4 closed. The next file starts a new delivery.')).toBeInTheDocument()
    expect(asked.find(({ method }) => method === 'PATCH')?.body).toEqual({ note: 'Doors.' })
  })
})

describe('beside it', () => {
  test('what is to make says what is missing and what is not settled', async () => {
    serve(answers())
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
      answers({
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
    expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ text: 'How heavy is the door?' })
  })
})

test('who is of the team has no desk here', async () => {
  serve(answers({ 'GET /v1/projects/p1/desk': refusal(403, 'designer-needed', 'only its designers have a desk') }))
  openApp('/projects/p1/desk')
  expect(
    await screen.findByRole('heading', { name: 'This page is for the project’s sound designers' }),
  ).toBeInTheDocument()
})

test('whom no project engaged is told how it begins', async () => {
  serve(answers({ 'GET /v1/me': { ...ME, projects: [] } }))
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
    const { asked } = serve(answers({ [ASK]: { items: [SOUND], next: null } }))
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
    serve(answers({ [ASK]: { items: [], next: null } }))
    openApp('/desk')
    const card = await screen.findByRole('region', { name: 'Sounds by other designers' })
    await userEvent.click(within(card).getByRole('button', { name: 'Show' }))
    expect(await within(card).findByText(/The studio decides which sounds/)).toBeVisible()
  })
})
