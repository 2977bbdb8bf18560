import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { asPerson, DESIGNER, PRODUCER } from '@/test/account'
import { openApp } from '@/test/openApp'
import { type Asked, refusal, serve } from '@/test/server'

const ACCOUNT = {
  name: DESIGNER.person.name,
  confirmation: DESIGNER.email,
  obstacles: [] as string[],
  deleted: ['your name, address, password and picture', '2 sign-ins'],
  kept: [{ name: '3 signatures', reason: 'evidence of a contract; with the name as signed' }],
  grace_days: 0,
  due_at: null as string | null,
  requested_by: null as string | null,
}
const PROJECT = {
  ...ACCOUNT,
  name: 'Shield Wing',
  confirmation: 'Shield Wing',
  deleted: ['12 sounds'],
  grace_days: 7,
}

test('a person sees what goes and what stays, is refused a wrong address, and erases their account', async () => {
  const server = serve(
    asPerson(DESIGNER, {
      'GET /v1/me/erasure': ACCOUNT,
      'POST /v1/me/erasure': ({ body }: Asked) =>
        (body as { confirmation: string }).confirmation === DESIGNER.email
          ? refusal(403, 'not-in-demo', 'the people of the demo cannot be erased')
          : refusal(422, 'confirmation-mismatch', 'type it', {
              errors: [{ where: 'confirmation', message: 'type it to confirm' }],
            }),
    }),
  )
  const user = userEvent.setup()
  openApp('/erase/account')
  const deleted = within(await screen.findByRole('region', { name: 'Deleted' }))
  expect(deleted.getAllByRole('listitem').map(({ textContent }) => textContent)).toEqual(ACCOUNT.deleted)
  expect(within(screen.getByRole('region', { name: 'Kept' })).getByRole('listitem')).toHaveTextContent(
    '3 signatures evidence of a contract',
  )
  const field = screen.getByLabelText(`Type ${DESIGNER.email} to confirm`)
  await user.click(field)
  await user.paste('someone@else.example')
  await user.click(screen.getByRole('button', { name: 'Erase account' }))
  expect(await screen.findByText('Type it to confirm.')).toBeVisible()
  await user.clear(field)
  await user.paste(DESIGNER.email)
  await user.keyboard('{Enter}')
  expect(await screen.findByText('The people of the demo cannot be erased.')).toBeVisible()
  expect(server.asked.filter(({ method }) => method === 'POST').map(({ body }) => body)).toEqual([
    { confirmation: 'someone@else.example' },
    { confirmation: DESIGNER.email },
  ])
})

test('what must end first stands in place of the form', async () => {
  const obstacles = ['Your account is a member of Shield Wing studio: a producer removes them first']
  serve(asPerson(PRODUCER, { 'GET /v1/me/erasure': { ...ACCOUNT, obstacles } }))
  openApp('/erase/account')
  const card = within(await screen.findByRole('region', { name: 'Cannot be erased yet' }))
  expect(card.getByRole('listitem')).toHaveTextContent('is a member of Shield Wing studio')
  expect(screen.queryByRole('button', { name: 'Erase account' })).toBeNull()
})

test('a producer requests the erasure of a project, sees the day, and keeps the project', async () => {
  let isDue = false
  const server = serve(
    asPerson(PRODUCER, {
      'GET /v1/projects/p1/erasure': () =>
        isDue ? { ...PROJECT, due_at: '2099-12-06T09:00:00Z', requested_by: 'Producer' } : PROJECT,
      'POST /v1/projects/p1/erasure': () => {
        isDue = true
        return PROJECT
      },
      'DELETE /v1/projects/p1/erasure': () => {
        isDue = false
        return null
      },
    }),
  )
  const user = userEvent.setup()
  openApp('/erase/projects/p1')
  expect(await screen.findByRole('heading', { level: 1, name: 'Erase Shield Wing' })).toBeVisible()
  await user.click(screen.getByLabelText('Type Shield Wing to confirm'))
  await user.paste('Shield Wing')
  await user.click(screen.getByRole('button', { name: 'Erase project' }))
  const due = within(await screen.findByRole('region', { name: /^Will be erased on .*6 December 2099$/ }))
  expect(due.getByText('Requested by Producer. Nothing changes before that day.')).toBeVisible()
  await user.click(due.getByRole('button', { name: 'Keep Shield Wing' }))
  expect(await screen.findByText('Shield Wing is kept.')).toBeVisible()
  await waitFor(() => expect(screen.getByRole('button', { name: 'Erase project' })).toBeVisible())
  expect(server.asked.some(({ method }) => method === 'DELETE')).toBe(true)
})

test.each([
  ['/account', 'Erase your account', '/erase/account'],
  ['/studio', 'Erase the studio', '/erase/studios/s1'],
])('%s leads to it', async (page, title, to) => {
  serve(asPerson(PRODUCER))
  openApp(page)
  const card = within(await screen.findByRole('region', { name: title }))
  expect(card.getByRole('link', { name: 'See what is deleted and what stays' })).toHaveAttribute('href', to)
})
