import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import checks from '@/test/checks.json'
import { openApp } from '@/test/openApp'
import { aSpec, inProject, TABLES } from '@/test/project'
import { type Answers, type Asked, serve, wrote } from '@/test/server'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

const NOTHING_PROPOSED = { based_on_version: 3, brief_revision: 1, toml: '', changes: [], errors: [] }
const SAVE_FORM = 'POST /v1/projects/p1/spec/form'

async function openSpec(more: Answers = {}) {
  const server = serve(
    inProject('producer', {
      'GET /v1/checks': checks,
      'GET /v1/projects/p1/brief/spec': NOTHING_PROPOSED,
      ...more,
    }),
  )
  const app = openApp('/projects/p1/spec')
  await screen.findByRole('heading', { name: 'Every sound' })
  return { ...server, ...app }
}

test('a sentence is edited by keys, and saved without leaving the page', { tags: ['slow'] }, async () => {
  const { asked, at } = await openSpec({
    [SAVE_FORM]: ({ body }: Asked) => aSpec({ version: 4, tables: (body as { tables: unknown }).tables }),
  })
  const main = within(document.querySelector('main') ?? document.body)
  const controls = ['button', 'link', 'textbox', 'combobox', 'checkbox', 'radio'].flatMap((role) =>
    main.queryAllByRole(role),
  )
  expect(controls.length).toBeLessThanOrEqual(20)
  for (let step = 0; step < 4; step += 1) await userEvent.keyboard('j')
  expect(screen.getByRole('button', { name: 'Edit Levels' })).toHaveFocus()
  await userEvent.keyboard('{Enter}')
  const field = screen.getByLabelText('True peak, dBTP')
  await userEvent.clear(field)
  await userEvent.type(field, '-2.5')
  expect(screen.getByText('−2.5 dBTP', { selector: 'b' })).toBeVisible()
  await userEvent.keyboard('{Control>}s{/Control}')
  await waitFor(() => expect(wrote(asked, SAVE_FORM)).toHaveLength(1))
  expect(wrote(asked, SAVE_FORM)[0]?.body).toMatchObject({
    tables: { ...TABLES, limits: { ...TABLES.limits, true_peak_dbtp: -2.5 } },
    based_on_version: 3,
  })
  expect(at()).toBe('/projects/p1/spec')
})

test('answers of the brief that differ are said as sentences, and used by one press', { tags: ['slow'] }, async () => {
  const changes = [{ place: 'engine.adds', before: null, after: ['reverb'], number: 9, question: 'adds', lines: [] }]
  const { asked } = await openSpec({
    'GET /v1/projects/p1/brief/spec': { ...NOTHING_PROPOSED, changes },
    'POST /v1/projects/p1/brief/spec': { version: 4 },
  })
  const brief = within(await screen.findByRole('region', { name: 'From the brief' }))
  expect(brief.getByText(/Sounds come dry, because the game adds the reverb/)).toBeVisible()
  expect(brief.getByText('From question 9 of the brief.')).toBeVisible()
  await userEvent.click(brief.getByRole('button', { name: 'Use the answer' }))
  await waitFor(() =>
    expect(wrote(asked, 'POST /v1/projects/p1/brief/spec')[0]?.body).toEqual({
      based_on_version: 3,
      brief_revision: 1,
    }),
  )
})
