import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { describe, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

const span = (text: string) => ({ text, strong: false, emphatic: false })
const block = (kind: 'head' | 'text' | 'item', text: string, level = 0) => ({
  kind,
  level,
  spans: [span(text)],
  rows: [],
})
const CLAUSES = [
  { key: 'rounds', title: 'Rounds', text: 'It includes {rounds_included} rounds.', stands: true },
  { key: 'bonus', title: 'Bonus', text: 'A bonus.', stands: false },
]
const VERSION = {
  number: 2,
  note: '',
  author: { id: 'x1', name: 'Producer' },
  created_at: '2026-11-20T09:00:00Z',
  sent_at: '2026-11-20T10:00:00Z',
  text_sha256: 'a'.repeat(64),
  pdf_sha256: 'b'.repeat(64),
  blocks: [block('head', 'Effects', 1), block('head', '1. Rounds', 2), block('text', 'It includes 2 rounds.')],
  clauses: CLAUSES,
  terms: { rounds_included: 2 },
}
const MAY = { change: false, send: false, recall: false, request_change: false, accept: false, end: false }
const CONTRACT = {
  id: 'c1',
  project_id: 'p1',
  number: 1,
  title: 'Effects for Alpha',
  kind: 'single',
  state: 'sent',
  designer: { id: 'x3', name: 'Sound designer' },
  engagement_id: 'e1',
  framework_id: null,
  currency: 'USD',
  release_clause: 'per_cue',
  deposit_bp: 2000,
  holdback_bp: 0,
  created_at: '2026-11-19T09:00:00Z',
  agreed_at: null,
  ended_at: null,
  end_reason: null,
  my_party: 'designer',
  waits_for: ['studio', 'designer'],
  studio_name: 'Shield Wing studio',
  version: VERSION,
  acceptances: [],
  signers: [],
  signs_first: null,
  change_requested: null,
  may: { ...MAY, request_change: true, accept: true, end: true },
}
const PROJECT = {
  id: 'p1',
  name: 'Shield Wing',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  part: 'designer',
  cue_prefix: 'SW',
  is_producer: false,
  engagement_kind: 'contract',
}
const ME = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  studios: [],
  projects: [PROJECT],
}
const given = (more: Answers = {}): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: ME.person },
  'GET /v1/me': ME,
  'GET /v1/contracts/c1': CONTRACT,
  'GET /v1/contracts/c1/versions': [VERSION, { ...VERSION, number: 1 }],
  ...more,
})
const PAGE = '/projects/p1/contracts/c1'

describe('a designer', () => {
  test('reads the text and accepts the version that was read, under a name', async () => {
    const { asked, answers } = serve(given())
    const agreed = { ...CONTRACT, waits_for: ['studio'], may: MAY }
    answers['POST /v1/contracts/c1/accept'] = { ...agreed, acceptances: [accepted('designer', 'N. Designer')] }
    openApp(PAGE)
    expect(await screen.findByText('It includes 2 rounds.')).toBeVisible()
    expect(screen.getByText(/^SHA-256 a+$/)).toBeVisible()
    const form = within(screen.getByRole('form', { name: 'Accept' }))
    expect(form.getByRole('button', { name: 'Sign version 2' })).toBeDisabled()
    await userEvent.type(form.getByLabelText('Your full name'), 'N. Designer')
    await userEvent.click(form.getByRole('button', { name: 'Sign version 2' }))
    expect(await screen.findByText('for the designer, n@sound.example, email not verified')).toBeVisible()
    const sent = asked.find(({ path }) => path.endsWith('/accept'))
    expect(sent?.body).toEqual({ name: 'N. Designer', text_sha256: 'a'.repeat(64) })
    expect(screen.getByText('Waiting for the studio to sign')).toBeVisible()
  })

  test('draws a name, undoes a stroke, and sends what is left with the typed name', async () => {
    const { asked, answers } = serve(given())
    const drawing = [[[100, 30]]]
    const signed = { ...accepted('designer', 'N. Designer'), drawing }
    answers['POST /v1/contracts/c1/accept'] = { ...CONTRACT, waits_for: ['studio'], may: MAY, acceptances: [signed] }
    openApp(PAGE)
    const form = within(await screen.findByRole('form', { name: 'Accept' }))
    const field = form.getByRole('img', { name: /^Draw your name/ })
    field.getBoundingClientRect = () => new DOMRect(0, 0, 500, 150)
    field.setPointerCapture = vi.fn()
    field.hasPointerCapture = () => true
    fireEvent.pointerDown(field, { clientX: 50, clientY: 15, button: 0 })
    fireEvent.pointerDown(field, { clientX: 100, clientY: 15, button: 0 })
    fireEvent.pointerMove(field, { clientX: 300, clientY: 900 })
    expect(field.querySelector('path')).toHaveAttribute('d', 'M 100 30 L 100 30 M 200 30 L 600 300')
    await userEvent.click(form.getByRole('button', { name: 'Undo stroke' }))
    await userEvent.type(form.getByLabelText('Your full name'), 'N. Designer')
    await userEvent.click(form.getByRole('button', { name: 'Sign version 2' }))
    expect(await screen.findByRole('img', { name: 'N. Designer, drawn by hand' })).toBeVisible()
    expect(asked.find(({ path }) => path.endsWith('/accept'))?.body).toEqual({
      name: 'N. Designer',
      text_sha256: 'a'.repeat(64),
      drawing,
    })
  })

  test('a drawing that is refused stays to be drawn again', async () => {
    const refused = refusal(422, 'bad-drawing', 'the drawing is too small to be a name', { fix: 'clear it' })
    serve(given({ 'POST /v1/contracts/c1/accept': refused }))
    openApp(PAGE)
    const form = within(await screen.findByRole('form', { name: 'Accept' }))
    const field = form.getByRole('img', { name: /^Draw your name/ })
    field.getBoundingClientRect = () => new DOMRect(0, 0, 1000, 300)
    field.setPointerCapture = vi.fn()
    fireEvent.pointerDown(field, { clientX: 50, clientY: 15, button: 0 })
    await userEvent.type(form.getByLabelText('Your full name'), 'N. Designer{Enter}')
    expect(await form.findByText('The drawing is too small to be a name.')).toBeVisible()
    expect(field.querySelector('path')).toHaveAttribute('d', 'M 50 15 L 50 15')
    await userEvent.click(form.getByRole('button', { name: 'Clear drawing' }))
    expect(field.querySelector('path')).toHaveAttribute('d', '')
    expect(form.getByLabelText('Your full name')).toHaveValue('N. Designer')
  })

  test('signs with the code that is mailed, and has another one mailed', async () => {
    const needed = refusal(403, 'signing-code-needed', 'a code is mailed to you; nothing was signed')
    const mailed = { email: 'n@sound.example', expires_at: '2026-11-20T10:10:00Z', tries: 5 }
    const { asked, answers } = serve(
      given({ 'POST /v1/contracts/c1/accept': needed, 'POST /v1/contracts/c1/signing-codes': mailed }),
    )
    openApp(PAGE)
    await userEvent.type(await screen.findByLabelText('Your full name'), 'N. Designer{Enter}')
    const code = await screen.findByLabelText('Code')
    await waitFor(() => expect(code).toHaveFocus())
    expect(code).toHaveAccessibleDescription(/^Mailed to n@sound.example/)
    expect(screen.queryByText(/nothing was signed/)).not.toBeInTheDocument()
    answers['POST /v1/contracts/c1/accept'] = refusal(403, 'wrong-signing-code', 'it can be tried 4 more times')
    await userEvent.type(code, '111111{Enter}')
    expect(await screen.findByText('It can be tried 4 more times.')).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Mail another code' }))
    await waitFor(() => expect(code).toHaveValue(''))
    const signed = { ...accepted('designer', 'N. Designer'), code_entered_at: '2026-11-20T10:05:00Z' }
    answers['POST /v1/contracts/c1/accept'] = { ...CONTRACT, waits_for: ['studio'], may: MAY, acceptances: [signed] }
    await userEvent.type(code, '482913{Enter}')
    expect(await screen.findByText('for the designer, n@sound.example, confirmed by a mailed code')).toBeVisible()
    expect(asked.filter(({ path }) => path.endsWith('/signing-codes')).map(({ body }) => body)).toEqual([
      { text_sha256: 'a'.repeat(64) },
      { text_sha256: 'a'.repeat(64) },
    ])
    expect(asked.filter(({ path }) => path.endsWith('/accept')).at(-1)?.body).toEqual({
      name: 'N. Designer',
      text_sha256: 'a'.repeat(64),
      code: '482913',
    })
  })

  test('sees who signs for the studio, and which side is first', async () => {
    serve(
      given({
        'GET /v1/contracts/c1': { ...CONTRACT, signers: [{ id: 'x1', name: 'Producer' }], signs_first: 'studio' },
      }),
    )
    openApp(PAGE)
    expect(await screen.findByText('1. Producer, for the studio')).toBeVisible()
    expect(screen.getByText('The studio signs first.')).toBeVisible()
  })

  test('is told when the text moved on meanwhile, and keeps the name typed', async () => {
    const detail = 'the text that you read is not the one that stands now; nothing was accepted'
    serve(given({ 'POST /v1/contracts/c1/accept': refusal(409, 'text-changed', detail) }))
    openApp(PAGE)
    const name = await screen.findByLabelText('Your full name')
    await userEvent.type(name, 'N. Designer{Enter}')
    expect(await screen.findByText(/nothing was accepted\.$/)).toBeVisible()
    expect(name).toHaveValue('N. Designer')
  })

  test('sends it back with what they want otherwise', async () => {
    const { asked } = serve(
      given({ 'POST /v1/contracts/c1/ask-change': { ...CONTRACT, state: 'draft', waits_for: ['studio'], may: MAY } }),
    )
    openApp(PAGE)
    const form = within(await screen.findByRole('form', { name: 'Request a change' }))
    await userEvent.type(form.getByLabelText('Requested change'), 'One round.')
    await userEvent.click(form.getByRole('button', { name: 'Request change' }))
    expect(await screen.findByText('Draft, with the studio')).toBeVisible()
    expect(asked.find(({ path }) => path.endsWith('/ask-change'))?.body).toEqual({
      text: 'One round.',
      clause_key: null,
    })
  })

  test('reads the milestones of a fixed plan in words', async () => {
    const plan = [
      { name: 'First batch', amount: '1,200.00 EUR', due_on: '2026-12-01', cues: 3 },
      { name: 'Second batch', amount: '800.00 EUR', due_on: '', cues: 2 },
    ]
    const entry = { ...ENTRY, kind: 'planned', payload: { milestones: plan } }
    const record = {
      contract_id: 'c1',
      title: 'Effects',
      length: 1,
      sha256: 'c'.repeat(64),
      entries: [entry],
      faults: [],
    }
    serve(given({ 'GET /v1/contracts/c1/record': record }))
    openApp(`${PAGE}/record`)
    expect(
      await screen.findByText(
        'First batch, amount 1,200.00 EUR, due on 2026-12-01, cues 3; Second batch, amount 800.00 EUR, cues 2',
      ),
    ).toBeVisible()
  })

  test('keeps a copy of the record, and sees when it is not whole', async () => {
    const record = { contract_id: 'c1', title: 'Effects', length: 1, sha256: 'c'.repeat(64), entries: [ENTRY] }
    serve(given({ 'GET /v1/contracts/c1/record': { ...record, faults: ['entry 1 was altered'] } }))
    openApp(`${PAGE}/record`)
    expect(await screen.findByText(/Entry 1 was altered\./)).toBeVisible()
    expect(screen.getByText('Sent to both parties')).toBeVisible()
    const copy = screen.getByRole('link', { name: 'Download a copy' })
    expect(copy).toHaveAttribute('href', '/v1/contracts/c1/record.json')
  })

  test.each([
    ['with entries', 1, []],
    ['with a fault', 1, ['entry 1 was altered']],
    ['before anything was sent', 0, []],
  ])('axe finds nothing in a record %s', async (_, length, faults) => {
    const entries = length === 0 ? [] : [ENTRY, { ...ENTRY, seq: 2, kind: 'agreed', payload: { deposit_bp: 2000 } }]
    const record = {
      contract_id: 'c1',
      title: 'Effects',
      length: entries.length,
      sha256: 'c'.repeat(64),
      entries,
      faults,
    }
    serve(given({ 'GET /v1/contracts/c1/record': record }))
    openApp(`${PAGE}/record`)
    expect(await screen.findByRole('heading', { name: /^Entries/ })).toBeVisible()
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
  })
})

describe('before the NDA is agreed', () => {
  const closed = { ...ME, projects: [{ ...PROJECT, nda_open: true }] }
  const nda = { ...CONTRACT, kind: 'nda', title: 'NDA' }
  const found = (contracts: object[]) =>
    serve(given({ 'GET /v1/me': closed, 'GET /v1/projects/p1/contracts': contracts }))

  test.each(['', '/desk', '/sound-list', '/spec', '/money', '/game-files'])(
    'a designer is told to read it in the place of projects/p1%s',
    async (page) => {
      const { asked } = found([nda])
      openApp(`/projects/p1${page}`)
      expect(
        await screen.findByRole('heading', { name: 'Read and sign the NDA to see this project', level: 1 }),
      ).toBeVisible()
      expect(screen.queryByRole('alert')).toBeNull()
      const ofProject = asked.map(({ path }) => path).filter((path) => path.startsWith('/v1/projects/'))
      expect(new Set(ofProject)).toEqual(new Set(['/v1/projects/p1/contracts', '/v1/projects/p1/next-steps']))
    },
  )

  test('the button opens its text, and accepting it opens the project', async () => {
    const { answers } = found([nda])
    answers['GET /v1/contracts/c1'] = nda
    answers['POST /v1/contracts/c1/accept'] = { ...nda, state: 'agreed', waits_for: [], may: MAY }
    const app = openApp('/projects/p1/desk')
    const read = await screen.findByRole('button', { name: 'Read the NDA' })
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
    await userEvent.click(read)
    expect(await screen.findByText('It includes 2 rounds.')).toBeVisible()
    expect(app.at()).toBe(PAGE)
    answers['GET /v1/me'] = ME
    await userEvent.type(screen.getByLabelText('Your full name'), 'N. Designer{Enter}')
    await screen.findByText('Agreed')
    await userEvent.click(screen.getByRole('link', { name: /Sound list/ }))
    expect(app.at()).toBe('/projects/p1/sound-list')
    expect(screen.queryByRole('heading', { name: 'Read and sign the NDA to see this project' })).toBeNull()
  })

  test('who accepted it is told that the studio is next', async () => {
    found([{ ...nda, waits_for: ['studio'] }])
    openApp('/projects/p1/desk')
    expect(await screen.findByRole('heading', { name: 'Waiting for the studio to sign the NDA' })).toBeVisible()
  })

  test('where none was sent there is nothing to do but wait', async () => {
    found([])
    openApp('/projects/p1/desk')
    expect(await screen.findByRole('heading', { name: 'Waiting for the studio’s NDA' })).toBeVisible()
    expect(screen.getByRole('button', { name: 'Go to contracts' })).toBeVisible()
  })
})

const accepted = (party: string, name: string) => ({
  party,
  name,
  email: 'n@sound.example',
  drawing: null,
  accepted_at: '2026-11-20T11:00:00Z',
})
const ENTRY = {
  seq: 1,
  at: '2026-11-20T10:00:00.000000+00:00',
  kind: 'sent',
  payload: { by: 'Producer', version: 2 },
  previous_sha256: '0'.repeat(64),
  sha256: 'c'.repeat(64),
}

describe('a producer', () => {
  test('names who signs a draft, in which order', async () => {
    const producer = (id: string, name: string) => ({ person: { id, name }, roles: ['producer'] })
    const reviewer = { person: { id: 'x4', name: 'Composer' }, roles: ['reviewer'] }
    const draft = { ...CONTRACT, state: 'draft', my_party: 'studio', may: { ...MAY, change: true, send: true } }
    const first = { ...draft, signers: [{ id: 'x1', name: 'Producer' }] }
    const { asked, answers } = serve(
      given({
        'GET /v1/contracts/c1': draft,
        'GET /v1/projects/p1': { ...PROJECT, studio: { id: 's1', name: 'Shield Wing studio' } },
        'GET /v1/studios/s1/people': [producer('x1', 'Producer'), producer('x2', 'Executive producer'), reviewer],
        'PUT /v1/contracts/c1/signers': first,
      }),
    )
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('combobox', { name: 'First signer of the studio' }))
    expect((await screen.findAllByRole('option')).map(({ textContent }) => textContent)).toEqual([
      'Producer',
      'Executive producer',
    ])
    await userEvent.click(screen.getByRole('option', { name: 'Producer' }))
    await userEvent.click(await screen.findByRole('combobox', { name: 'Second signer of the studio' }))
    answers['PUT /v1/contracts/c1/signers'] = { ...first, signs_first: 'studio' }
    await userEvent.click(await screen.findByRole('option', { name: 'Executive producer' }))
    const bodies = () => asked.filter(({ path }) => path.endsWith('/signers')).map(({ body }) => body)
    await waitFor(() =>
      expect(bodies()).toEqual([
        { person_ids: ['x1'], first: null },
        { person_ids: ['x1', 'x2'], first: null },
      ]),
    )
  })

  const draft = {
    ...CONTRACT,
    state: 'draft',
    my_party: 'studio',
    waits_for: ['studio'],
    may: { ...MAY, change: true },
  }
  const shown = { blocks: [block('text', 'It includes 3 rounds.')], problems: [] }

  test('begins like the last contract, unless another choice is made', async () => {
    const project = {
      id: 'p1',
      studio: { id: 's1', name: 'Shield Wing studio' },
      mine: { is_producer: true, is_team: true },
      nda_needed: false,
      engagements: [{ id: 'e1', kind: 'contract', ended_at: null, designer: { id: 'x3', name: 'Sound designer' } }],
    }
    const last = {
      id: 'c0',
      title: 'Palette',
      designer: { id: 'x3', name: 'Sound designer' },
      currency: 'EUR',
      created_at: '2026-10-01T10:00:00Z',
    }
    const { asked } = serve(
      given({
        'GET /v1/projects/p1': project,
        'GET /v1/projects/p1/contracts': [],
        'GET /v1/studios/s1/contract-templates': [],
        'GET /v1/projects/p1/last-contract': { contract: last },
        'POST /v1/projects/p1/contracts': draft,
        'GET /v1/contracts/c1': draft,
      }),
    )
    openApp('/projects/p1/contracts')
    const form = within(await screen.findByRole('form', { name: 'New contract' }))
    expect(await form.findByDisplayValue('Same as last contract: Palette')).toBeVisible()
    expect(form.getByText(/its clauses, fees and terms/)).toBeVisible()
    expect(form.getByLabelText('Currency')).toHaveValue('EUR')
    await userEvent.click(form.getByRole('button', { name: 'Create draft' }))
    await waitFor(() =>
      expect(asked.find(({ method, path }) => method === 'POST' && path === '/v1/projects/p1/contracts')?.body).toEqual(
        expect.objectContaining({ same_as_id: 'c0', currency: 'EUR', template_id: null }),
      ),
    )
  })

  test('edits beside the text, and saves a version that names the one it came from', async () => {
    const { asked } = serve(
      given({
        'GET /v1/contracts/c1': draft,
        'POST /v1/contracts/c1/preview': shown,
        'PUT /v1/contracts/c1/draft': { ...draft, version: { ...VERSION, number: 3 } },
        'GET /v1/contract-library/single': { kind: 'single', notice: '', clauses: [], variables: {} },
      }),
    )
    const app = openApp(`${PAGE}/draft`)
    expect(await screen.findByText('It includes 3 rounds.')).toBeVisible()
    expect(screen.getByRole('link', { name: 'Back to contract' })).toBeVisible()
    const save = screen.getByRole('button', { name: 'Save version' })
    expect(save).toBeDisabled()
    await userEvent.click(screen.getByRole('checkbox', { name: 'Bonus' }))
    expect(screen.getByRole('link', { name: 'Discard changes' })).toBeVisible()
    await userEvent.click(save)
    await screen.findByText('Saved as version 3.')
    await vi.waitFor(() => expect(app.at()).toBe(PAGE))
    expect(screen.queryByRole('link', { name: 'Discard changes' })).not.toBeInTheDocument()
    const body = asked.find(({ method }) => method === 'PUT')?.body
    expect(body).toMatchObject({ based_on_version: 2, clauses: [{ stands: true }, { key: 'bonus', stands: true }] })
  })

  test('adds, moves, removes and takes back clauses, by keyboard alone', async () => {
    const library = {
      ...{ key: 'reel', title: 'Showing the work', text: 'From {reel_from} on.', stands: true },
      ...{ why: 'A reel is how designers find the next work.', music: false, instead_of: null },
      terms: [{ name: 'reel_from', default: 'release', label: 'From when', min: null, max: null, choices: [] }],
    }
    const { asked } = serve(
      given({
        'GET /v1/contracts/c1': draft,
        'POST /v1/contracts/c1/preview': shown,
        'PUT /v1/contracts/c1/draft': { ...draft, version: { ...VERSION, number: 3 } },
        'GET /v1/contract-library/single': { kind: 'single', notice: '', clauses: [library], variables: {} },
      }),
    )
    openApp(`${PAGE}/draft`)
    // A text field that grows asks when fonts are there, which jsdom does not know.
    Object.defineProperty(document, 'fonts', { value: new EventTarget(), configurable: true })
    const press = async (name: string) => {
      screen.getByRole('button', { name }).focus()
      await userEvent.keyboard('{Enter}')
    }
    await screen.findByRole('button', { name: 'Add from the library' })
    await press('Add from the library')
    expect(screen.getByLabelText('From when')).toHaveValue('release')
    expect(screen.queryByRole('button', { name: 'Add from the library' })).not.toBeInTheDocument()
    await userEvent.type(screen.getByLabelText('Title of the custom clause'), 'Tea{Enter}')
    await userEvent.type(screen.getByLabelText('Text'), 'At four.')
    await press('Move Tea up')
    expect(screen.getByText('Tea is clause 3 of 4.')).toBeInTheDocument()
    await vi.waitFor(() => expect(screen.getByRole('button', { name: 'Move Tea up' })).toHaveFocus())
    await press('Move Rounds down')
    await press('Remove Bonus')
    await press('Remove Rounds')
    await userEvent.click(screen.getByRole('button', { name: /^Undo/ }))
    await userEvent.click(screen.getByRole('button', { name: 'Save version' }))
    await screen.findByText('Saved as version 3.')
    expect(asked.find(({ method }) => method === 'PUT')?.body).toMatchObject({
      clauses: [{ key: 'rounds' }, { key: 'own_tea', title: 'Tea', text: 'At four.' }, { key: 'reel', stands: true }],
      terms: { reel_from: 'release', rounds_included: 2 },
    })
  })

  test('cannot save what has a fault, and is told which', async () => {
    const problems = [{ where: 'clauses.rounds', message: 'there is no variable {round}; is it {rounds_included}?' }]
    serve(given({ 'GET /v1/contracts/c1': draft, 'POST /v1/contracts/c1/preview': { ...shown, problems } }))
    openApp(`${PAGE}/draft`)
    expect(await screen.findByText('There is no variable {round}; is it {rounds_included}?')).toBeVisible()
    await userEvent.click(screen.getByRole('checkbox', { name: 'Bonus' }))
    expect(screen.getByRole('button', { name: 'Save version' })).toBeDisabled()
  })

  test('sees two versions word by word', async () => {
    const runs = [
      { is_in: 'both', text: 'It includes ' },
      { is_in: 'earlier', text: '2' },
      { is_in: 'later', text: '1' },
    ]
    const lines = [{ kind: 'text', change: 'changed', runs }]
    serve(given({ 'GET /v1/contracts/c1/comparison': { from_version: 1, to_version: 2, lines } }))
    openApp(`${PAGE}/compare`)
    expect(await screen.findByText('1 paragraph of Effects for Alpha differ between version 1 and 2.')).toBeVisible()
    expect(screen.getByText('2', { selector: 'del' })).toBeVisible()
    expect(screen.getByText('1', { selector: 'ins' })).toBeVisible()
  })
})
