import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from './openApp'
import { answer, type Asked, serve, wrote } from './server'
import { aCue, ListServer } from './soundList'

const SIGN_UP = { open: true, by_mail: false, setup_code: false }

test('sign-up to the first cue takes 3 screens and 5 fields', async () => {
  const list = new ListServer([])
  const { answers, asked } = serve({ ...list.answers, 'GET /v1/sign-up': SIGN_UP })
  const me = answers['GET /v1/me'] as Record<string, unknown>
  const studios = [{ id: 's1', name: 'Studio', roles: ['producer'] }]
  answers['GET /v1/me'] = { ...me, studios, projects: [] }
  answers['GET /v1/session'] = { signed_in: false }
  answers['POST /v1/sign-up'] = () => {
    answers['GET /v1/session'] = { signed_in: true, demo: false, person: me.person }
    return answer(me.person, 201)
  }
  answers['POST /v1/projects'] = () => {
    answers['GET /v1/me'] = { ...me, studios }
    return answer({ id: list.projectId, name: 'Shield Wing' }, 201)
  }
  answers[`POST ${list.at}/sound-list/import`] = ({ body }: Asked) => {
    const isTrial = (body as { dry_run: boolean }).dry_run
    if (!isTrial) list.cues = [aCue(1, 'shield_hit')]
    return {
      header_row: 1,
      tabs: [],
      columns: [],
      rows: [],
      errors: [],
      left_out: [],
      refused_names: { names: [], patterns: [] },
      added: 1,
      changed: 0,
      same: 0,
      imported: !isTrial,
      revision: 1,
    }
  }
  const app = openApp('/sign-up')
  const screens = new Set<string>()
  let fields = 0
  const fill = async (label: RegExp, text: string) => {
    await userEvent.click(await screen.findByLabelText(label))
    await userEvent.paste(text)
    screens.add(app.at())
    fields += 1
  }
  await fill(/^Your name/, 'Producer')
  await fill(/^Work email/, 'producer@studio.example')
  await fill(/^Password/, 'four unrelated words here')
  await userEvent.keyboard('{Enter}')
  await fill(/^Game title/, 'Shield Wing')
  await userEvent.keyboard('{Enter}')
  await fill(/^One sound a line/, 'shield_hit')
  await userEvent.click(screen.getByRole('button', { name: /^Add 1 sound/ }))
  expect(await screen.findByRole('row', { name: /shield_hit/ })).toBeInTheDocument()
  expect([...screens]).toEqual(['/sign-up', '/projects/new', list.path])
  expect(fields).toBe(5)
  expect(wrote(asked, 'POST /v1/projects')).toHaveLength(1)
})

test('a newcomer may open the sample instead, which says so on its pages and goes by one press', async () => {
  const list = new ListServer([aCue(1, 'shield_hit')])
  const { answers, asked } = serve({ ...list.answers })
  const me = answers['GET /v1/me'] as { projects: object[] }
  const mine = { ...me, studios: [{ id: 's1', name: 'Studio', roles: ['producer'] }] }
  answers['GET /v1/me'] = { ...mine, projects: [] }
  answers['GET /v1/projects'] = { items: [], next: null }
  answers['POST /v1/studios/s1/sample'] = () => {
    answers['GET /v1/me'] = { ...mine, projects: [{ ...me.projects[0], name: 'Sample project', is_sample: true }] }
    return answer({ id: list.projectId, name: 'Sample project' }, 201)
  }
  answers[`DELETE ${list.at}/sample`] = () => {
    answers['GET /v1/me'] = { ...mine, projects: [] }
    return answer(undefined, 204)
  }
  const app = openApp('/projects/new')
  await userEvent.click(await screen.findByRole('radio', { name: /^A sample project/ }))
  expect(screen.queryByLabelText('Game title')).toBeNull()
  await userEvent.click(screen.getByRole('button', { name: 'Open sample project' }))
  await waitFor(() => expect(app.at()).toBe(list.path))
  expect(await screen.findByRole('complementary', { name: 'Sample project' })).toHaveTextContent(
    'This is the sample project',
  )
  await userEvent.click(screen.getByRole('button', { name: 'Delete sample' }))
  expect(await screen.findByText('Sample project deleted.')).toBeInTheDocument()
  await waitFor(() => expect(app.at()).not.toContain(list.projectId))
  expect(wrote(asked, `DELETE ${list.at}/sample`)).toHaveLength(1)
})
