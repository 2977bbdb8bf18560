import { cleanup, screen, within, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { type Asked, refusal, serve, wrote } from '@/test/server'

beforeEach(() => {
  localStorage.clear()
})

const SETTINGS = {
  blockers: 'none',
  checklists: [{ category: 'ui', items: [{ id: 'i1', category: 'ui', text: 'Short' }] }],
}
const card = () => screen.findByRole('region', { name: 'Before approval' })

test('a producer writes the checklist of a category and says what blocks approval', async () => {
  const { asked } = serve({
    ...inProject(),
    'GET /v1/projects/p1/categories': [{ category: 'ui', cues: 12 }],
    'GET /v1/projects/p1/approval-settings': SETTINGS,
    'PUT /v1/projects/p1/checklist': ({ body }: Asked) => {
      const { category, items } = body as { category: string; items: string[] }
      return { ...SETTINGS, checklists: [{ category, items: items.map((text) => ({ id: text, category, text })) }] }
    },
    'PUT /v1/projects/p1/approval-blockers': { ...SETTINGS, blockers: 'both' },
  })
  openApp('/projects/p1/approval')
  const before = within(await card())
  await userEvent.selectOptions(await before.findByLabelText('Checklist of'), 'ui')
  const items = before.getByLabelText('Items for ui')
  expect(items).toHaveValue('Short')
  await userEvent.type(items, '\n Not harsh \n')
  await userEvent.click(before.getByRole('button', { name: 'Save checklist' }))
  expect(await screen.findByText('The checklist of ui is saved.')).toBeVisible()
  expect(wrote(asked, 'PUT /v1/projects/p1/checklist')[0]?.body).toEqual({
    category: 'ui',
    items: ['Short', 'Not harsh'],
  })
  await userEvent.selectOptions(before.getByLabelText(/A version is not approved/), 'both')
  await waitFor(() =>
    expect(wrote(asked, 'PUT /v1/projects/p1/approval-blockers')[0]?.body).toEqual({ blockers: 'both' }),
  )
})

test('what was typed stays when it is refused, and after a reload', async () => {
  serve({
    ...inProject(),
    'GET /v1/projects/p1/categories': [],
    'GET /v1/projects/p1/approval-settings': { ...SETTINGS, checklists: [] },
    'PUT /v1/projects/p1/checklist': () => refusal(422, 'checklist-invalid', '“Short” is in the checklist twice.'),
  })
  openApp('/projects/p1/approval')
  await userEvent.type(await within(await card()).findByLabelText('Items for every cue'), 'Short\nShort')
  await userEvent.click(screen.getByRole('button', { name: 'Save checklist' }))
  expect(await screen.findByText('“Short” is in the checklist twice.')).toBeVisible()
  cleanup()
  openApp('/projects/p1/approval')
  expect(await within(await card()).findByLabelText('Items for every cue')).toHaveValue('Short\nShort')
  expect(screen.getByText(/Draft restored/)).toBeVisible()
})

test('who is not a producer reads what is checked and what blocks', async () => {
  serve({
    ...inProject('reviewer'),
    'GET /v1/projects/p1/categories': [{ category: 'ui', cues: 12 }],
    'GET /v1/projects/p1/approval-settings': { ...SETTINGS, blockers: 'items' },
  })
  openApp('/projects/p1/approval')
  const before = within(await card())
  expect(await before.findByText('Unchecked items')).toBeVisible()
  await userEvent.selectOptions(before.getByLabelText('Checklist of'), 'ui')
  expect(before.getByRole('list', { name: 'Items' })).toHaveTextContent('Short')
  expect(before.queryByRole('button', { name: 'Save checklist' })).toBeNull()
})
