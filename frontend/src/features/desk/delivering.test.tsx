import { File as NodeFile } from 'node:buffer'

import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { atDesk, CUE, DELIVERY, UNMATCHED, WARP } from '@/test/desk'
import { openApp } from '@/test/openApp'
import { answer, refusal, serve } from '@/test/server'

beforeAll(() => import('./DeskPage'))

const choose = (label: string, files: NodeFile[]) => {
  const field = screen.getByLabelText(label)
  Object.defineProperty(field, 'files', { value: files, configurable: true })
  fireEvent.change(field)
}
const mp3 = (name: string) => new NodeFile(['ID3\x04 and then some'], name)

describe('delivering', () => {
  test('an MP3 named .wav stays in the browser, in words', async () => {
    const { asked } = serve(atDesk({ 'POST /v1/projects/p1/deliveries': answer(DELIVERY, 201) }))
    openApp('/desk')
    await screen.findByRole('button', { name: 'Choose folder' })
    choose('Files to deliver', [mp3('vo_oath.wav')])
    const list = await screen.findByRole('list', { name: 'Files in this delivery' })
    expect(list).toHaveTextContent('vo_oath.wav')
    expect(list).toHaveTextContent('This is an MP3 named .wav. Export a WAV. Nothing was uploaded.')
    expect(within(list).getByText('Not uploaded')).toBeInTheDocument()
    expect(asked.some(({ path }) => path.startsWith('/v1/uploads'))).toBe(false)
    expect(screen.getByRole('heading', { name: 'Delivery 4' })).toBeInTheDocument()
  })

  test('a project that takes no files from me says so where files go', async () => {
    serve(
      atDesk({
        'POST /v1/projects/p1/deliveries': refusal(403, 'designer-needed', 'your engagement here has ended', {
          fix: 'ask the producer',
        }),
      }),
    )
    openApp('/desk')
    await screen.findByRole('button', { name: 'Choose folder' })
    choose('Files to deliver', [mp3('a.wav')])
    expect(await screen.findByRole('alert')).toHaveTextContent('Your engagement here has ended. Ask the producer.')
  })

  test('a thousand rows are drawn only where they are seen', async () => {
    serve(atDesk({ 'POST /v1/projects/p1/deliveries': answer(DELIVERY, 201) }))
    openApp('/desk')
    await screen.findByRole('button', { name: 'Choose folder' })
    choose(
      'Files to deliver',
      Array.from({ length: 1000 }, (_, index) => mp3(`take_${index}.wav`)),
    )
    const region = await screen.findByRole('region', { name: '1,000 files, scrolls' })
    expect(within(region).queryAllByRole('listitem').length).toBeLessThan(100)
  })

  test('sources are asked once for a delivery, and begin with what was stated last', async () => {
    const remembered = {
      from_scratch: false,
      own_recordings: true,
      libraries: [{ name: 'Metal Impacts 2', licence: 'single user', file: '' }],
      generated: [],
      performers: [],
      note: '',
    }
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/deliveries': { items: [DELIVERY], next: null },
        'GET /v1/deliveries/d4': { ...DELIVERY, takes: [], dry_stems: [], archives: [] },
        'GET /v1/deliveries/d4/sources': { delivery_id: 'd4', stated: null, remembered, takes: [] },
        'PUT /v1/deliveries/d4/sources': { delivery_id: 'd4', stated: null, remembered, takes: [] },
      }),
    )
    openApp('/desk')
    const part = within(await screen.findByRole('region', { name: 'Sources of delivery 4' }))
    expect(part.getByRole('button', { name: 'Same as last time' })).toBeInTheDocument()
    fireEvent.click(part.getByRole('button', { name: 'State sources' }))
    expect(await part.findByLabelText('Own recordings')).toBeChecked()
    expect(part.getByLabelText('Library')).toHaveValue('Metal Impacts 2')
    fireEvent.click(part.getByRole('button', { name: 'Add performer' }))
    fireEvent.change(part.getByLabelText('Performer'), { target: { value: 'A. Voice' } })
    fireEvent.click(part.getByRole('button', { name: 'Add generated part' }))
    fireEvent.click(part.getByRole('button', { name: 'Save sources' }))
    await waitFor(() => expect(asked.some(({ method }) => method === 'PUT')).toBe(true))
    expect(asked.find(({ method }) => method === 'PUT')?.body).toEqual({
      ...remembered,
      performers: [{ name: 'A. Voice', release: '' }],
    })
  })

  test('what the server has is shown with its state; the note is kept, and the delivery closed', async () => {
    const takes = [
      { ...UNMATCHED, id: 'a', cue: WARP, number: 1, state: 'conforming', file_name: 'warp_in.wav' },
      { ...UNMATCHED, id: 'b', cue: CUE, number: 2, state: 'returned', file_name: 'airlock_cycle.wav' },
    ]
    const { asked } = serve(
      atDesk({
        'GET /v1/projects/p1/deliveries': { items: [DELIVERY], next: null },
        'GET /v1/deliveries/d4': { ...DELIVERY, takes, dry_stems: [], archives: [] },
        'PATCH /v1/deliveries/d4': { ...DELIVERY, note: 'Doors.' },
        'POST /v1/deliveries/d4/close': { ...DELIVERY, closed_at: '2026-11-17T10:00:00Z' },
      }),
    )
    const user = userEvent.setup()
    openApp('/desk')
    const list = await screen.findByRole('list', { name: 'Files in this delivery' })
    expect(within(list).getByText('Returned')).toBeInTheDocument()
    expect(screen.getByText('1 file checked')).toBeInTheDocument()
    await user.click(within(screen.getByRole('region', { name: 'Delivery 4' })).getByRole('button', { name: 'Show' }))
    expect(await screen.findByText('warp_in.wav')).toBeInTheDocument()
    await user.type(screen.getByLabelText('Note on delivery 4'), 'Doors.')
    await user.click(screen.getByRole('button', { name: 'Close delivery' }))
    expect(await screen.findByText('Delivery 4 closed. The next file starts a new delivery.')).toBeInTheDocument()
    expect(asked.find(({ method }) => method === 'PATCH')?.body).toEqual({ note: 'Doors.' })
  })
})
