import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { refusal } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const SIZE = { fact: 'size', question: 'How heavy?', answers: ['under 1 kg', '5 to 20 kg'] }
const PLACE = { fact: 'place', question: 'Into what?', answers: ['a puddle', 'a tub'] }

async function opened(part: 'team' | 'designer' = 'team') {
  const server = new ListServer([aCue(1, 'coolant_splash'), aCue(2, 'airlock_cycle')], {}, part)
  const { id } = server.cue('coolant_splash')
  let open = [SIZE, PLACE]
  const close = (fact: string) => () => {
    open = open.filter((one) => one.fact !== fact)
    return null
  }
  server.answers[`GET ${server.at}/clarity`] = () => ({
    unclear: open.length > 0 ? [{ cue_id: id, questions: open }] : [],
  })
  server.answers[`POST /v1/cues/${id}/clarity/size/answer`] = close('size')
  server.answers[`PUT /v1/cues/${id}/clarity/place/dismissed`] = close('place')
  const app = openApp(server.path)
  await screen.findByText(': How heavy? Into what?')
  return { server, app, id }
}

test('an unclear cue says what is open, and the filter keeps those alone', async () => {
  const { app } = await opened()
  await userEvent.click(screen.getByRole('button', { name: 'Filter' }))
  await userEvent.click(screen.getByRole('button', { name: 'Unclear 1' }))
  await waitFor(() => expect(app.search()).toEqual({ unclear: true }))
  expect(screen.queryByRole('link', { name: 'airlock_cycle' })).not.toBeInTheDocument()
  await userEvent.keyboard('{Escape}')
  expect(await screen.findByRole('link', { name: 'airlock_cycle' })).toBeInTheDocument()
})

test('a key answers the first question, d dismisses the next, and the panel closes at the last', async () => {
  const { server, id } = await opened()
  await userEvent.keyboard('jc')
  const panel = await screen.findByRole('region', { name: 'What is unclear about coolant_splash' })
  await userEvent.keyboard('2')
  await waitFor(() => expect(within(panel).queryByRole('form', { name: 'How heavy?' })).not.toBeInTheDocument())
  expect(server.sent('POST', `/v1/cues/${id}/clarity/size/answer`).map(({ body }) => body)).toEqual([
    { text: '5 to 20 kg' },
  ])
  await userEvent.keyboard('d')
  await waitFor(() => expect(panel).not.toBeInTheDocument())
  expect(await screen.findByText('“Into what?” is not asked of coolant_splash any more.')).toBeInTheDocument()
  expect(screen.queryByText(/Unclear/)).not.toBeInTheDocument()
})

test('a press on the remark opens the same questions', async () => {
  await opened()
  await userEvent.click(await screen.findByRole('button', { name: 'Answer what is unclear about coolant_splash' }))
  expect(await screen.findByRole('region', { name: 'What is unclear about coolant_splash' })).toBeVisible()
})

test('what is typed stays when the server refuses it', async () => {
  const { server, id } = await opened()
  server.answers[`POST /v1/cues/${id}/clarity/size/answer`] = refusal(409, 'cue-is-cut', 'SW-001 is cut')
  await userEvent.keyboard('jc')
  const form = await screen.findByRole('form', { name: 'How heavy?' })
  await userEvent.type(within(form).getByRole('textbox'), 'as a piano{Enter}')
  expect(await screen.findByText('SW-001 is cut.')).toBeInTheDocument()
  expect(within(form).getByRole('textbox')).toHaveValue('as a piano')
})

test('a designer reads what is open and has no key for it', async () => {
  await opened('designer')
  await userEvent.keyboard('jc')
  expect(screen.queryByRole('button', { name: /^Answer what is unclear/ })).not.toBeInTheDocument()
  expect(screen.queryByRole('region', { name: /What is unclear/ })).not.toBeInTheDocument()
})
