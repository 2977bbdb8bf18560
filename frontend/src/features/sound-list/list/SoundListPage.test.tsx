import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, type Asked, refusal } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

beforeAll(() => import('./SoundListPage'))

const three = (part: 'team' | 'designer' = 'team') =>
  new ListServer(
    [
      aCue(1, 'ui_confirm', { palette: true, category: 'ui' }),
      aCue(2, 'shield_hit', { use: 'Enemy shot meets the shield' }),
      aCue(3, 'void_whale', { state: 'concept', category: 'creature' }),
    ],
    { ui_confirm: { status: 'accepted', accepted: 1 }, shield_hit: { status: 'to_review', alternates: 3 } },
    part,
  )

const row = (name: string) => screen.findByRole('row', { name: new RegExp(name) })
const opened = async (server: ListServer) => {
  const app = openApp(server.path)
  await row('shield_hit')
  await screen.findByText('To review', { selector: 'td *' })
  return app
}

describe('reading', () => {
  test('every cue has its state and what stands; the palette comes first', { tags: ['slow'] }, async () => {
    const server = three()
    server.revision = 7
    await opened(server)
    const table = screen.getByRole('table', { name: 'Sound list' })
    expect(
      within(table)
        .getAllByRole('columnheader', { name: /accepted$/ })
        .map((head) => head.textContent),
    ).toEqual(['Palette 1 of 1 accepted', 'The rest 0 of 2 accepted'])
    expect(within(await row('shield_hit')).getByText('Pick one of three')).toBeInTheDocument()
    expect(within(await row('void_whale')).getByText('Concept')).toHaveClass('tone-warn')
    expect(screen.getByText('3 cues, revision 7')).toBeInTheDocument()
    expect(await screen.findByRole('link', { name: '0 lines changed since revision 6' })).toBeInTheDocument()
    expect(screen.getByText('1 of 3 accepted; 3 files to review')).toBeInTheDocument()
  })

  test('j and k move, Enter opens the cue, and the list finds its row again', { tags: ['slow'] }, async () => {
    const server = three()
    const app = await opened(server)
    await userEvent.keyboard('jj')
    expect(await row('shield_hit')).toHaveAttribute('aria-current', 'true')
    expect(await row('shield_hit')).toHaveFocus()
    await userEvent.keyboard('k')
    expect(await row('ui_confirm')).toHaveAttribute('aria-current', 'true')
    await userEvent.keyboard('j{Enter}')
    expect(await screen.findByRole('heading', { level: 1, name: 'shield_hit' })).toBeInTheDocument()
    expect(app.at()).toBe(`${server.path}/cues/${server.cue('shield_hit').id}`)
    await userEvent.keyboard('{Escape}')
    await waitFor(async () => expect(await row('shield_hit')).toHaveAttribute('aria-current', 'true'))
  })

  test(
    'filters leave what matches, are said in the address, and Escape takes them away',
    { tags: ['slow'] },
    async () => {
      const server = three()
      const app = await opened(server)
      await userEvent.keyboard('f')
      await waitFor(() => expect(screen.getByRole('button', { name: 'All 3' })).toHaveFocus())
      await userEvent.keyboard('f')
      await waitFor(() => expect(screen.getByRole('button', { name: /^To review/ })).toHaveFocus())
      await userEvent.keyboard('{Enter}')
      await waitFor(() => expect(app.search()).toEqual({ state: 'to_review' }))
      expect(screen.queryByRole('link', { name: 'void_whale' })).not.toBeInTheDocument()
      await userEvent.keyboard('{Escape}')
      await row('void_whale')
      await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Category' }), 'creature')
      await waitFor(() => expect(screen.queryByRole('link', { name: 'shield_hit' })).not.toBeInTheDocument())
      await userEvent.selectOptions(screen.getByRole('combobox', { name: 'Category' }), '')
      await userEvent.keyboard('{Escape}')
      await userEvent.click(screen.getByRole('searchbox', { name: 'Search the list' }))
      await userEvent.keyboard('ufo')
      expect(await screen.findByRole('heading', { name: 'No cue matches “ufo”.' })).toBeInTheDocument()
      expect(app.search()).toEqual({ q: 'ufo' })
      await userEvent.click(screen.getByRole('button', { name: 'Add a cue named ufo' }))
      expect(screen.getByRole('textbox', { name: 'Name, row 1' })).toHaveValue('ufo')
    },
  )

  test('an empty list says what to do first', async () => {
    const server = new ListServer([])
    openApp(server.path)
    expect(await screen.findByRole('heading', { name: 'Which sounds do you need?' })).toBeInTheDocument()
    await userEvent.keyboard('n')
    expect(screen.getByRole('textbox', { name: 'Name, row 1' })).toHaveFocus()
  })

  test('a list that does not come says so, and can be asked for again', async () => {
    const server = three()
    const list = server.answers[`GET ${server.at}/sound-list`]
    server.answers[`GET ${server.at}/sound-list`] = refusal(404, 'project-not-found', 'no project of that id')
    openApp(server.path)
    expect(await screen.findByRole('alert')).toHaveTextContent('No project of that id.')
    server.answers[`GET ${server.at}/sound-list`] = list
    await userEvent.click(screen.getByRole('button', { name: 'Try again' }))
    expect(await row('shield_hit')).toBeInTheDocument()
  })

  test('a designer reads and asks, and cannot change anything', { tags: ['slow'] }, async () => {
    const server = three('designer')
    server.answers[`GET ${server.at}/desk`] = { came_back: [], unmatched: 0, checking: 0 }
    const asks = `/v1/cues/${server.cue('void_whale').id}/questions`
    server.answers[`POST ${asks}`] = answer({}, 201)
    await opened(server)
    expect(screen.queryByRole('button', { name: /Add a cue/ })).not.toBeInTheDocument()
    expect(screen.queryByRole('checkbox')).not.toBeInTheDocument()
    await userEvent.keyboard('jjje')
    expect(screen.queryByRole('form')).not.toBeInTheDocument()
    await userEvent.keyboard('q')
    const field = await screen.findByRole('textbox', { name: 'Your question about void_whale' })
    await waitFor(() => expect(field).toHaveFocus())
    await userEvent.keyboard('How far away is it?{Control>}{Enter}{/Control}')
    await waitFor(() => expect(server.sent('POST', asks)[0]?.body).toMatchObject({ text: 'How far away is it?' }))
    expect(await screen.findByRole('status')).toHaveTextContent('Question about void_whale sent.')
  })
})

describe('adding', () => {
  test(
    'rows are typed like a table, refusals stand at their field, and nothing typed is lost',
    { tags: ['slow'] },
    async () => {
      const server = three()
      const cues = `${server.at}/cues`
      server.answers[`POST ${cues}`] = refusal(422, 'rows-invalid', 'nothing was saved', {
        errors: [{ where: 'row 2: name', message: 'the file name "shield_hit" belongs to SW-002 already' }],
      })
      await opened(server)
      await userEvent.keyboard('n')
      await userEvent.keyboard('door_open{Enter}shield_hit')
      await userEvent.type(screen.getByRole('textbox', { name: 'Length, s, row 1' }), '1,2')
      await userEvent.click(screen.getByRole('button', { name: /^Add 2 cues/ }))
      const wrong = await screen.findByRole('textbox', {
        name: 'Name, row 2',
        description: /belongs to SW-002 already\./,
      })
      expect(wrong).toBeInvalid()
      expect(wrong).toHaveValue('shield_hit')
      expect(screen.getByRole('textbox', { name: 'Name, row 1' })).toBeValid()
      expect(screen.getByRole('textbox', { name: 'Length, s, row 1' })).toHaveValue('1,2')

      server.answers[`POST ${cues}`] = () => {
        const added = [aCue(4, 'door_open'), aCue(5, 'shield_hit_2')]
        server.cues = [...server.cues, ...added]
        return answer(added, 201)
      }
      await userEvent.type(wrong, '_2')
      await userEvent.keyboard('{Control>}{Enter}{/Control}')
      expect(await screen.findByText('2 cues added: SW-004 to SW-005.')).toBeInTheDocument()
      expect(server.sent('POST', cues)[1]?.body).toMatchObject({
        cues: [{ name: 'door_open', duration_s: 1.2, variations: 1, state: 'concept' }, { name: 'shield_hit_2' }],
      })
      expect(await row('door_open')).toBeInTheDocument()
    },
  )

  test(
    'a figure that cannot be read is said before anything is sent; closing keeps the rows',
    { tags: ['slow'] },
    async () => {
      const server = three()
      await opened(server)
      await userEvent.keyboard('ndoor_open')
      await userEvent.type(screen.getByRole('textbox', { name: 'Length, s, row 1' }), 'long')
      await userEvent.keyboard('{Control>}{Enter}{/Control}')
      expect(await screen.findByText('Enter seconds such as 1.5 (found “long”).')).toBeInTheDocument()
      expect(server.sent('POST', `${server.at}/cues`)).toEqual([])
      await userEvent.keyboard('{Escape}')
      expect(screen.queryByRole('textbox', { name: 'Name, row 1' })).not.toBeInTheDocument()
      await userEvent.click(screen.getAllByRole('button', { name: /Add a cue/ })[0] as HTMLElement)
      expect(screen.getByRole('textbox', { name: 'Name, row 1' })).toHaveValue('door_open')
    },
  )

  test('what is pasted on the list opens the import with it', async () => {
    const server = three()
    server.answers[`POST ${server.at}/sound-list/import`] = refusal(422, 'sheet-unreadable', 'the sheet is empty')
    const app = await opened(server)
    fireEvent.paste(document.body, { clipboardData: { getData: () => 'name\ncrash' } })
    expect(await screen.findByRole('textbox', { name: 'Pasted rows' })).toHaveValue('name\ncrash')
    expect(app.at()).toBe(`${server.path}/import`)
  })
})

describe('editing', () => {
  const edited = async (server: ListServer) => {
    const app = await opened(server)
    await userEvent.keyboard('jje')
    await screen.findByRole('form', { name: 'Edit shield_hit' })
    return app
  }
  const put = async (label: string, text: string) => {
    const field = screen.getByRole('textbox', { name: label })
    await userEvent.clear(field)
    await userEvent.type(field, text)
    return field
  }

  test(
    'only what was changed is sent, with the edition that was read; undo puts it back',
    { tags: ['slow'] },
    async () => {
      const server = three()
      const { id } = server.cue('shield_hit')
      server.answers[`PATCH /v1/cues/${id}`] = ({ body }: Asked) => {
        const { edition, ...facts } = body as { edition: number }
        Object.assign(server.cue('shield_hit'), facts, { edition: edition + 1 })
        return server.cue('shield_hit')
      }
      await edited(server)
      await put('Length, s', '0,9')
      await userEvent.keyboard('{Control>}{Enter}{/Control}')
      expect(await screen.findByText('shield_hit saved.')).toBeInTheDocument()
      expect(within(await row('shield_hit')).getByText('0.90')).toBeInTheDocument()
      await userEvent.keyboard('u')
      await waitFor(() =>
        expect(server.sent('PATCH', `/v1/cues/${id}`).map(({ body }) => body)).toEqual([
          { edition: 1, duration_s: 0.9 },
          { edition: 2, duration_s: 0.8 },
        ]),
      )
    },
  )

  test('another person’s change is shown, and what was typed stays on top of it', { tags: ['slow'] }, async () => {
    const server = three()
    const { id } = server.cue('shield_hit')
    server.answers[`PATCH /v1/cues/${id}`] = refusal(409, 'cue-changed', 'someone else changed this cue meanwhile')
    await edited(server)
    const length = await put('Length, s', '0.9')
    Object.assign(server.cue('shield_hit'), { use: 'A shot meets a hull', edition: 5 })
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    const alert = await screen.findByRole('alert')
    expect(alert).toHaveTextContent('Someone else changed shield_hit meanwhile.')
    expect(alert).toHaveTextContent(/Use in the game was Enemy shot meets the shield.*A shot meets a hull/)
    expect(length).toHaveValue('0.9')
    expect(screen.getByRole('textbox', { name: 'Use in the game' })).toHaveValue('A shot meets a hull')
    server.answers[`PATCH /v1/cues/${id}`] = () => server.cue('shield_hit')
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    await waitFor(() =>
      expect(server.sent('PATCH', `/v1/cues/${id}`)[1]?.body).toEqual({ edition: 5, duration_s: 0.9 }),
    )
  })

  test('what the server refuses stands at its field; closing keeps what was typed', { tags: ['slow'] }, async () => {
    const server = three()
    const { id } = server.cue('shield_hit')
    server.answers[`PATCH /v1/cues/${id}`] = refusal(422, 'rows-invalid', 'nothing was saved', {
      errors: [{ where: 'variations', message: '400 variations; wanted 1 to 99' }],
    })
    await edited(server)
    const field = await put('Variations', '400')
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    expect(await screen.findByText('400 variations; wanted 1 to 99.')).toBeInTheDocument()
    expect(field).toBeInvalid()
    await userEvent.keyboard('{Escape}')
    await waitFor(async () => expect(await row('shield_hit')).toHaveFocus())
    await userEvent.keyboard('e')
    expect(screen.getByRole('textbox', { name: 'Variations' })).toHaveValue('400')
  })

  test('a cut asks why, in place', async () => {
    const server = three()
    const path = `/v1/cues/${server.cue('shield_hit').id}/cut`
    server.answers[`POST ${path}`] = () => {
      Object.assign(server.cue('shield_hit'), {
        state: 'cut',
        cut_reason: 'No shields',
        cut_at: '2026-11-09T12:00:00Z',
      })
      return server.cue('shield_hit')
    }
    await edited(server)
    await userEvent.click(screen.getByRole('button', { name: 'Cut cue' }))
    await userEvent.click(screen.getByRole('button', { name: 'Cut shield_hit' }))
    expect(screen.getByText('Enter a reason. The designer reads it.')).toBeInTheDocument()
    expect(server.sent('POST', path)).toEqual([])
    await userEvent.type(screen.getByRole('textbox', { name: /Why cut/ }), 'No shields{Enter}')
    expect(await screen.findByText('Cut on 9 November, “No shields”')).toBeInTheDocument()
    expect(server.sent('POST', path)[0]?.body).toEqual({ reason: 'No shields' })
  })
})

describe('the line above the list', () => {
  const names = () =>
    [...document.querySelectorAll('main button, main a, main input, main select')]
      .filter((control) => control.closest('table') === null)
      .map((control) => control.getAttribute('aria-label') ?? control.textContent)

  test('has seven controls at most; the rest is one press away, by the keyboard too', async () => {
    const app = await opened(three())
    expect(names().slice(7)).toEqual([])
    for (const [button, holds] of [
      ['Filter', ['Category', 'Need']],
      ['Display', ['Group by']],
    ] as const) {
      screen.getByRole('button', { name: button }).focus()
      await userEvent.keyboard('{Enter}')
      for (const name of holds) expect(screen.getByRole('combobox', { name })).toBeVisible()
    }
    expect(screen.queryByRole('combobox', { name: 'Need' })).toBeNull()
    await userEvent.click(within(screen.getByRole('main')).getByRole('button', { name: 'More' }))
    expect(screen.getByRole('link', { name: 'XLSX' })).toHaveAttribute(
      'href',
      expect.stringMatching(/sound-list.xlsx$/),
    )
    await userEvent.click(screen.getByRole('link', { name: 'Compare revisions' }))
    await waitFor(() => expect(app.at()).toMatch(/sound-list\/compare$/))
  })

  test('a filter in the address is in sight, and counted on its button', async () => {
    const server = three()
    openApp(`${server.path}?state=to_review`)
    expect(await screen.findByRole('button', { name: 'Filter, 1 on' })).toHaveAttribute('aria-expanded', 'true')
    expect(screen.getByRole('group', { name: 'Filter by state' })).toBeVisible()
  })
})

describe('several at once', () => {
  test('one thing is said of all selected cues in one revision, and undone in one', async () => {
    const server = three()
    const path = `${server.at}/sound-list/import`
    server.answers[`POST ${path}`] = { errors: [], imported: true, revision: 3 }
    await opened(server)
    await userEvent.keyboard('jjxjx')
    expect(await screen.findByText('2 cues selected')).toBeInTheDocument()
    await userEvent.type(screen.getByRole('combobox', { name: 'Category for the selected cues' }), 'Big Guns{Enter}')
    expect(await screen.findByText('2 cues in Big Guns.')).toBeInTheDocument()
    await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
    await waitFor(() => expect(server.sent('POST', path)).toHaveLength(2))
    expect(server.sent('POST', path).map(({ body }) => (body as { text: string }).text)).toEqual([
      'number,category\n2,"big-guns"\n3,"big-guns"',
      'number,category\n2,"weapon"\n3,"creature"',
    ])
    await userEvent.click(screen.getByRole('button', { name: 'Clear' }))
    expect(screen.getByRole('button', { name: 'Filter' })).toBeInTheDocument()
  })

  test('a refusal names the cue, and Shift takes the rows between', async () => {
    const server = three()
    server.answers[`POST ${server.at}/sound-list/import`] = {
      errors: [{ row: 3, column: 'palette', message: 'was changed meanwhile' }],
      imported: false,
    }
    await opened(server)
    await userEvent.keyboard('jxjj{Shift>}x{/Shift}')
    expect(await screen.findByText('3 cues selected')).toBeInTheDocument()
    await userEvent.click(screen.getByRole('button', { name: 'Add to palette' }))
    // SW-001 is in it already; the second row below the head is SW-003.
    expect(await screen.findByRole('alert')).toHaveTextContent('Nothing was changed. SW-003: was changed meanwhile.')
  })
})

test('of two thousand cues only those near the window are drawn', { tags: ['slow'] }, async () => {
  vi.spyOn(HTMLElement.prototype, 'offsetHeight', 'get').mockReturnValue(26)
  const server = new ListServer(Array.from({ length: 2000 }, (_, at) => aCue(at + 1, `sound_${at + 1}`)))
  openApp(server.path)
  const table = await screen.findByRole('table', { name: 'Sound list' })
  expect(table).toHaveAttribute('aria-rowcount', '2001')
  expect(within(table).getAllByRole('row').length).toBeLessThan(200)
})
