import { QueryClient, QueryClientProvider } from '@tanstack/react-query'
import { screen, within, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import type { ReactNode } from 'react'
import { expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'
import { answer, serve } from '@/test/server'

import type { Reference } from './api'
import { partsOf } from './wordParts'
import { WordList, WordText } from './WordText'

const aReference = (id: string, words: string): Reference => ({
  ...{ id, project_id: 'p1', cue: null, category: null, caption: `What ${words} means`, terms: '', words },
  ...{ start_s: null, end_s: null, added_at: '2026-11-25T10:00:00Z', parts: 0, may_change: false },
  version: {
    ...{ id: `v-${id}`, number: 1, kind: 'audio', media_type: 'audio/wav', file_name: `${id}.wav`, url: null },
    ...{ file_bytes: 100, excerpt: '', preview: 'none', problem: '', width_px: null, height_px: null },
    ...{ added_at: '2026-11-25T10:00:00Z', added_by: { id: 'a', name: 'Producer' } },
  },
})

const drawn = (what: ReactNode) => draw(<QueryClientProvider client={new QueryClient()}>{what}</QueryClientProvider>)

const LIST = [aReference('r1', 'warm, warm pad'), aReference('r2', 'crunchy')]

test('whole words of the list are found in any case, the longest first', () => {
  const found = (text: string) =>
    partsOf(text, LIST)
      .filter(({ reference }) => reference)
      .map(({ text: piece }) => piece)
  expect(found('Warm, but CRUNCHY; no swarm, no warmth')).toEqual(['Warm', 'CRUNCHY'])
  expect(found('a warm pad')).toEqual(['warm pad'])
  expect(partsOf('a (b) c', [aReference('r3', '(b)')]).map(({ text }) => text)).toEqual(['a ', '(b)', ' c'])
  expect(partsOf('as it is', [])).toEqual([{ text: 'as it is' }])
})

const server = (items: Reference[]) =>
  serve({
    'GET /v1/projects/p1/references': { items, next: null },
    'POST /v1/reference-versions/v-r1/openings': answer(null, 204),
  })

test('a word in a text plays what it means, and its opening is recorded', async () => {
  vi.spyOn(HTMLMediaElement.prototype, 'play').mockResolvedValue()
  const { asked } = server(LIST)
  drawn(<WordText projectId="p1" text="More warm, please" />)
  const word = await screen.findByRole('button', { name: 'Hear “warm”' })
  await userEvent.click(word)
  const sound = await screen.findByLabelText('What warm, warm pad means', { selector: 'audio' })
  expect(sound).toHaveAttribute('src', '/v1/reference-versions/v-r1/file')
  expect(asked.filter(({ method }) => method === 'POST')).toHaveLength(1)
  await userEvent.click(word)
  expect(screen.queryByLabelText('What warm, warm pad means', { selector: 'audio' })).toBeNull()
})

test('to those who see no sound of it the word is plain', async () => {
  const { asked } = server([])
  drawn(<WordText projectId="p1" text="More warm, please" />)
  expect(await screen.findByText('More warm, please')).toBeVisible()
  await waitFor(() => expect(asked).not.toHaveLength(0))
  expect(screen.queryByRole('button')).toBeNull()
})

test('a text that is being written offers the words that it uses, each once', async () => {
  server(LIST)
  drawn(<WordList projectId="p1" text="Warm and crunchy, more warm" />)
  const offered = await screen.findByRole('group', { name: 'Words of the project' })
  expect(
    within(offered)
      .getAllByRole('button')
      .map(({ textContent }) => textContent),
  ).toEqual(['warm', 'crunchy'])
})
