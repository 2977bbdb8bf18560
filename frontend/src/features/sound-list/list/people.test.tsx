import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Asked } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const KIM = { id: '00000000-0000-4000-8000-000000000001', name: 'Kim Integrator', is_designer: false }
const LEE = { id: '00000000-0000-4000-8000-000000000002', name: 'Lee Recordist', is_designer: true }

function served() {
  const server = new ListServer([
    aCue(1, 'shield_hit', { implementer_id: KIM.id, recorder_id: LEE.id }),
    aCue(2, 'airlock_cycle'),
  ])
  server.answers[`GET ${server.at}/cue-people`] = [KIM, LEE]
  server.answers[`POST ${server.at}/sound-list/import`] = {
    header_row: 1,
    columns: [],
    rows: [],
    errors: [],
    added: 0,
    changed: 1,
    same: 0,
    imported: true,
    revision: 3,
  }
  return server
}

test('the content of the list shows who puts a cue in the game and who records it', async () => {
  openApp(`${served().path}?view=content`)
  const row = await screen.findByRole('row', { name: /shield_hit/ })
  expect(await within(row).findByText('Kim Integrator')).toBeInTheDocument()
  expect(within(row).getByText('Lee Recordist')).toBeInTheDocument()
  const found = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(found.violations.map(({ id }) => id)).toEqual([])
})

test('the list is filtered by person, and by who is missing', async () => {
  openApp(served().path)
  await userEvent.click(await screen.findByRole('button', { name: 'Filter' }))
  const filter = await screen.findByRole('combobox', { name: 'Person' })
  await waitFor(() => expect(within(filter).getAllByRole('option', { name: 'Kim Integrator' })).toHaveLength(2))
  await userEvent.selectOptions(filter, `implementer:${KIM.id}`)
  await waitFor(() => expect(screen.queryByRole('row', { name: /airlock_cycle/ })).not.toBeInTheDocument())
  expect(screen.getByRole('row', { name: /shield_hit/ })).toBeInTheDocument()
  await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Person' }), 'recorder:none')
  expect(await screen.findByRole('row', { name: /airlock_cycle/ })).toBeInTheDocument()
  expect(screen.queryByRole('row', { name: /shield_hit/ })).not.toBeInTheDocument()
})

test('one choice names a person for all selected cues, in one revision', async () => {
  const server = served()
  openApp(server.path)
  await screen.findByRole('row', { name: /airlock_cycle/ })
  await userEvent.click(screen.getByRole('checkbox', { name: 'Select SW-001' }))
  await userEvent.click(screen.getByRole('checkbox', { name: 'Select SW-002' }))
  await userEvent.selectOptions(
    screen.getByRole('combobox', { name: 'Puts it in the game, of the selected cues' }),
    'Kim Integrator',
  )
  expect(await screen.findByText('1 cue set to Kim Integrator.')).toBeInTheDocument()
  const [asked] = server.sent('POST', `${server.at}/sound-list/import`)
  const body = asked?.body as { text: string; mapping: Record<string, string> }
  expect(body.text).toBe(`number,implementer\n2,"${KIM.id}"`)
  expect(body.mapping).toEqual({ number: 'number', implementer: 'implementer' })
})

test('the panel of a cue names them in fields, and the saved fact is an id', async () => {
  const server = served()
  const cue = server.cue('airlock_cycle')
  server.answers[`PATCH /v1/cues/${cue.id}`] = ({ body }: Asked) => ({ ...cue, ...(body as object), edition: 2 })
  openApp(server.path)
  await screen.findByRole('row', { name: /airlock_cycle/ })
  await userEvent.keyboard('jje')
  const form = await screen.findByRole('form', { name: 'Edit airlock_cycle' })
  await userEvent.selectOptions(await within(form).findByLabelText('Records it'), 'Lee Recordist')
  await userEvent.click(within(form).getByRole('button', { name: /Save airlock_cycle/ }))
  await waitFor(() => expect(server.sent('PATCH', `/v1/cues/${cue.id}`)).toHaveLength(1))
  expect(server.sent('PATCH', `/v1/cues/${cue.id}`)[0]?.body).toEqual({ edition: 1, recorder_id: LEE.id })
})
