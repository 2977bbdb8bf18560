import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import type { Asked } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

const AT = '2026-11-20T10:00:00Z'
const PRODUCER = { id: 'someone', name: 'Producer' }
const MAKER = { id: 'maker', name: 'First designer' }
const NEXT = { id: 'next', name: 'Second designer' }
const TAKE = { id: 't1', file_name: 'splash.wav', variation: 1, number: 1, state: 'returned', received_at: AT }
const SESSION = { id: 'f1', kind: 'session', file_name: 'splash.rpp', file_bytes: 9, sha256: 's', received_at: AT }

const aHandoff = (more: object = {}) => ({
  id: 'h1',
  cue_id: 'c1',
  done_percent: 75,
  missing: 'The tail.',
  created_at: AT,
  written_by: MAKER,
  maker: MAKER,
  next_maker: null,
  closed: null,
  takes: [{ ...TAKE, plug_ins: ['Pro-Q 3'], recipe: 'Two bowls.', source_files: [SESSION] }],
  ...more,
})

beforeAll(() => import('./CuePage'))

function opened(part: 'team' | 'designer', handoffs: object[], maker = MAKER) {
  const server = new ListServer([aCue(1, 'splash')], {}, part)
  const { id } = server.cue('splash')
  server.answers[`GET ${server.at}/desk`] = { came_back: [], unmatched: 0, checking: 0 }
  server.answers[`GET /v1/cues/${id}`] = { ...server.cue('splash'), project_id: server.projectId, questions: [] }
  server.answers[`GET /v1/cues/${id}/handoffs`] = () => handoffs
  server.answers[`GET ${server.at}/takes`] = {
    items: [{ ...TAKE, designer: maker, alternate: null, label: null, verdict_reasons: [], note: '' }],
    next: null,
  }
  server.answers[`GET ${server.at}/cue-people`] = [
    { ...PRODUCER, is_designer: false },
    { ...MAKER, is_designer: true },
    { ...NEXT, is_designer: true },
  ]
  openApp(`${server.path}/cues/${id}`)
  return { server, id, card: () => screen.findByRole('region', { name: 'Hand-off' }) }
}

test('the next maker sees what is missing, the versions and the source bank', async () => {
  const { card } = opened('designer', [aHandoff({ next_maker: { id: 'someone', name: 'Sound designer' } })])
  const shown = await card()
  expect(within(shown).getByText('75 % done')).toBeVisible()
  expect(within(shown).getByText('Missing: The tail.')).toBeVisible()
  expect(within(shown).getByRole('link', { name: 'Download splash.wav, version 1' })).toHaveAttribute(
    'href',
    '/v1/handoffs/h1/takes/t1/master',
  )
  expect(within(shown).getByRole('link', { name: 'Download splash.rpp' })).toHaveAttribute(
    'href',
    '/v1/handoffs/h1/source-files/f1',
  )
  expect(within(shown).queryByRole('combobox')).toBeNull()
  expect((await axe.run(shown)).violations).toEqual([])
})

test('files that are closed are not offered, and say why', async () => {
  const { card } = opened('designer', [aHandoff({ closed: 'it is not paid yet' })])
  const shown = await card()
  expect(within(shown).getByText(/it is not paid yet/)).toBeVisible()
  expect(within(shown).queryByRole('link')).toBeNull()
})

test('a maker says how much is done and what is missing', async () => {
  const handoffs: object[] = []
  const { server, id, card } = opened('designer', handoffs, { id: 'someone', name: 'Sound designer' })
  server.answers[`POST /v1/cues/${id}/handoffs`] = () => {
    handoffs.push(aHandoff())
    return aHandoff()
  }
  const shown = await card()
  await userEvent.click(within(shown).getByRole('button', { name: 'Hand off this cue' }))
  const percent = within(shown).getByLabelText('Done, in percent')
  await userEvent.clear(percent)
  await userEvent.type(percent, '75')
  await userEvent.type(within(shown).getByLabelText('What is missing'), 'The tail.')
  await userEvent.click(within(shown).getByRole('button', { name: 'Hand off' }))
  expect(await within(shown).findByText('75 % done')).toBeVisible()
  expect(server.sent('POST', `/v1/cues/${id}/handoffs`)[0]?.body).toEqual({
    done_percent: 75,
    missing: 'The tail.',
    from_id: null,
  })
})

test('a producer names who continues: a designer who did not make it', async () => {
  const { server, card } = opened('team', [aHandoff()])
  server.answers['PUT /v1/handoffs/h1/next-maker'] = ({ body }: Asked) => aHandoff({ next_maker: NEXT, body })
  const select = within(await card()).getByRole('combobox', { name: 'Continued by' })
  await waitFor(() =>
    expect(
      within(select)
        .getAllByRole('option')
        .map((each) => each.textContent),
    ).toContain(NEXT.name),
  )
  expect(
    within(select)
      .getAllByRole('option')
      .map((each) => each.textContent),
  ).not.toContain(MAKER.name)
  await userEvent.selectOptions(select, NEXT.name)
  await waitFor(() =>
    expect(server.sent('PUT', '/v1/handoffs/h1/next-maker')[0]?.body).toEqual({ designer_id: 'next' }),
  )
})
