import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, type Asked, refusal } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

beforeAll(() => import('./SoundListPage'))

const COLUMNS = [
  { id: 'c-mood', name: 'Mood', kind: 'choice', choices: ['calm', 'tense'] },
  { id: 'c-weight', name: 'Weight', kind: 'number', choices: [] },
]

function served(part: 'team' | 'designer' = 'team') {
  const server = new ListServer(
    [
      aCue(1, 'shield_hit', { extra: { Mood: 'calm' } }),
      aCue(2, 'airlock_cycle', { need: 'should' }),
      aCue(3, 'void_whale', { need: 'wish', description: 'Heard once' }),
    ],
    { shield_hit: { status: 'accepted', accepted: 1 } },
    part,
  )
  server.answers[`GET ${server.at}/sound-list/columns`] = { columns: COLUMNS, edition: 'e1' }
  for (const { id, name } of server.cues) {
    server.answers[`PATCH /v1/cues/${id}`] = ({ body }: Asked) => {
      const cue = server.cue(name)
      return Object.assign(cue, body, { edition: cue.edition + 1 })
    }
  }
  return server
}

const row = (name: string) => screen.findByRole('row', { name: new RegExp(name) })
const changes = (server: ListServer, name: string) =>
  server.sent('PATCH', `/v1/cues/${server.cue(name).id}`).map(({ body }) => body)

describe('need', () => {
  test('each cue says its need, and m changes it, to be undone', async () => {
    const server = served()
    openApp(server.path)
    expect(within(await row('void_whale')).getByText('wish')).toBeInTheDocument()
    await userEvent.keyboard('jm')
    expect(await screen.findByText('shield_hit is a should.')).toBeInTheDocument()
    expect(within(await row('shield_hit')).getByText('should')).toBeInTheDocument()
    await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
    expect(within(await row('shield_hit')).getByText('must')).toBeInTheDocument()
    expect(changes(server, 'shield_hit')).toEqual([
      { edition: 1, need: 'should' },
      { edition: 2, need: 'must' },
    ])
  })

  test('the head counts accepted cues by need, and the filter leaves one need', async () => {
    const app = openApp(served().path)
    const sums = await screen.findByRole('list', { name: 'Accepted by need' })
    await waitFor(() => expect(within(sums).getByText('1 of 1')).toBeInTheDocument())
    expect(within(sums).getAllByRole('listitem')).toHaveLength(3)
    await userEvent.click(await screen.findByRole('button', { name: 'Filter' }))
    await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Need' }), 'Wish')
    await waitFor(() => expect(app.search()).toEqual({ need: 'wish' }))
    await waitFor(() => expect(screen.queryByRole('link', { name: 'shield_hit' })).not.toBeInTheDocument())
    expect(screen.getByRole('link', { name: 'void_whale' })).toBeInTheDocument()
  })

  test('a designer reads it, and m does nothing', async () => {
    const server = served('designer')
    server.answers[`GET ${server.at}/desk`] = { came_back: [], unmatched: 0, checking: 0 }
    openApp(server.path)
    await row('shield_hit')
    await userEvent.keyboard('jm')
    expect(changes(server, 'shield_hit')).toEqual([])
  })
})

describe('columns of the project’s own', () => {
  const content = async (server: ListServer) => {
    openApp(`${server.path}?view=content`)
    await screen.findByRole('columnheader', { name: 'Mood' })
  }

  test('they are shown under Content, and a value is typed in the table', { tags: ['slow'] }, async () => {
    const server = served()
    openApp(server.path)
    await row('shield_hit')
    await userEvent.click(screen.getByRole('button', { name: 'Display' }))
    await userEvent.click(screen.getByRole('button', { name: 'Content' }))
    await screen.findByRole('columnheader', { name: 'Weight' })
    await userEvent.click(screen.getByRole('button', { name: 'Weight of shield_hit: empty' }))
    await userEvent.keyboard('1,5{Enter}')
    expect(await screen.findByText('Weight of shield_hit saved.')).toBeInTheDocument()
    await userEvent.click(screen.getByRole('button', { name: 'Mood of shield_hit: calm' }))
    await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Mood of shield_hit' }), 'tense')
    await userEvent.keyboard('{Enter}')
    expect(await screen.findByText('Mood of shield_hit saved.')).toBeInTheDocument()
    expect(changes(server, 'shield_hit')).toEqual([
      { edition: 1, extra: { Mood: 'calm', Weight: '1,5' } },
      { edition: 2, extra: { Mood: 'tense', Weight: '1,5' } },
    ])
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id }) => id)).toEqual([])
  })

  test('a value that does not fit stays as it was typed, with the reason', async () => {
    const server = served()
    const { id } = server.cue('shield_hit')
    const message = 'wanted a number such as 1.5, found "heavy"'
    server.answers[`PATCH /v1/cues/${id}`] = refusal(422, 'rows-invalid', `nothing was saved; Weight: ${message}`, {
      errors: [{ where: 'Weight', message }],
    })
    await content(server)
    await userEvent.click(screen.getByRole('button', { name: 'Weight of shield_hit: empty' }))
    await userEvent.keyboard('heavy{Enter}')
    expect(await screen.findByText(message)).toBeInTheDocument()
    const field = screen.getByRole('textbox', { name: 'Weight of shield_hit' })
    expect(field).toHaveValue('heavy')
    expect(field).toBeInvalid()
    await userEvent.keyboard('{Escape}')
    expect(screen.getByRole('button', { name: 'Weight of shield_hit: empty' })).toBeInTheDocument()
  })

  test('the panel has a field for each, and saves them with the rest', async () => {
    const server = served()
    openApp(server.path)
    await row('shield_hit')
    await userEvent.keyboard('je')
    await userEvent.selectOptions(await screen.findByRole('combobox', { name: 'Mood' }), 'tense')
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    await waitFor(() => expect(changes(server, 'shield_hit')).toEqual([{ edition: 1, extra: { Mood: 'tense' } }]))
  })
})

describe('several cues in one line', () => {
  const LINE = 'deck, sand × walk × 2'
  const made = ['deck_walk', 'sand_walk'].map((name) => ({
    name,
    file_name: '',
    stems: [`${name}_01`, `${name}_02`],
    variations: 2,
    owner: null as string | null,
  }))

  async function typed(server: ListServer) {
    openApp(server.path)
    await row('shield_hit')
    await userEvent.keyboard('n')
    await userEvent.type(screen.getByRole('textbox', { name: 'Name, row 1' }), LINE)
  }

  test('a line shows its cues before they are added together, and one undo takes them back', async () => {
    const server = served()
    server.answers[`GET ${server.at}/cue-matrix`] = { rows: made }
    server.answers[`POST ${server.at}/cues`] = () => {
      const added = made.map(({ name }, at) => aCue(4 + at, name, { variations: 2 }))
      server.cues = [...server.cues, ...added]
      return answer(added, 201)
    }
    server.answers[`POST ${server.at}/cues/undo-addition`] = answer(null, 204)
    await typed(server)
    const preview = await screen.findByRole('region', { name: `Cues of ${LINE}` })
    expect(preview).toHaveTextContent('2 cues, 4 files from')
    expect(within(preview).getByText('deck_walk_01 to deck_walk_02')).toBeInTheDocument()
    await userEvent.type(screen.getByRole('textbox', { name: 'Use in the game, row 1' }), 'Crew')
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    expect(await screen.findByText('2 cues added: SW-004 to SW-005.')).toBeInTheDocument()
    const [sent] = server.sent('POST', `${server.at}/cues`)
    const cues = (sent?.body as { cues: Record<string, unknown>[] }).cues
    expect(cues.map(({ name, variations, use }) => [name, variations, use])).toEqual([
      ['deck_walk', 2, 'Crew'],
      ['sand_walk', 2, 'Crew'],
    ])
    await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
    await waitFor(() =>
      expect(server.sent('POST', `${server.at}/cues/undo-addition`)[0]?.body).toEqual({ cue_ids: ['cue-4', 'cue-5'] }),
    )
  })

  test('names that the list has are said first', async () => {
    const server = served()
    server.answers[`GET ${server.at}/cue-matrix`] = { rows: [made[0], { ...made[1], owner: 'SW-002' }] }
    await typed(server)
    const preview = await screen.findByRole('region', { name: `Cues of ${LINE}` })
    expect(preview).toHaveTextContent('1 name in the list already')
    expect(within(preview).getAllByRole('listitem')[0]).toHaveTextContent('sand_walk')
    expect(preview).toHaveTextContent('belongs to SW-002')
  })

  test('a line that makes nothing says why, and nothing is added', async () => {
    const server = served()
    server.answers[`GET ${server.at}/cue-matrix`] = refusal(
      422,
      'matrix-invalid',
      'a part is missing before or after ×',
    )
    await typed(server)
    expect(await screen.findByText('A part is missing before or after ×.')).toBeInTheDocument()
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    await waitFor(() => expect(screen.getByRole('textbox', { name: 'Name, row 1' })).toBeInvalid())
    expect(server.sent('POST', `${server.at}/cues`)).toEqual([])
  })
})
