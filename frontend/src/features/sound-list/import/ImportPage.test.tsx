import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Asked, refusal } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const COLUMNS = [
  { name: 'Sound', samples: ['door_open', 'hatch'], guess: 'name', field: 'name', why: '' },
  { name: 'Len', samples: ['1.2', 'long'], guess: 'duration_s', field: 'duration_s', why: '' },
  { name: 'Mood', samples: ['calm'], guess: null, field: 'extra', why: '' },
]
const aRow = (row: number, action: string, name: string, more = {}) => ({
  row,
  action,
  label: null,
  name,
  file_name: '',
  category: 'foley',
  description: '',
  duration_s: 1.2,
  duration_min_s: null,
  duration_max_s: null,
  loop: false,
  variations: 1,
  state: 'prototype',
  changes: [],
  ...more,
})
const READ = {
  tabs: [],
  encoding: null,
  unread: [],
  skipped: [],
  guesses: [],
  left_out: [],
  refused_names: { names: [], patterns: [] },
}
const PLAN = {
  ...READ,
  header_row: 1,
  columns: COLUMNS,
  cells: [
    { row: 2, cells: ['door_open', '1.2', 'calm'] },
    { row: 3, cells: ['shield_hit', '1.2', ''] },
  ],
  rows: [
    aRow(2, 'add', 'door_open'),
    aRow(3, 'change', 'shield_hit', {
      label: 'SW-001',
      changes: [{ field: 'duration_s', before: 0.8, after: 1.2 }],
    }),
  ],
  errors: [],
  added: 1,
  changed: 1,
  same: 0,
  imported: false,
  revision: 2,
}

function opened(plan: unknown) {
  const server = new ListServer([aCue(1, 'shield_hit')])
  server.answers[`POST ${server.at}/sound-list/import`] = plan
  const app = openApp(`${server.path}/import`)
  return { server, app, sent: () => server.sent('POST', `${server.at}/sound-list/import`).map(({ body }) => body) }
}
const type = async (text: string) => {
  await userEvent.click(await screen.findByRole('textbox', { name: 'Pasted rows' }))
  await userEvent.paste(text)
}

test('a dry run says what happens to every row; then it is imported', async () => {
  const { server, app, sent } = opened(({ body }: Asked) => ({
    ...PLAN,
    imported: !(body as { dry_run: boolean }).dry_run,
    revision: 3,
  }))
  await type('Sound\tLen\tMood\ndoor_open\t1.2\tcalm')
  const table = await screen.findByRole('table', { name: 'Rows of the spreadsheet' })
  const [, first, second] = within(table).getAllByRole('row')
  expect(first).toHaveTextContent('2 Add')
  expect(second).toHaveTextContent(/3 Change\s*shield_hit.*SW-001.*Length was 0.80 s.*1.20 s/)
  expect(sent()[0]).toMatchObject({ format: 'paste', dry_run: true, match: 'number', mapping: {} })
  await userEvent.click(screen.getByRole('button', { name: 'Import 2 cues' }))
  expect(await screen.findByText('1 cue added, 1 changed. The list is at revision 3.')).toBeInTheDocument()
  expect(sent().at(-1)).toMatchObject({ dry_run: false, text: 'Sound\tLen\tMood\ndoor_open\t1.2\tcalm' })
  await waitFor(() => expect(app.at()).toBe(server.path))
})

test('errors stand at their row and stop no other; what is left stays to be fixed', async () => {
  const { app, sent } = opened(({ body }: Asked) => ({
    ...PLAN,
    rows: PLAN.rows.slice(0, 1),
    errors: [{ row: 4, column: 'Len', message: 'wanted seconds such as 1.5, found "long"' }],
    left_out: [4],
    changed: 0,
    imported: !(body as { dry_run: boolean }).dry_run,
  }))
  await type('Sound\tLen\na\tlong')
  const wrong = await screen.findByRole('row', { name: /Error/ })
  expect(wrong).toHaveTextContent('wanted seconds such as 1.5, found "long"')
  expect(within(wrong).getByText('4')).toBeInTheDocument()
  await userEvent.click(screen.getByRole('button', { name: 'Import 1 cue' }))
  expect(await screen.findByText('1 cue added. 1 row left out: fix them below.')).toBeInTheDocument()
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ dry_run: true, skip_rows: [2] }))
  await userEvent.click(await screen.findByRole('button', { name: '1 with errors' }))
  expect(screen.queryByText('door_open', { selector: 'th' })).not.toBeInTheDocument()
  expect(screen.getByRole('textbox', { name: 'Pasted rows' })).toHaveValue('Sound\tLen\na\tlong')
  expect(app.at()).toMatch(/import$/)
})

test('what was guessed, skipped and not read is said, and can be undone', { tags: ['slow'] }, async () => {
  const { sent } = opened({
    ...PLAN,
    tabs: [
      { name: 'UI', rows: 3, heads: ['Sound'], is_hidden: false, is_read: true },
      { name: 'Ambience', rows: 9, heads: ['Sound'], is_hidden: false, is_read: false },
      { name: 'Doors', rows: 4, heads: ['Sound'], is_hidden: true, is_read: false },
    ],
    encoding: { name: 'shift-jis', is_guess: true, others: ['mac-roman'] },
    skipped: [{ row: 5, kind: 'section', text: 'UI SOUNDS', why: 'in capitals' }],
    guesses: [{ row: 2, column: 'Len', kind: 'reading', text: '1-2 s', value: '1.5', why: 'the middle of 1 to 2 s' }],
    unread: [{ name: 'Mood', is_kept: true, cells: 1, why: 'no field of the list is called so' }],
    refused_names: {
      names: [
        {
          row: 2,
          cue_id: null,
          label: null,
          name: 'Door',
          category: '',
          stem: 'DOOR',
          rule: 'pattern',
          message: 'name "DOOR"',
          proposed: 'door',
        },
      ],
      patterns: [],
    },
  })
  await type('Sound\tLen\tMood\na\t1\tcalm')
  expect(await screen.findByText('Not read: Ambience, Doors. Import them next.')).toBeInTheDocument()
  expect(screen.getByText('the middle of 1 to 2 s')).toBeInTheDocument()
  expect(screen.getByText('no field of the list is called so')).toBeInTheDocument()
  expect(screen.getByRole('region', { name: 'File names that the spec refuses' })).toHaveTextContent('DOOR → door')
  expect(screen.getByRole('rowheader', { name: /door_open/ })).toHaveTextContent('door_open → door')
  expect(screen.getByRole('row', { name: /UI SOUNDS/ })).toHaveTextContent(/Section\s*UI SOUNDS in capitals/)
  await userEvent.click(screen.getByRole('button', { name: 'Read row 5 as a cue' }))
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ keep_rows: [5] }))
  await userEvent.click(screen.getByRole('button', { name: 'Ambience (9 rows)' }))
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ tab: 'Ambience' }))
  await userEvent.selectOptions(screen.getByRole('combobox', { name: /^Encoding/ }), 'mac-roman')
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ encoding: 'mac-roman' }))
  await userEvent.click(screen.getByRole('checkbox', { name: 'Rename files that the delivery spec refuses' }))
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ use_proposed_names: true }))
})

test('after an import no page says that the list is empty', async () => {
  const server = new ListServer([])
  let imported = false
  const { cues: filled } = { cues: [aCue(1, 'door_open')] }
  let answerList: () => void = () => undefined
  server.answers[`GET ${server.at}/sound-list`] = async () => {
    if (!imported) return { revision: 0, cues: [], next: null }
    await new Promise<void>((resolve) => (answerList = resolve))
    return { revision: 1, cues: filled, next: null }
  }
  server.answers[`POST ${server.at}/sound-list/import`] = ({ body }: Asked) => {
    imported = !(body as { dry_run: boolean }).dry_run
    return { ...PLAN, imported, revision: 1 }
  }
  const app = openApp(server.path)
  await screen.findByRole('heading', { name: 'Which sounds do you need?' })
  await userEvent.click(screen.getAllByRole('button', { name: /XLSX or CSV/ })[0] as HTMLElement)
  await type('Sound\ndoor_open')
  await userEvent.click(await screen.findByRole('button', { name: 'Import 2 cues' }))
  await waitFor(() => expect(app.at()).toBe(server.path))
  expect(screen.queryByText(/0 cues/)).not.toBeInTheDocument()
  expect(screen.queryByRole('heading', { name: 'Which sounds do you need?' })).not.toBeInTheDocument()
  await waitFor(() => answerList())
  expect(await screen.findByText(/door_open/)).toBeInTheDocument()
})

test(
  'a column is read as what the person says; a field moves and is never read twice',
  { tags: ['slow'] },
  async () => {
    const { sent } = opened(PLAN)
    await type('Sound\tLen\tMood\na\t1\tcalm')
    await userEvent.selectOptions(await screen.findByRole('combobox', { name: 'Map Mood to' }), 'category')
    await waitFor(() => expect(sent().at(-1)).toMatchObject({ mapping: { Mood: 'category' } }))
    await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Map Sound to' }), 'category')
    await waitFor(() => expect(sent().at(-1)).toMatchObject({ mapping: { Sound: 'category' } }))
    expect((sent().at(-1) as { mapping: object }).mapping).toEqual({ Sound: 'category' })
    await userEvent.click(screen.getByRole('button', { name: 'By name' }))
    await waitFor(() => expect(sent().at(-1)).toMatchObject({ match: 'name' }))
  },
)

test('the grid has the cells of the sheet, each column with what it is read as in its head', async () => {
  opened({
    ...PLAN,
    guesses: [
      { row: 2, column: 'Len', kind: 'reading', text: '1200 ms', value: '1.2', why: 'milliseconds' },
      { row: 3, column: 'Mood', kind: 'filled_down', text: '', value: 'calm', why: 'the cell above is merged' },
    ],
    cells: [
      { row: 2, cells: ['door_open', '1200 ms', 'calm'] },
      { row: 3, cells: ['shield_hit', '1.2', 'calm'] },
    ],
    skipped: [{ row: 4, kind: 'total', text: 'TOTAL, 118', why: 'it looks like a sum' }],
  })
  await type('Sound\tLen\tMood\na\t1\tcalm')
  const heads = await screen.findAllByRole('columnheader')
  expect(heads.map((head) => within(head).queryByRole('combobox')?.getAttribute('aria-label'))).toEqual([
    undefined,
    undefined,
    'Map Sound to',
    'Map Len to',
    'Map Mood to',
    undefined,
  ])
  expect(screen.getByRole('cell', { name: /1200 ms\s*→\s*1.2/ })).toHaveAttribute('title', '1200 ms\nmilliseconds')
  expect(screen.getAllByRole('cell', { name: 'calm' })[1]).toHaveAttribute('data-filled')
  expect(screen.getByRole('row', { name: /TOTAL, 118/ })).toHaveTextContent('it looks like a sum')
})

test('lengths in samples are read at a rate that is named and can be changed', async () => {
  const { sent } = opened({
    ...PLAN,
    columns: [{ ...COLUMNS[1], name: 'Length (samples)', why: 'a length in samples at 48,000 Hz' }, COLUMNS[0]],
  })
  await type('Length (samples)\tSound\n48000\ta')
  const rate = await screen.findByRole('combobox', { name: 'Sample rate of lengths in samples' })
  expect(rate).toHaveDisplayValue('48 kHz')
  await userEvent.selectOptions(rate, '96000')
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ sample_rate_hz: 96_000 }))
})

test('typing in the pasted rows keeps what was mapped by hand', { tags: ['slow'] }, async () => {
  const { sent } = opened(PLAN)
  await type('Sound\tLen\tMood\na\t1\tcalm')
  await userEvent.selectOptions(await screen.findByRole('combobox', { name: 'Map Mood to' }), 'category')
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ mapping: { Mood: 'category' } }))
  await userEvent.type(screen.getByRole('textbox', { name: 'Pasted rows' }), 'er')
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ text: expect.stringMatching(/calmer$/) as string }))
  expect(sent().at(-1)).toMatchObject({ mapping: { Mood: 'category' } })
})

test('a file goes as its bytes, and a sheet that cannot be read says why and stays', async () => {
  const { sent } = opened(refusal(422, 'sheet-unreadable', 'this is a ZIP file, and no XLSX workbook'))
  await screen.findByRole('textbox', { name: 'Pasted rows' })
  const picker = document.querySelector<HTMLInputElement>('input[type=file]')
  await userEvent.upload(picker as HTMLInputElement, new File(['PK'], 'sounds.xlsx'))
  expect(await screen.findByRole('alert')).toHaveTextContent('This is a ZIP file, and no XLSX workbook.')
  expect(sent()[0]).toMatchObject({ format: 'xlsx', content_base64: btoa('PK') })
  expect(screen.getByText('sounds.xlsx')).toBeInTheDocument()
})

test('a repair of a column that the pasted rows no longer have says which, and which they have', async () => {
  const { server } = opened(PLAN)
  await type('Sound\tLen\tMood\ndoor_open\t1.2\tcalm')
  const mood = await screen.findByRole('combobox', { name: 'Map Mood to' })
  server.answers[`POST ${server.at}/sound-list/import`] = refusal(
    422,
    'column-unknown',
    'the sheet has no column "Length"; it has Sound, Len, Mood',
  )
  await userEvent.selectOptions(mood, 'category')
  expect(await screen.findByRole('alert')).toHaveTextContent(
    'The sheet has no column "Length"; it has Sound, Len, Mood.',
  )
  expect(screen.getByRole('textbox', { name: 'Pasted rows' })).toHaveValue('Sound\tLen\tMood\ndoor_open\t1.2\tcalm')
})

test('a file that is too large is not sent', async () => {
  const { sent } = opened(PLAN)
  await screen.findByRole('textbox', { name: 'Pasted rows' })
  const file = new File(['x'], 'huge.csv')
  Object.defineProperty(file, 'size', { value: 6_000_000 })
  await userEvent.upload(document.querySelector('input[type=file]') as HTMLInputElement, file)
  expect(await screen.findByRole('alert')).toHaveTextContent('huge.csv has 6.0 MB; the limit is 5.0 MB.')
  expect(sent()).toEqual([])
})

test('a designer sees who changes the list', async () => {
  const server = new ListServer([], {}, 'designer')
  server.answers[`GET ${server.at}/desk`] = { came_back: [], unmatched: 0, checking: 0 }
  openApp(`${server.path}/import`)
  expect(
    await screen.findByRole('heading', { name: 'Only producers and audio leads can edit the list' }),
  ).toBeInTheDocument()
})

test('F8 leads from error to error, x leaves the row out, and Ctrl Enter imports the others', async () => {
  const { sent } = opened(({ body }: Asked) => {
    const { dry_run: isDry, skip_rows: skipped = [] } = body as { dry_run: boolean; skip_rows?: number[] }
    const errors = [4, 7].map((row) => ({ row, column: 'Len', name: `wrong_${row}`, message: 'wanted seconds' }))
    const left = errors.filter(({ row }) => !skipped.includes(row))
    return { ...PLAN, errors: left, left_out: left.map(({ row }) => row), imported: !isDry }
  })
  await type('Sound\tLen\na\tlong')
  const wrong = await screen.findAllByRole('row', { name: /Error/ })
  await userEvent.click(document.body)
  await userEvent.keyboard('{F8}')
  await waitFor(() => expect(wrong[0]).toHaveFocus())
  await userEvent.keyboard('{F8}')
  await waitFor(() => expect(screen.getByRole('row', { name: /wrong_7/ })).toHaveFocus())
  await userEvent.keyboard('x')
  await waitFor(() => expect(sent().at(-1)).toMatchObject({ dry_run: true, skip_rows: [7] }))
  await waitFor(() => expect(screen.queryByRole('row', { name: /wrong_7/ })).toBeNull())
  await userEvent.keyboard('{Control>}{Enter}{/Control}')
  await waitFor(() => expect(sent().filter((body) => !(body as { dry_run: boolean }).dry_run)).toHaveLength(1))
})

test('a wrong cell is repaired in place, and Ctrl D fills its column down', { tags: ['slow'] }, async () => {
  const fault = { row: 4, name: 'hatch', column: 'Len', message: 'found "long", wanted seconds', text: 'long' }
  const { server } = opened(({ body }: Asked) => {
    const { edits } = body as { edits?: unknown[] }
    return edits ? { ...PLAN, added: 2 } : { ...PLAN, errors: [fault], left_out: [4] }
  })
  await userEvent.click(await screen.findByLabelText('Pasted rows'))
  await userEvent.paste('Sound\tLen\tMood\ndoor_open\t1.2\tcalm\nshield_hit\t1.2\t\nhatch\tlong\t')
  const cell = await screen.findByLabelText('Len, row 4')
  expect(cell).toHaveValue('long')
  await userEvent.click(cell)
  await userEvent.keyboard('{Control>}d{/Control}')
  const asked = () => server.sent('POST', `${server.at}/sound-list/import`).at(-1)?.body
  await waitFor(() => expect(asked()).toMatchObject({ fill_down_columns: ['Len'] }))
  const again = await screen.findByLabelText('Len, row 4')
  await userEvent.clear(again)
  await userEvent.type(again, '0.4{Enter}')
  await waitFor(() => expect(asked()).toMatchObject({ edits: [{ row: 4, column: 'Len', text: '0.4' }] }))
  await waitFor(() => expect(screen.queryByLabelText('Len, row 4')).toBeNull())
})
