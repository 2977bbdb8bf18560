import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { aGuess, atDesk, CUE, DESK, STING, UNMATCHED, WARP } from '@/test/desk'
import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

beforeAll(() => import('./DeskPage'))

const MOVED = {
  id: 'a1',
  kind: 'moved',
  done_at: '2026-11-17T09:00:00Z',
  undone_at: null,
  take_ids: ['t30'],
}
const MOVE = 'POST /v1/projects/p1/takes/move'

describe('an unmatched file', () => {
  test('is given to its likeliest cue by one key, and back by Undo', async () => {
    const { asked } = serve(
      atDesk({ [MOVE]: MOVED, 'POST /v1/tray-actions/a1/undo': { ...MOVED, moved_back: 1, left: 0 } }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    expect(await within(tray).findByText(/3\.02 s, stereo, 96 kHz\. Which cue is it\?/)).toBeInTheDocument()
    await user.keyboard('1')
    expect(await screen.findByText(/final_FINAL_sting2\.wav is for victory_sting/)).toBeInTheDocument()
    expect(asked.find(({ path }) => path.endsWith('/takes/move'))?.body).toEqual({
      moves: [{ take_id: 't30', cue_id: STING.id, variation: 1 }],
    })
    await user.click(screen.getByRole('button', { name: /Undo/ }))
    await waitFor(() => expect(asked.some(({ path }) => path === '/v1/tray-actions/a1/undo')).toBe(true))
  })

  test('of a set has its variation chosen by a person', async () => {
    const guess = aGuess(WARP, 'the name does not say which variation', null, 3)
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/takes': { items: [{ ...UNMATCHED, guesses: [guess] }], next: null },
        [MOVE]: MOVED,
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.click(within(tray).getByRole('button', { name: /^warp_in/ }))
    expect(asked.some(({ method, path }) => method === 'POST' && path.endsWith('/takes/move'))).toBe(false)
    await user.click(within(tray).getByRole('button', { name: 'Variation 3' }))
    await waitFor(() =>
      expect(asked.find(({ path }) => path.endsWith('/takes/move'))?.body).toEqual({
        moves: [{ take_id: 't30', cue_id: WARP.id, variation: 3 }],
      }),
    )
  })

  test('is given to another cue by searching the list, and what is typed stays when the list arrives', async () => {
    let send: () => void = () => undefined
    const held = new Promise<void>((resolve) => (send = resolve))
    const desk = atDesk({ [MOVE]: MOVED })
    const list = desk['GET /v1/projects/p1/sound-list']
    const { asked } = serve({
      ...desk,
      'GET /v1/projects/p1/sound-list': async () => {
        await held
        return list
      },
    })
    const user = userEvent.setup()
    openApp('/desk')
    await screen.findByRole('region', { name: 'Unmatched files' })
    await user.keyboard('/')
    const field = await screen.findByRole('combobox', { name: 'Cue for final_FINAL_sting2.wav' })
    expect(field).toHaveFocus()
    await user.type(field, 'airl')
    send()
    expect(await screen.findByRole('option', { name: /airlock_cycle/ })).toBeInTheDocument()
    expect(field).toHaveValue('airl')
    await user.keyboard('{Enter}')
    await waitFor(() =>
      expect(asked.find(({ path }) => path.endsWith('/takes/move'))?.body).toEqual({
        moves: [{ take_id: 't30', cue_id: CUE.id, variation: null }],
      }),
    )
  })

  test('a refusal is said, and the guesses stay', async () => {
    serve(atDesk({ [MOVE]: refusal(409, 'wrong-state', 'an approved take cannot become received') }))
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.click(within(tray).getByRole('button', { name: /^warp_in/ }))
    expect(await within(tray).findByRole('alert')).toHaveTextContent('An approved take cannot become received.')
    expect(within(tray).getByRole('button', { name: /^victory_sting/ })).toBeEnabled()
  })

  test('is skipped for now where nobody knows', async () => {
    serve(atDesk())
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.click(within(tray).getByRole('button', { name: 'Skip for now' }))
    expect(within(tray).getByText('1 skipped for now')).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Show it' }))
    expect(within(tray).getByRole('button', { name: /^victory_sting/ })).toBeInTheDocument()
  })
})

describe('many unmatched files', () => {
  const file = (id: string, name: string, sure: ReturnType<typeof aGuess> | null = null) => ({
    ...UNMATCHED,
    id,
    file_name: name,
    sure,
    guesses: sure ? [] : UNMATCHED.guesses,
  })
  const many = (more: Answers = {}): Answers =>
    atDesk({
      'GET /v1/projects/p1/desk': { ...DESK, unmatched: 4 },
      'GET /v1/projects/p1/takes': {
        items: [
          file('t1', 'Warp-In FINAL2.wav', aGuess(WARP, 'the name fits no other')),
          file('t2', 'VICTORY_STING (1).wav', aGuess(STING, 'the name fits no other')),
          file('t3', 'old game/a.wav'),
          file('t4', 'old game/b.wav'),
        ],
        next: null,
      },
      ...more,
    })
  const body = (asked: { path: string; body: unknown }[], what: string) =>
    asked.find(({ path }) => path.endsWith(`/takes/${what}`))?.body

  test('sure ones are accepted at once, guesses are not among them', async () => {
    const accepted = { ...MOVED, kind: 'matched', take_ids: ['t1', 't2'] }
    const { asked } = serve(many({ 'POST /v1/projects/p1/takes/accept-sure': accepted }))
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    expect(within(tray).getByText('4 files without a cue')).toBeInTheDocument()
    expect(within(tray).getByText(/Sure: will be named warp_in\.wav\./)).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Accept 2 sure matches' }))
    expect(await screen.findByText('2 files matched.')).toBeInTheDocument()
    expect(body(asked, 'accept-sure')).toEqual({ take_ids: ['t1', 't2'] })
  })

  test('a folder goes away in one act', async () => {
    const { asked } = serve(
      many({ 'POST /v1/projects/p1/takes/discard': { ...MOVED, kind: 'discarded', take_ids: ['t3', 't4'] } }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const folder = await screen.findByRole('group', { name: 'Folder old game' })
    await user.click(within(folder).getByRole('button', { name: 'Discard folder' }))
    expect(await screen.findByText('2 files discarded; their masters are kept.')).toBeInTheDocument()
    expect(body(asked, 'discard')).toEqual({ take_ids: ['t3', 't4'] })
  })

  describe('of a folder with numbers only', () => {
    const numbered = (id: string, number: number) => ({
      ...file(id, `Sting/0${number}.wav`),
      guesses: [
        aGuess(WARP, 'the folder has "warp"', number, 2),
        aGuess(STING, 'the folder has "sting"', number, 4),
      ].reverse(),
    })
    const folderOf = (...takes: object[]) =>
      many({ 'GET /v1/projects/p1/takes': { items: takes, next: null }, [MOVE]: { ...MOVED, take_ids: ['t1', 't2'] } })
    const moves = (variations: (number | null)[]) => ({
      moves: variations.map((variation, place) => ({ take_id: `t${place + 1}`, cue_id: STING.id, variation })),
    })

    test('are given to its cue in one act, each as its number says', async () => {
      const { asked } = serve(folderOf(numbered('t1', 1), numbered('t2', 3)))
      const user = userEvent.setup()
      openApp('/desk')
      const folder = await screen.findByRole('group', { name: 'Folder Sting' })
      await user.click(within(folder).getByRole('button', { name: 'All 2 are victory_sting' }))
      expect(await screen.findByText('2 files of Sting are for victory_sting.')).toBeInTheDocument()
      expect(body(asked, 'move')).toEqual(moves([1, 3]))
    })

    test('by the key f too; numbers that are there twice are not decided here', async () => {
      const { asked } = serve(folderOf(numbered('t1', 1), numbered('t2', 1)))
      const user = userEvent.setup()
      openApp('/desk')
      await screen.findByRole('group', { name: 'Folder Sting' })
      await user.keyboard('f')
      await waitFor(() => expect(body(asked, 'move')).toEqual(moves([null, null])))
    })

    test('are given to a cue that is searched where they are more than the guess has', async () => {
      const { asked } = serve(folderOf(...[1, 2, 3, 4, 5].map((number) => numbered(`t${number}`, number))))
      const user = userEvent.setup()
      openApp('/desk')
      const folder = await screen.findByRole('group', { name: 'Folder Sting' })
      expect(within(folder).queryByRole('button', { name: /^All 5 are/ })).toBeNull()
      await user.click(within(folder).getByRole('button', { name: 'Folder is…' }))
      await user.type(await screen.findByRole('combobox', { name: 'Cue for the folder Sting' }), 'airl')
      await user.click(await screen.findByRole('option', { name: /airlock_cycle/ }))
      await waitFor(() =>
        expect(body(asked, 'move')).toEqual({
          moves: [1, 2, 3, 4, 5].map((number) => ({ take_id: `t${number}`, cue_id: CUE.id, variation: null })),
        }),
      )
    })
  })

  test('are selected by keys and moved to one cue', async () => {
    const { asked } = serve(many({ [MOVE]: { ...MOVED, take_ids: ['t2', 't3'] } }))
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.keyboard('{ArrowDown}x{Shift>}{ArrowDown}{/Shift}')
    expect(within(tray).getByText('2 selected')).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Move to…' }))
    await user.type(await screen.findByRole('combobox', { name: 'Cue for 2 files' }), 'airl')
    await user.click(await screen.findByRole('option', { name: /airlock_cycle/ }))
    await waitFor(() =>
      expect(body(asked, 'move')).toEqual({
        moves: ['t2', 't3'].map((id) => ({ take_id: id, cue_id: CUE.id, variation: null })),
      }),
    )
  })

  test('Ctrl+A selects all, x takes one out, Shift and a click select a range', async () => {
    const { asked } = serve(
      many({ 'POST /v1/projects/p1/takes/discard': { ...MOVED, kind: 'discarded', take_ids: [] } }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const tray = await screen.findByRole('region', { name: 'Unmatched files' })
    await user.keyboard('{Control>}a{/Control}')
    expect(within(tray).getByText('4 selected')).toBeInTheDocument()
    await user.keyboard('x')
    expect(within(tray).getByText('3 selected')).toBeInTheDocument()
    await user.click(within(tray).getByRole('button', { name: 'Clear' }))
    await user.click(within(tray).getByRole('checkbox', { name: 'Select VICTORY_STING (1).wav' }))
    await user.keyboard('{Shift>}')
    await user.click(within(tray).getByRole('checkbox', { name: 'Select old game/b.wav' }))
    await user.keyboard('{/Shift}')
    expect(within(tray).getByText('3 selected')).toBeInTheDocument()
    const bar = within(tray).getByText('3 selected').parentElement
    await user.click(within(bar as HTMLElement).getByRole('button', { name: 'Discard' }))
    await waitFor(() => expect(body(asked, 'discard')).toEqual({ take_ids: ['t2', 't3', 't4'] }))
  })
})
