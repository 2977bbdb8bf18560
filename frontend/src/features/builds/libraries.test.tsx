import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

beforeAll(() => import('./LibrariesPage'))

const PERSON = { id: 'x1', name: 'Producer' }
const DOORS = {
  id: 'l1',
  name: 'Doors & Gates',
  licence: 'Site licence 12',
  sounds: 1_204,
  person: PERSON,
  added_at: '2026-11-20T09:00:00Z',
  may_remove: true,
}
const THEIRS = { ...DOORS, id: 'l2', name: 'Water', licence: '', may_remove: false }
const PATH = '/v1/projects/p1/sound-libraries'
const given = (libraries: object[]): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: PERSON },
  'GET /v1/me': { person: PERSON, email: 'p@game.example', studios: [], projects: [] },
  [`GET ${PATH}`]: libraries,
})

test('libraries are listed with what may be removed, and removed once it is confirmed', async () => {
  const { asked, answers } = serve(given([DOORS, THEIRS]))
  answers['DELETE /v1/sound-libraries/l1'] = () => {
    answers[`GET ${PATH}`] = [THEIRS]
    return {}
  }
  openApp('/projects/p1/libraries')
  const row = await screen.findByRole('row', { name: /Doors & Gates/ })
  expect(row).toHaveTextContent('Site licence 12')
  expect(row).toHaveTextContent('1,204')
  expect(screen.getByRole('row', { name: /Water/ })).toHaveTextContent('not named')
  expect(screen.queryByRole('button', { name: 'Remove Water' })).toBeNull()
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  await userEvent.click(within(row).getByRole('button', { name: 'Remove Doors & Gates' }))
  expect(asked.some(({ method }) => method === 'DELETE')).toBe(false)
  await userEvent.click(screen.getByRole('button', { name: 'Remove Doors & Gates and what was found' }))
  expect(await screen.findByRole('row', { name: /Water/ })).toBeVisible()
  expect(screen.queryByRole('row', { name: /Doors & Gates/ })).toBeNull()
})

test('a sheet is sent with name and licence, and what was typed stays where it is refused', async () => {
  const { asked, answers } = serve(given([]))
  openApp('/projects/p1/libraries')
  expect(await screen.findByText(/no sound leaves it/)).toBeVisible()
  const register = screen.getByRole('button', { name: 'Register' })
  expect(register).toBeDisabled()
  await userEvent.type(screen.getByLabelText('Name'), 'Doors & Gates')
  await userEvent.type(screen.getByLabelText('Licence'), 'Site licence 12')
  const sheet = new File(['{}'], 'library.json', { type: 'application/json' })
  await userEvent.upload(screen.getByLabelText('Sheet of fingerprints'), sheet)
  answers[`POST ${PATH}`] = refusal(422, 'bad-library-sheet', 'the sheet is not a manifest')
  await userEvent.click(register)
  expect(await screen.findByText(/the sheet is not a manifest/i)).toBeVisible()
  expect(screen.getByLabelText('Name')).toHaveValue('Doors & Gates')
  answers[`POST ${PATH}`] = DOORS
  await userEvent.click(register)
  expect(
    await screen.findByText('Doors & Gates has 1,204 sounds. Versions are compared with the library now.'),
  ).toBeVisible()
  expect(asked.findLast(({ method }) => method === 'POST')?.body).toEqual({
    name: 'Doors & Gates',
    licence: 'Site licence 12',
    content_base64: btoa('{}'),
  })
})
