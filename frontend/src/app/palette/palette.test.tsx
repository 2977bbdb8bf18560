import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'

import { CommandPalette } from './CommandPalette'
import { type Command, type SearchProvider, useCommands, useSearchProvider } from './index'

const SOUNDS = ['shield_hit', 'suit_hit', 'foot_deck_walk']

function Feature({ commands, provider }: { commands: Command[]; provider: SearchProvider }) {
  useCommands(commands)
  useSearchProvider(provider)
  return null
}

function open(search: SearchProvider['search'] = () => Promise.resolve([])) {
  const close = vi.fn()
  const ask = vi.fn()
  draw(
    <>
      <Feature
        commands={[
          { id: 'ask', label: 'Ask about shield_hit', keys: 'q', run: ask },
          { id: 'add', label: 'Add a cue', run: vi.fn() },
        ]}
        provider={{ id: 'sounds', title: 'Sounds', search }}
      />
      <CommandPalette opened onClose={close} />
    </>,
  )
  return { close, ask }
}

const opened = vi.fn<(name: string) => void>()
const searchSounds: SearchProvider['search'] = (query) =>
  Promise.resolve(
    SOUNDS.filter((name) => name.includes(query)).map((name) => ({
      id: name,
      title: name,
      number: 'SW-007',
      open: () => opened(name),
    })),
  )

test('sounds come first, then what can be done; arrows and Enter are enough', async () => {
  const { close } = open(searchSounds)
  await userEvent.type(await screen.findByRole('combobox', { name: 'Search or run a command' }), 'hit')
  await screen.findByRole('option', { name: /suit_hit/ })
  const groups = screen.getAllByRole('group')
  expect(groups.map((group) => group.getAttribute('aria-label'))).toEqual(['Sounds', 'Do'])
  expect(screen.getByRole('option', { selected: true })).toHaveTextContent('SW-007shield_hit')
  await userEvent.keyboard('{ArrowDown}')
  const field = screen.getByRole('combobox')
  expect(field).toHaveAttribute('aria-activedescendant', screen.getByRole('option', { selected: true }).id)
  await userEvent.keyboard('{Enter}')
  expect(opened).toHaveBeenCalledWith('suit_hit')
  expect(close).toHaveBeenCalledOnce()
})

test('without a question it offers what can be done, with its key', async () => {
  const { ask, close } = open()
  const command = await screen.findByRole('option', { name: /Ask about shield_hit/ })
  expect(within(command).getByText('q')).toBeInTheDocument()
  await userEvent.click(command)
  expect(ask).toHaveBeenCalledOnce()
  expect(close).toHaveBeenCalledOnce()
})

test('the arrows go round', async () => {
  open()
  await screen.findByRole('combobox')
  await userEvent.keyboard('{ArrowUp}')
  expect(screen.getByRole('option', { selected: true })).toHaveTextContent('Add a cue')
})

test('nothing found is said in words', async () => {
  open(searchSounds)
  await userEvent.type(await screen.findByRole('combobox'), 'ufo')
  await waitFor(() => expect(screen.getByRole('status')).toHaveTextContent('No results for “ufo”.'))
})

test('an answer that comes too late is not shown', async () => {
  const answers: ((found: Awaited<ReturnType<SearchProvider['search']>>) => void)[] = []
  const signals: AbortSignal[] = []
  open((_query, signal) => {
    signals.push(signal)
    return new Promise((resolve) => answers.push(resolve))
  })
  const field = await screen.findByRole('combobox')
  await userEvent.type(field, 'shi')
  await waitFor(() => expect(answers).toHaveLength(1))
  await userEvent.type(field, 'x')
  await waitFor(() => expect(answers).toHaveLength(2))
  expect(signals[0]?.aborted).toBe(true)
  answers[0]?.([{ id: '1', title: 'shield_hit', open: vi.fn() }])
  answers[1]?.([])
  await waitFor(() => expect(screen.getByRole('status')).toHaveTextContent('No results for “shix”.'))
  expect(screen.queryByText('shield_hit')).not.toBeInTheDocument()
})
