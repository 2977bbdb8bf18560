import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import type { Asked } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const FIELD = 'One sound a line, or paste from a spreadsheet'
const anAnswer = (more: object) => ({
  tabs: [],
  encoding: null,
  unread: [],
  skipped: [],
  guesses: [],
  left_out: [],
  header_row: 1,
  columns: [],
  rows: [],
  cells: [],
  errors: [],
  refused_names: { names: [], patterns: [] },
  added: 0,
  changed: 0,
  same: 0,
  imported: false,
  revision: 0,
  ...more,
})
const REFUSED = {
  names: [
    {
      row: 2,
      label: null,
      cue_id: null,
      name: 'Shield hit',
      category: '',
      stem: 'Shield hit',
      rule: '[names]',
      message: 'spaces',
      proposed: 'shield_hit',
    },
  ],
  patterns: [],
}

test('typed names become cues; those that the spec refuses are named with the fix, which is used', async () => {
  const server = new ListServer([])
  server.answers[`POST ${server.at}/sound-list/import`] = ({ body }: Asked) => {
    const isTrial = (body as { dry_run: boolean }).dry_run
    if (!isTrial) server.cues = [aCue(1, 'Shield hit')]
    return anAnswer({ refused_names: REFUSED, added: 2, imported: !isTrial })
  }
  openApp(server.path)
  await userEvent.click(await screen.findByLabelText(FIELD))
  await userEvent.paste('Shield hit\nFootsteps x6')
  expect(screen.getByText('6 variations')).toBeVisible()
  expect(await screen.findByRole('region', { name: 'File names that the spec refuses' })).toHaveTextContent(
    'Shield hit → shield_hit',
  )
  expect(screen.getByLabelText('Use the file names that the spec accepts')).toBeChecked()
  await userEvent.click(screen.getByRole('button', { name: /^Add 2 sounds/ }))
  expect(await screen.findByText('2 cues added.')).toBeInTheDocument()
  expect(await screen.findByRole('row', { name: /Shield hit/ })).toBeInTheDocument()
  expect(server.sent('POST', `${server.at}/sound-list/import`).at(-1)?.body).toMatchObject({
    text: 'name,description,duration_s,variations\n"Shield hit","",,1\n"Footsteps","",,6',
    use_proposed_names: true,
    atomic: true,
    dry_run: false,
  })
})

test('a line that cannot be a cue is named by its words', async () => {
  const server = new ListServer([])
  const fault = { row: 3, name: '???', column: 'name', message: '"???" has no letter or digit for a file name' }
  server.answers[`POST ${server.at}/sound-list/import`] = anAnswer({ errors: [fault] })
  openApp(server.path)
  await userEvent.type(await screen.findByLabelText(FIELD), 'Door\n???')
  expect(await screen.findByText(`???: ${fault.message}`)).toBeVisible()
})

test('cells of a spreadsheet open the import with them', async () => {
  const server = new ListServer([])
  server.answers[`POST ${server.at}/sound-list/import`] = anAnswer({})
  const app = openApp(server.path)
  await userEvent.click(await screen.findByLabelText(FIELD))
  await userEvent.paste('name\tlength\ndoor\t1.2')
  await waitFor(() => expect(app.at()).toBe(`${server.path}/import`))
  expect(await screen.findByLabelText('Pasted rows')).toHaveValue('name\tlength\ndoor\t1.2')
})
