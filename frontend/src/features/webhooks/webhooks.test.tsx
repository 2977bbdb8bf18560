import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test } from 'vitest'

import { forgetDrafts } from '@/app/drafts'
import { openApp } from '@/test/openApp'
import { answer, type Answers, type Asked, refusal, serve, wrote } from '@/test/server'

import type { Call, Webhook } from './api'
import { EVENTS } from './words'

const ME = {
  person: { id: 'me', name: 'Producer', email: 'p@studio.example' },
  studios: [{ id: 's1', name: 'Test studio', roles: ['producer'] }],
  projects: [],
  is_operator: false,
}
const aWebhook = (more: Partial<Webhook> = {}): Webhook => ({
  id: 'w1',
  url: 'https://hooks.example.com/in',
  form: 'json',
  events: ['take.approved'],
  project: null,
  created_at: '2026-11-20T10:00:00Z',
  failing_since: null,
  disabled_at: null,
  old_secret_until: null,
  ...more,
})
const aCall = (more: Partial<Call> = {}): Call => ({
  id: 'c1',
  event: 'take.approved',
  state: 'failed',
  tries: 10,
  created_at: '2026-11-20T10:00:00Z',
  tried_at: '2026-11-23T10:00:00Z',
  next_at: null,
  took_ms: 120,
  status: 500,
  answer: 'out of order',
  problem: 'answered 500',
  body: '{"type": "take.approved"}',
  attempts: [],
  ...more,
})

let asked: Asked[]
let answers: Answers
const list = (...items: Webhook[]) => ({
  items,
  projects: [{ id: 'p1', name: 'Shield Wing' }],
  may_be_localhost: false,
})

beforeEach(() => {
  forgetDrafts()
  ;({ asked, answers } = serve({
    'GET /v1/session': { signed_in: true, demo: false },
    'GET /v1/me': ME,
    'GET /v1/studios/s1/webhooks': list(aWebhook()),
    'GET /v1/webhooks/w1/calls': { items: [aCall()], next: null },
    'POST /v1/studios/s1/webhooks': answer({ ...aWebhook({ id: 'w2' }), secret: 'whsec_abc' }, 201),
    'POST /v1/webhooks/w1/test': answer(aCall({ event: 'webhook.test', state: 'waiting' }), 202),
    'POST /v1/webhook-calls/c1/replay': answer(aCall({ state: 'waiting' }), 202),
    'POST /v1/webhooks/w1/secret': { ...aWebhook(), secret: 'whsec_new' },
    'PATCH /v1/webhooks/w1': aWebhook({ disabled_at: '2026-11-20T10:00:00Z' }),
    'DELETE /v1/webhooks/w1': answer(null, 204),
  }))
})

test(
  'an address is added for some events of one project, and its secret is shown once',
  { tags: ['slow'] },
  async () => {
    const user = userEvent.setup()
    openApp('/webhooks')
    const form = await screen.findByRole('form', { name: 'Add an address' })
    expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
    await user.type(within(form).getByRole('textbox', { name: 'Address' }), 'https://chat.example/in')
    await user.selectOptions(within(form).getByLabelText('Message'), 'slack')
    await user.selectOptions(within(form).getByLabelText('Project'), 'p1')
    await user.click(within(form).getByRole('checkbox', { name: 'A payment is recorded' }))
    await user.click(within(form).getByRole('button', { name: 'Add the address' }))
    expect(await screen.findByText('whsec_abc')).toBeVisible()
    expect(wrote(asked, 'POST /v1/studios/s1/webhooks')[0]?.body).toEqual({
      url: 'https://chat.example/in',
      form: 'slack',
      project_id: 'p1',
      events: EVENTS.filter((event) => event !== 'payment.recorded'),
    })
    await user.click(screen.getByRole('button', { name: 'I’ve saved it' }))
    expect(screen.queryByText('whsec_abc')).toBeNull()
  },
)

test('a refused address stays in its field with the reason', async () => {
  const user = userEvent.setup()
  const message = '10.0.0.5 is not a public address'
  answers['POST /v1/studios/s1/webhooks'] = refusal(422, 'webhook-address-refused', message, {
    errors: [{ where: 'url', message }],
  })
  openApp('/webhooks')
  const field = await screen.findByRole('textbox', { name: 'Address' })
  await user.type(field, 'https://10.0.0.5/')
  await user.click(screen.getByRole('button', { name: 'Add the address' }))
  expect(await screen.findByText(`${message}.`)).toBeVisible()
  expect(field).toHaveValue('https://10.0.0.5/')
})

test('the log says what was answered, and sends again', async () => {
  const user = userEvent.setup()
  openApp('/webhooks')
  await user.click(await screen.findByRole('button', { name: /^Log/ }))
  const log = await screen.findByRole('region', { name: 'Log of hooks.example.com' })
  await user.click(await within(log).findByText('answered 500'))
  expect(within(log).getByText('out of order')).toBeVisible()
  expect(within(log).getByText(/10 attempts, the last took 120 ms, answered 500/)).toBeVisible()
  await user.click(within(log).getByRole('button', { name: /^Send again/ }))
  await waitFor(() => expect(wrote(asked, 'POST /v1/webhook-calls/c1/replay')).toHaveLength(1))
})

test('each attempt at a message is in its log', async () => {
  const user = userEvent.setup()
  const attempts = [
    { tried_at: '2026-11-20T10:00:00Z', took_ms: 120, status: 500, answer: 'out of order', problem: 'answered 500' },
    { tried_at: '2026-11-20T10:00:05Z', took_ms: 9, status: null, answer: '', problem: 'the connection was refused' },
    { tried_at: '2026-11-20T10:05:05Z', took_ms: 40, status: 200, answer: 'taken', problem: '' },
  ]
  const call = aCall({ state: 'delivered', tries: 3, status: 200, answer: 'taken', problem: '', attempts })
  answers['GET /v1/webhooks/w1/calls'] = { items: [call], next: null }
  openApp('/webhooks')
  await user.click(await screen.findByRole('button', { name: /^Log/ }))
  await user.click(await screen.findByText('Delivered'))
  const log = await screen.findByRole('list', { name: 'Attempts' })
  const rows = within(log).getAllByRole('listitem')
  expect(rows[0]).toHaveTextContent(/answered 500, in 120 ms.*out of order/)
  expect(rows[1]).toHaveTextContent(/the connection was refused, in 9 ms/)
  expect(rows[2]).toHaveTextContent(/answered 200, in 40 ms.*taken/)
})

test('a test is sent, a secret replaced, an address disabled, and deleted after a question', async () => {
  const user = userEvent.setup()
  openApp('/webhooks')
  await user.click(await screen.findByRole('button', { name: /^Send a test/ }))
  await waitFor(() => expect(wrote(asked, 'POST /v1/webhooks/w1/test')).toHaveLength(1))
  await user.click(screen.getByRole('button', { name: /^New secret/ }))
  expect(await screen.findByText('whsec_new')).toBeVisible()
  await user.click(screen.getByRole('button', { name: /^Disable/ }))
  await waitFor(() => expect(wrote(asked, 'PATCH /v1/webhooks/w1')[0]?.body).toEqual({ enabled: false }))
  await user.click(screen.getByRole('button', { name: /^Delete/ }))
  expect(wrote(asked, 'DELETE /v1/webhooks/w1')).toHaveLength(0)
  await user.click(screen.getByRole('button', { name: 'Delete it and its log' }))
  await waitFor(() => expect(wrote(asked, 'DELETE /v1/webhooks/w1')).toHaveLength(1))
})

test('what is disabled says so, and can be enabled', async () => {
  answers['GET /v1/studios/s1/webhooks'] = list(aWebhook({ disabled_at: '2026-11-20T10:00:00Z' }))
  openApp('/webhooks')
  expect(await screen.findByText(/^Disabled/)).toBeVisible()
  expect(screen.getByRole('button', { name: /^Enable/ })).toBeVisible()
  expect(screen.queryByRole('button', { name: /^Send a test/ })).toBeNull()
})

test('who runs no studio reads what webhooks are', async () => {
  answers['GET /v1/me'] = { ...ME, studios: [] }
  openApp('/webhooks')
  expect(await screen.findByRole('heading', { name: 'Webhooks are for producers' })).toBeVisible()
})
