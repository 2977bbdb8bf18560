import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, type Asked, wrote } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const RANGE = { low: 30, high: 80 }
const KIT = {
  key: 'puzzle',
  name: 'Puzzle',
  about: 'Tiles and blocks.',
  cues: 3,
  files: 8,
  categories: { ui: 2, impact: 1 },
  usual_cues: RANGE,
  usual_hours: RANGE,
  usual_memory_mb: RANGE,
}
const aRow = (name: string, category: string, more = {}) => ({
  name,
  file_name: name.toLowerCase().replace(' ', '_'),
  category,
  description: `A ${name} of porcelain, close, quiet.`,
  use: 'In every level',
  duration_s: 0.2,
  loop: false,
  variations: 3,
  is_listed: false,
  ...more,
})
const ROWS = [aRow('Tile set', 'ui'), aRow('Hint', 'ui'), aRow('Tile break', 'impact', { variations: 1 })]

function opened(rows = ROWS, part: 'team' | 'designer' = 'team') {
  const server = new ListServer([], {}, part)
  server.answers['GET /v1/kits'] = [KIT]
  server.answers[`GET ${server.at}/kits/puzzle`] = { key: 'puzzle', name: 'Puzzle', rows }
  server.answers[`POST ${server.at}/cues`] = ({ body }: Asked) =>
    answer(
      (body as { cues: { name: string }[] }).cues.map(({ name }, at) => aCue(at + 1, name)),
      201,
    )
  server.answers[`POST ${server.at}/cues/undo-addition`] = answer(null, 204)
  return server
}

test('an empty list leads to the kits, each with what is usual, marked as a guess', async () => {
  const server = opened()
  const app = openApp(server.path)
  await userEvent.click(await screen.findByRole('link', { name: 'Start from a kit' }))
  expect(app.at()).toBe(`${server.path}/kits`)
  const kit = await screen.findByRole('region', { name: 'Puzzle' })
  expect(kit).toHaveTextContent('3 cues, 8 files')
  expect(kit).toHaveTextContent('Usually 30–80 cues, 30–80 hours, 30–80 MB. These are guesses.')
  await userEvent.click(within(kit).getByRole('link', { name: 'Look at its cues: Puzzle' }))
  expect(await screen.findByRole('checkbox', { name: 'Keep Hint' })).toBeChecked()
})

test('by keys: strike one out, add the rest, and undo it in one act', async () => {
  const server = opened()
  const app = openApp(`${server.path}/kits?kit=puzzle`)
  await screen.findByRole('checkbox', { name: 'Keep Hint' })
  await userEvent.keyboard('jjx')
  expect(screen.getByRole('checkbox', { name: 'Keep Hint' })).not.toBeChecked()
  expect(screen.getByText('2 will be added')).toBeVisible()
  await userEvent.keyboard('{Control>}{Enter}{/Control}')
  await waitFor(() => expect(app.at()).toBe(server.path))
  const [sent] = wrote(server.asked, `POST ${server.at}/cues`)
  expect((sent?.body as { cues: unknown[] }).cues).toMatchObject([
    { name: 'Tile set', file_name: 'tile_set', category: 'ui', variations: 3, state: 'concept' },
    { name: 'Tile break', category: 'impact', variations: 1, duration_s: 0.2 },
  ])
  expect(await screen.findByText('2 cues added from the Puzzle kit.')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
  await waitFor(() => expect(wrote(server.asked, `POST ${server.at}/cues/undo-addition`)).toHaveLength(1))
  const [undone] = wrote(server.asked, `POST ${server.at}/cues/undo-addition`)
  expect((undone?.body as { cue_ids: unknown[] }).cue_ids).toHaveLength(2)
})

test('a whole category is struck out, what is on the list already is not added again, and strikes are kept', async () => {
  const server = opened([...ROWS, aRow('Button', 'ui', { is_listed: true })])
  openApp(`${server.path}/kits?kit=puzzle`)
  expect(await screen.findByRole('checkbox', { name: 'Keep Button' })).toBeDisabled()
  expect(screen.getByText('on the list already')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Strike out all ui' }))
  expect(screen.getByRole('button', { name: /Add 1 cue/ })).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Keep all ui' }))
  expect(screen.getByRole('button', { name: /Add 3 cues/ })).toBeVisible()
})

test('designers add no cues', async () => {
  const server = opened(ROWS, 'designer')
  openApp(`${server.path}/kits`)
  expect(await screen.findByRole('heading', { name: 'Only producers and audio leads add cues' })).toBeVisible()
})

test('the pages have no fault that a machine can find', async () => {
  const server = opened()
  openApp(`${server.path}/kits?kit=puzzle`)
  await screen.findByRole('checkbox', { name: 'Keep Hint' })
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
})
