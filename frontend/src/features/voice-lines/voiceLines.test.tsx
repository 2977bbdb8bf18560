import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, refusal, serve, wrote } from '@/test/server'
import { languageName, percentOf } from '@/voice-lines'

const line = (id: string, more: object = {}) => ({
  id,
  key: id,
  character: { id: 'k1', name: 'Captain' },
  scene: 'Bridge',
  direction: 'quietly',
  language: 'de',
  text: 'Beim Licht von hundert Sonnen.',
  text_version: 1,
  original_text: 'By the light of a hundred suns.',
  before: null,
  after: null,
  path: `de/${id}`,
  files: [{ path: `de/${id}`, state: 'no_take' }],
  cue: { id: `c-${id}`, number: 7, label: 'SW-007', name: `de_${id}` },
  state: 'no_take',
  reason: 'no take yet',
  take: null,
  recorded_text: null,
  original_duration_s: null,
  length_percent: null,
  length_is_off: false,
  performer: null,
  directed_by: '',
  ...more,
})
const LINES = [
  line('captain_010', { state: 'approved', reason: '', length_percent: 20, length_is_off: true }),
  line('captain_020', {
    state: 'stale',
    reason: 'the text changed; the take says: Haltet.',
    text: 'Haltet die Stellung.',
    recorded_text: 'Haltet.',
    files: [
      { path: 'de/captain_020_01', state: 'approved' },
      { path: 'de/captain_020_02', state: 'stale' },
    ],
    take: { id: 't1', number: 2, state: 'approved', duration_s: 1.2 },
  }),
  line('maya_010', {
    scene: 'Hangar',
    character: { id: 'k2', name: 'Maya' },
    text: null,
    text_version: null,
    state: 'no_text',
  }),
]
const SCRIPT = {
  original_language: 'en',
  length_tolerance_percent: 10,
  languages: ['en', 'de'],
  characters: [
    { id: 'k1', name: 'Captain', notes: '', lines: 2, castings: [] },
    { id: 'k2', name: 'Maya', notes: '', lines: 1, castings: [] },
  ],
  lines: 3,
  may_change: true,
}
const RELEASES = {
  performers: [
    {
      name: 'The voice of the captain',
      parts: ['Captain, de'],
      approved_lines: 1,
      releases: [],
      warning: '1 approved line has no release',
    },
  ],
  lines_without_performer: 0,
  may_change: true,
}

function open(address = '/projects/p1/voice-lines?language=de', more: object = {}) {
  const { asked } = serve(
    inProject('producer', {
      'GET /v1/projects/p1/voice-script': SCRIPT,
      'GET /v1/projects/p1/voice-lines': {
        language: 'de',
        lines: LINES,
        next: null,
        total: 3,
        counts: [
          { state: 'approved', lines: 1 },
          { state: 'stale', lines: 1 },
          { state: 'no_text', lines: 1 },
        ],
        may_change: true,
      },
      'GET /v1/projects/p1/pick-ups': { lines: [LINES[1]], languages: ['de'] },
      'GET /v1/projects/p1/voice-releases': RELEASES,
      ...more,
    }),
  )
  openApp(address)
  return asked
}

const violations = async () =>
  (await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations.map(({ id }) => id)

test(
  'the script is shown by scene, each line with its original, direction, state and length',
  { tags: ['slow'] },
  async () => {
    open()
    const bridge = await screen.findByRole('region', { name: 'Bridge' })
    const [first, second] = within(bridge).getAllByRole('listitem')
    expect(first).toHaveTextContent('By the light of a hundred suns.')
    expect(first).toHaveTextContent('(quietly)')
    expect(first).toHaveTextContent('Length +20 %')
    expect(second).toHaveTextContent('Text changed')
    expect(await screen.findByRole('region', { name: 'Hangar' })).toHaveTextContent('Not translated')
    expect(await violations()).toEqual([])
  },
)

test('keys move through the lines, and a state narrows them', async () => {
  const asked = open()
  await screen.findByRole('region', { name: 'Bridge' })
  await userEvent.keyboard('jj')
  expect(screen.getByRole('button', { name: 'Haltet die Stellung.' })).toHaveFocus()
  await userEvent.click(screen.getByRole('button', { name: /Text changed 1/ }))
  await waitFor(() => expect(wrote(asked, 'GET /v1/projects/p1/voice-lines').at(-1)?.query.get('state')).toBe('stale'))
})

test('a line says what its take still says, and its text is changed from the version that was read', async () => {
  const asked = open(undefined, { 'PUT /v1/voice-lines/captain_020/texts/de': answer(null, 204) })
  await userEvent.click(await screen.findByRole('button', { name: 'Haltet die Stellung.' }))
  const dialog = await screen.findByRole('dialog')
  expect(dialog).toHaveTextContent('The text changed; the take says: Haltet.')
  const text = within(dialog).getByRole('textbox', { name: 'Text' })
  await userEvent.clear(text)
  await userEvent.type(text, 'Haltet durch.')
  await userEvent.click(within(dialog).getByRole('checkbox', { name: 'Takes that exist still fit this text' }))
  await userEvent.click(within(dialog).getByRole('button', { name: 'Save' }))
  await waitFor(() => expect(screen.queryByRole('dialog')).toBeNull())
  expect(wrote(asked, 'PUT /v1/voice-lines/captain_020/texts/de').map(({ body }) => body)).toEqual([
    { text: 'Haltet durch.', text_version: 1, takes_fit: true },
  ])
})

test('the pick-up list names its reasons and can be taken away', async () => {
  open('/projects/p1/voice-lines?view=pick-ups&language=de')
  const part = await screen.findByRole('region', { name: 'Captain, German (de)' })
  expect(part).toHaveTextContent('The text changed; the take says: Haltet.')
  expect(part).toHaveTextContent('de/captain_020_02')
  expect(part, 'what is approved is not recorded again').not.toHaveTextContent('captain_020_01')
  expect(screen.getByRole('link', { name: 'XLSX' })).toHaveAttribute(
    'href',
    '/v1/projects/p1/pick-ups.xlsx?language=de',
  )
  expect(await violations()).toEqual([])
})

test('the cast is saved by language, and what no release covers is said', { tags: ['slow'] }, async () => {
  const asked = open('/projects/p1/voice-lines?view=cast', {
    'PUT /v1/voice-characters/k1/castings/de': SCRIPT,
  })
  expect(await screen.findByText('1 approved line has no release')).toBeVisible()
  const form = screen.getByRole('form', { name: 'Captain, German (de)' })
  await userEvent.type(within(form).getByRole('textbox', { name: 'Directed by' }), 'Audio director')
  await userEvent.click(within(form).getByRole('button', { name: 'Save' }))
  await waitFor(() =>
    expect(wrote(asked, 'PUT /v1/voice-characters/k1/castings/de').map(({ body }) => body)).toEqual([
      { performer: '', directed_by: 'Audio director', cast_by: '' },
    ]),
  )
  expect(await violations()).toEqual([])
})

test('a script is read before it is imported, with errors by row', { tags: ['slow'] }, async () => {
  const read = {
    header_row: null,
    columns: [{ name: 'text', samples: ['Go.'], meaning: 'en' }],
    rows: [
      {
        row: 3,
        action: 'add',
        key: 'maya_001',
        character: 'Maya',
        scene: '',
        text: 'Go.',
        files: 3,
        languages: ['en'],
        changes: [],
      },
    ],
    tabs: [],
    encoding: null,
    skipped: [{ row: 1, kind: 'hidden', text: 'Old', why: 'the spreadsheet hides this row' }],
    guesses: [],
    errors: [{ row: 9, column: 'Character', message: 'no character' }],
    left_out: [9],
    refused_names: { names: [], patterns: [] },
    added: 1,
    changed: 0,
    same: 0,
    cues_added: 1,
    stale: 0,
    not_in_script: [],
    imported: false,
  }
  const asked = open('/projects/p1/voice-lines/import', { 'POST /v1/projects/p1/voice-lines/import': read })
  await userEvent.click(await screen.findByRole('button', { name: 'Text of a script' }))
  await userEvent.type(screen.getByRole('textbox', { name: 'Text' }), 'MAYA')
  expect(await screen.findByText(/Row 9, Character/)).toBeVisible()
  expect(screen.getByText('Row 1 is not read: Old.', { exact: false })).toBeVisible()
  expect(screen.getByText('3 files in each language')).toBeVisible()
  expect(screen.getByText('1 error: 1 row will be left out.')).toBeVisible()
  expect(screen.getByRole('button', { name: 'Import 1 line' })).toBeEnabled()
  const body = wrote(asked, 'POST /v1/projects/p1/voice-lines/import').at(-1)?.body
  expect(body).toMatchObject({ format: 'script', text: 'MAYA', language: 'en', dry_run: true })
  expect(await violations()).toEqual([])
})

test('a table without speakers asks who speaks', { tags: ['slow'] }, async () => {
  const missing = refusal(422, 'speaker-missing', 'no column has the characters; the columns are Line ID, Text')
  const asked = open('/projects/p1/voice-lines/import', { 'POST /v1/projects/p1/voice-lines/import': missing })
  await userEvent.type(await screen.findByRole('textbox', { name: 'Pasted rows' }), 'Line ID')
  const sent = () => wrote(asked, 'POST /v1/projects/p1/voice-lines/import').at(-1)?.body
  await userEvent.type(await screen.findByRole('textbox', { name: 'Speaker of the file' }), 'Anna')
  await waitFor(() => expect(sent()).toMatchObject({ speaker: 'Anna', speaker_in_key: false }))
  await userEvent.click(screen.getByRole('checkbox', { name: /The line ID begins with the speaker/ }))
  await waitFor(() => expect(sent()).toMatchObject({ speaker_in_key: true }))
})

test('a project without a script says how to begin', async () => {
  open('/projects/p1/voice-lines', { 'GET /v1/projects/p1/voice-script': { ...SCRIPT, lines: 0 } })
  expect(await screen.findByRole('heading', { name: 'No voice lines yet' })).toBeVisible()
  expect(screen.getByRole('link', { name: /Import a script/ })).toBeVisible()
})

test('a refusal is shown', async () => {
  open('/projects/p1/voice-lines', { 'GET /v1/projects/p1/voice-script': refusal(403, 'nda-needed', 'Sign the NDA.') })
  expect(await screen.findByText('Sign the NDA.')).toBeVisible()
})

test('lengths and languages in words', () => {
  expect([percentOf(20), percentOf(-7.5), percentOf(0)]).toEqual(['+20 %', '−7.5 %', '±0 %'])
  expect([languageName('de'), languageName('xx')]).toEqual(['German (de)', 'xx'])
})
