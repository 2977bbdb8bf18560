import { screen, within, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aProject, inProject, people } from '@/test/project'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

beforeEach(() => {
  vi.stubGlobal('AudioContext', HandContext)
  localStorage.clear()
})

const CATEGORIES = [
  { category: '', cues: 4 },
  { category: 'ui', cues: 12 },
  { category: 'weapon', cues: 1 },
]
const DEPUTY = {
  id: 'd1',
  person: people.approver,
  deputy: people.producer,
  from_on: '2026-11-20',
  until_on: '2026-11-27',
}
const deputies = (...named: (typeof DEPUTY)[]) => ({
  time_zone: 'Europe/Berlin',
  today: '2026-11-20',
  deputies: named,
})

test('a category gets its own approver, and undo gives it back', { tags: ['slow'] }, async () => {
  const { asked } = serve({
    ...inProject(),
    'GET /v1/projects/p1/categories': CATEGORIES,
    'PUT /v1/projects/p1/category-approvers': ({ body }: Asked) => {
      const { category, person_id } = body as { category: string; person_id: string | null }
      const own = person_id === null ? [] : [{ category, approver: people.producer }]
      return aProject('producer', { category_approvers: own })
    },
  })
  openApp('/projects/p1/approvers')
  const list = await screen.findByRole('list', { name: 'Categories' })
  const rows = await within(list).findAllByRole('listitem')
  expect(rows.map((row) => row.querySelector('.grow')?.textContent)).toEqual(['ui12 cues', 'weapon1 cue'])
  const ui = within(list).getByRole('combobox', { name: 'Approver of ui' })
  expect(ui).toHaveValue('Audio director (project)')
  await userEvent.click(ui)
  await userEvent.click(await screen.findByRole('option', { name: 'Producer' }))
  expect(await screen.findByText('Producer approves ui now.')).toBeVisible()
  expect(ui).toHaveValue('Producer')
  await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
  await waitFor(() => expect(ui).toHaveValue('Audio director (project)'))
  expect(wrote(asked, 'PUT /v1/projects/p1/category-approvers').map(({ body }) => body)).toEqual([
    { category: 'ui', person_id: people.producer.id },
    { category: 'ui', person_id: null },
  ])
})

test('without categories it is said who approves, with the way to the list', async () => {
  serve({ ...inProject(), 'GET /v1/projects/p1/categories': [{ category: '', cues: 4 }] })
  openApp('/projects/p1/approvers')
  expect(await screen.findByText(/^Audio director approves every sound\./)).toBeVisible()
  expect(screen.getByRole('link', { name: 'Go to the sound list' })).toBeVisible()
})

test('who names nobody sees who approves what', async () => {
  serve({
    ...inProject('reviewer', {
      'GET /v1/projects/p1': aProject('reviewer', {
        category_approvers: [{ category: 'ui', approver: people.composer }],
      }),
      'GET /v1/projects/p1/categories': CATEGORIES,
      'GET /v1/projects/p1/deputies': deputies(DEPUTY),
    }),
  })
  openApp('/projects/p1/approvers')
  const list = await screen.findByRole('list', { name: 'Categories' })
  expect(within(list).getByText('Composer')).toBeVisible()
  expect(within(list).queryByRole('combobox')).toBeNull()
  expect(screen.getByText('approves or returns every other sound')).toBeVisible()
  expect(await screen.findByText('Producer for Audio director')).toBeVisible()
  expect(screen.queryByRole('form', { name: 'Name a deputy' })).toBeNull()
})

test('a designer sees who approves which category', async () => {
  serve({
    ...inProject('designer', {
      'GET /v1/projects/p1': aProject('designer', {
        category_approvers: [{ category: 'ui', approver: people.composer }],
      }),
    }),
  })
  openApp('/projects/p1/people')
  expect(await screen.findByText(/^Audio director is the approver, Composer of ui\./)).toBeVisible()
})

test('a deputy is named for some days, is shown, and is withdrawn', { tags: ['slow'] }, async () => {
  const { asked, answers } = serve({
    ...inProject(),
    'POST /v1/projects/p1/deputies': answer(DEPUTY, 201),
    'DELETE /v1/projects/p1/deputies/d1': answer(null, 204),
  })
  openApp('/projects/p1/approvers')
  expect(await screen.findByText('No deputies named')).toBeVisible()
  const form = within(screen.getByRole('form', { name: 'Name a deputy' }))
  expect(form.getByRole('combobox', { name: 'In place of' })).toHaveValue('Audio director')
  await userEvent.click(form.getByRole('button', { name: 'Name deputy' }))
  expect(form.getByRole('combobox', { name: 'Deputy' })).toHaveAccessibleDescription('Deputy is required.')
  expect(form.getAllByText('Enter a date.')).toHaveLength(2)
  await userEvent.click(form.getByRole('combobox', { name: 'Deputy' }))
  await userEvent.click(await screen.findByRole('option', { name: 'Producer' }))
  await userEvent.type(form.getByLabelText('First day'), '2026-11-20')
  await userEvent.type(form.getByLabelText('Last day'), '2026-11-27')
  answers['GET /v1/projects/p1/deputies'] = deputies(DEPUTY)
  await userEvent.click(form.getByRole('button', { name: 'Name deputy' }))
  const list = await screen.findByRole('list', { name: 'Deputies' })
  expect(await within(list).findByText('Producer for Audio director')).toBeVisible()
  expect(within(list).getByText('Approves today')).toBeVisible()
  expect(wrote(asked, 'POST /v1/projects/p1/deputies')[0]?.body).toEqual({
    person_id: people.approver.id,
    deputy_id: people.producer.id,
    from_on: '2026-11-20',
    until_on: '2026-11-27',
  })
  answers['GET /v1/projects/p1/deputies'] = deputies()
  await userEvent.click(within(list).getByRole('button', { name: 'Withdraw Producer for Audio director' }))
  expect(await screen.findByText('Producer is no longer a deputy for Audio director.')).toBeVisible()
  expect(await screen.findByText('No deputies named')).toBeVisible()
})

test('a refused day keeps what was chosen, with the reason below', async () => {
  const message = 'the last day is over'
  serve({
    ...inProject(),
    'POST /v1/projects/p1/deputies': refusal(422, 'bad-deputy', message, { errors: [{ where: 'until_on', message }] }),
  })
  openApp('/projects/p1/approvers')
  const form = within(await screen.findByRole('form', { name: 'Name a deputy' }))
  await userEvent.click(form.getByRole('combobox', { name: 'Deputy' }))
  await userEvent.click(await screen.findByRole('option', { name: 'Producer' }))
  await userEvent.type(form.getByLabelText('First day'), '2026-11-18')
  await userEvent.type(form.getByLabelText('Last day'), '2026-11-19')
  await userEvent.click(form.getByRole('button', { name: 'Name deputy' }))
  expect(await form.findByText('The last day is over.')).toBeVisible()
  expect(form.getByLabelText('Last day')).toHaveValue('2026-11-19')
})
