import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Asked, refusal } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const MOOD = { id: 'c-mood', name: 'Mood', kind: 'choice', choices: ['calm', 'tense'] }
const BANK = { id: 'c-bank', name: 'Bank', kind: 'text', choices: [] }

async function opened(part: 'team' | 'designer' = 'team') {
  const server = new ListServer(
    [
      aCue(1, 'shield_hit', { extra: { Mood: 'calm', Scene: 'bridge' } }),
      aCue(2, 'whale', { extra: { Scene: 'sea' } }),
    ],
    {},
    part,
  )
  const path = `${server.at}/sound-list/columns`
  let now = { columns: [MOOD, BANK], edition: 'e1' }
  server.answers[`GET ${path}`] = () => now
  server.answers[`PUT ${path}`] = ({ body }: Asked) => {
    const { columns } = body as typeof now
    now = { columns: columns.map((column, at) => ({ ...column, id: column.id ?? `c-${at}` })), edition: 'e2' }
    return now
  }
  openApp(`${server.path}/columns`)
  await screen.findByRole('heading', { level: 1, name: 'Columns' })
  return { server, put: () => server.sent('PUT', path).map(({ body }) => body), path }
}

const save = () => userEvent.click(screen.getByRole('button', { name: /Save columns/ }))

test('a column is added with its choices, moved, and saved as one', { tags: ['slow'] }, async () => {
  const { put } = await opened()
  await userEvent.click(await screen.findByRole('button', { name: 'Add a column' }))
  const names = screen.getAllByRole('textbox', { name: 'Name' })
  await userEvent.type(names[2] ?? document.body, 'Layer')
  await userEvent.selectOptions(screen.getAllByRole('combobox', { name: 'Type' })[2] ?? document.body, 'Choice')
  const choices = screen.getAllByRole('textbox', { name: 'Choices, one a line' })
  await userEvent.type(choices.at(-1) ?? document.body, 'near{Enter}far')
  await userEvent.click(screen.getByRole('button', { name: 'Move Layer up' }))
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
  await save()
  expect(await screen.findByText('Columns saved.')).toBeInTheDocument()
  expect(put()).toEqual([
    { columns: [MOOD, { id: null, name: 'Layer', kind: 'choice', choices: ['near', 'far'] }, BANK], edition: 'e1' },
  ])
})

test('values under a name without a column make one, and a removed column says what happens to its values', async () => {
  const { put } = await opened()
  await userEvent.click(await screen.findByRole('button', { name: 'Scene (2 cues)' }))
  await userEvent.click(screen.getByRole('button', { name: 'Remove Mood' }))
  expect(screen.getByText(/Mood will be removed from the table. The values stay with the cues/)).toBeInTheDocument()
  await save()
  await userEvent.click(await screen.findByRole('button', { name: /Undo/ }))
  await waitFor(() =>
    expect(put()).toEqual([
      { columns: [BANK, { id: null, name: 'Scene', kind: 'text', choices: [] }], edition: 'e1' },
      { columns: [{ ...MOOD, id: null }, BANK], edition: 'e2' },
    ]),
  )
})

test('a type that values do not fit is refused at its column, and what was typed stays', async () => {
  const { server, path } = await opened()
  const message = 'SW-001 does not fit: wanted a number such as 1.5, found "calm"'
  server.answers[`PUT ${path}`] = refusal(422, 'columns-invalid', `nothing was changed; column 1: ${message}`, {
    errors: [{ where: 'column 1: kind', message }],
  })
  const [type] = await screen.findAllByRole('combobox', { name: 'Type' })
  await userEvent.selectOptions(type ?? document.body, 'Number')
  await save()
  expect(await screen.findByText(message)).toBeInTheDocument()
  expect(type).toHaveValue('number')
})

test('a designer reads that only the team changes columns', async () => {
  await opened('designer')
  expect(await screen.findByText('Only producers and audio leads can change columns')).toBeInTheDocument()
  expect(screen.queryByRole('button', { name: /Save columns/ })).not.toBeInTheDocument()
})
