import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, expect, test } from 'vitest'

import { refusal } from '@/test/server'
import { aVersion } from '@/test/take'
import { opened, server, serveTakePage } from '@/test/takePage'

beforeAll(() => import('./TakePage'))
serveTakePage()

const form = async () => within(await screen.findByRole('form', { name: 'Label' }))
const put = () => server.of('PUT /v1/takes/t1/label').map(({ body }) => body)

test('a version is labelled in words of its own, and the label is taken away', async () => {
  const user = userEvent.setup()
  server.on('PUT /v1/takes/t1/label', ({ body }: { body: { label: string | null } }) => {
    server.on('GET /v1/takes/t1', aVersion({ label: body.label }))
    return { ...body, labelled_by: null, labelled_at: null }
  })
  await opened()
  await user.type((await form()).getByLabelText('Label'), ' wilder {Enter}')
  expect(await screen.findByText('Labelled “wilder”.')).toBeVisible()
  expect(await screen.findByText(/, wilder/)).toBeVisible()
  await user.clear((await form()).getByLabelText('Label'))
  await user.click((await form()).getByRole('button', { name: 'Take away' }))
  expect(await screen.findByText('The label is gone.')).toBeVisible()
  expect(put()).toEqual([{ label: 'wilder' }, { label: null }])
})

test('what was typed stays when it is refused', async () => {
  const user = userEvent.setup()
  server.on('PUT /v1/takes/t1/label', () => refusal(404, 'take-not-found', 'No such version.'))
  await opened()
  await user.type((await form()).getByLabelText('Label'), 'dry{Enter}')
  expect(await (await form()).findByText('No such version.')).toBeVisible()
  expect((await form()).getByLabelText('Label')).toHaveValue('dry')
})
