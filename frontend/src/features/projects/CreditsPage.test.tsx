import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { keptDraft } from '@/app/drafts'
import { openApp } from '@/test/openApp'
import { aMe, aServer, PROJECT } from '@/test/review'
import { answer } from '@/test/server'

import type { Credits } from './credits'

const PAGE = `/projects/${PROJECT}/credits`
const ADDRESS = `/v1/projects/${PROJECT}/credits`
const quay = {
  role: 'Sound design',
  name: 'Quay Sound',
  person_id: 'designer',
  line_id: null,
  agreed_line: 'Sound design by Quay Sound',
}
const voice = { role: 'Voice', name: 'A. Performer', person_id: null, line_id: 'line-1', agreed_line: '' }
const aList = (more: Partial<Credits> = {}): Credits => ({
  credits: [quay, voice],
  left_out: 1,
  is_team: true,
  is_editor: true,
  my_name: '',
  my_account_name: 'Producer',
  am_left_out: false,
  ...more,
})
const opened = (credits: Credits, me = aMe({ is_producer: true })) => {
  const server = aServer()
    .on('GET /v1/me', me)
    .on('GET /v1/review-queue/count', { cues: 0, is_all: true })
    .on(`GET ${ADDRESS}`, credits)
  openApp(PAGE)
  return server
}

test('the team reads credits by role, downloads them, and adds a performer by hand', { tags: ['slow'] }, async () => {
  const server = opened(aList({ credits: [quay] }))
  expect(await screen.findByRole('list', { name: 'Sound design' })).toHaveTextContent(
    'The contract says: Sound design by Quay Sound',
  )
  expect(screen.getByText('1 person left out')).toBeVisible()
  expect(screen.getByRole('link', { name: 'CSV' })).toHaveAttribute('href', `${ADDRESS}.csv`)
  const form = within(screen.getByRole('form', { name: 'Add a name' }))
  await userEvent.type(form.getByLabelText('Role'), 'Voice')
  await userEvent.type(form.getByLabelText('Name'), 'A. Performer')
  expect(keptDraft(`credit-line:${PROJECT}`)).toEqual({ role: 'Voice', name: 'A. Performer' })
  server.on(`POST ${ADDRESS}`, answer(aList(), 201))
  await userEvent.click(form.getByRole('button', { name: 'Add name' }))
  expect(await screen.findByRole('button', { name: 'Remove A. Performer, Voice' })).toBeVisible()
  expect(form.getByLabelText('Role')).toHaveValue('')
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations).toEqual([])
})

test('a designer says how they are named, and that they are left out', async () => {
  const mine = aList({ credits: [quay], is_team: false, is_editor: false, left_out: 0, my_account_name: 'Designer' })
  const server = opened(mine, aMe({ part: 'designer' }))
  const form = within(await screen.findByRole('form', { name: 'Your name in the credits' }))
  expect(form.getByLabelText('Name')).toHaveAccessibleDescription('Empty: Designer, as in your account')
  expect(screen.queryByRole('link', { name: 'CSV' })).not.toBeInTheDocument()
  await userEvent.click(form.getByLabelText('Leave me out of the credits'))
  expect(form.getByLabelText('Name')).toBeDisabled()
  server.on(`PUT ${ADDRESS}/me`, { ...mine, credits: [], am_left_out: true, left_out: 1 })
  await userEvent.click(form.getByRole('button', { name: 'Save' }))
  expect(await screen.findByText('You are left out of the credits.')).toBeVisible()
  expect(screen.getByText('No credits yet')).toBeVisible()
})
