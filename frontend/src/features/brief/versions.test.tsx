import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { type Asked, serve } from '@/test/server'

const aVersion = (number: number) => ({
  number,
  note: number === 1 ? 'For the first call.' : '',
  publisher: { id: 'x1', name: 'Producer' },
  published_at: '2026-11-20T10:00:00Z',
  answered: number,
  total: 23,
})

/** Versions 2 and 1; the answer to question 1 differs between every two of them. */
function opened(path: string, versions = [aVersion(2), aVersion(1)]) {
  const { asked } = serve(
    inProject('producer', {
      'GET /v1/projects/p1/brief/versions': { items: versions, next: null },
      'GET /v1/projects/p1/brief/compare': ({ query }: Asked) => ({
        from_version: Number(query.get('from')),
        to_version: query.get('to') === null ? null : Number(query.get('to')),
        differences: [
          {
            question: 'genre',
            number: 1,
            text: 'What kind of game is it?',
            before: '',
            after: `to ${query.get('to') ?? 'now'}`,
          },
        ],
      }),
    }),
  )
  return { asked, app: openApp(path) }
}

test('the newest version is compared with the brief as it is now, and any two can be chosen', async () => {
  const { app } = opened('/projects/p1/brief/versions')
  const differences = await screen.findByRole('region', { name: 'What differs' })
  expect(await within(differences).findByText('to now')).toBeVisible()
  expect(within(differences).getByText('Open')).toHaveClass('struck')
  await userEvent.selectOptions(screen.getByRole('combobox', { name: 'From' }), 'Version 1')
  await userEvent.selectOptions(screen.getByRole('combobox', { name: 'To' }), 'Version 2')
  expect(await within(differences).findByText('to 2')).toBeVisible()
  await waitFor(() => expect(app.search()).toEqual({ from: 1, to: 2 }))
  expect(screen.getByText('For the first call.')).toBeVisible()
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
})

test('without a version it says what one is for, and compares nothing', async () => {
  const { asked } = opened('/projects/p1/brief/versions', [])
  expect(await screen.findByRole('heading', { name: 'No version is published yet' })).toBeVisible()
  expect(asked.filter(({ path }) => path.endsWith('/compare'))).toEqual([])
})
