import { cleanup, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { answer } from '@/test/server'
import { aSourceBank, aTakeServer, aVersion } from '@/test/take'
import type { Transport, TransportEvents, Upload } from '@/uploads'

/** A connection that carries a file at once. */
const line = vi.hoisted(() => ({ bound: {} }))
vi.mock('@/uploads', async (original) => ({
  ...(await original<object>()),
  partsTransport: ({ metadata }: { metadata: (upload: Upload) => object }): Transport => ({
    start: (upload: Upload, events: TransportEvents) => {
      line.bound = metadata(upload)
      events.onFinished('u7')
      return () => undefined
    },
  }),
}))

beforeAll(() => import('./TakePage'))

let server: ReturnType<typeof aTakeServer>

beforeEach(() => {
  vi.stubGlobal('AudioContext', HandContext)
  server = aTakeServer()
})

const SESSION = { id: 'f1', kind: 'session', file_name: 'laser.rpp', file_bytes: 9, sha256: 's', received_at: '' }
const bankOf = async () => {
  openApp('/takes/t1')
  return screen.findByRole('region', { name: 'Source bank' })
}

describe('the source bank of a version', () => {
  test('takes files of any kind from its designer', async () => {
    server.on('POST /v1/takes/t1/source-files', () => {
      server.on('GET /v1/takes/t1/source-bank', aSourceBank({ files: [SESSION] }))
      return SESSION
    })
    const shown = await bankOf()
    const file = new File(['<REAPER'], 'laser.rpp')
    vi.spyOn(file, 'slice').mockReturnValue({ arrayBuffer: () => Promise.resolve(new ArrayBuffer(7)) } as Blob)
    await userEvent.upload(within(shown).getByLabelText('Source files'), file)
    expect(await within(shown).findByRole('link', { name: 'Download laser.rpp' })).toHaveAttribute(
      'href',
      '/v1/source-files/f1',
    )
    expect(server.of('POST /v1/takes/t1/source-files').map((asked) => asked.body)).toEqual([{ upload_id: 'u7' }])
    expect(line.bound).toEqual({ delivery_id: 'd1', take_id: 't1', file_name: 'laser.rpp' })
    expect((await axe.run(shown)).violations).toEqual([])
  })

  test('keeps plug-ins and recipe', async () => {
    server.on('PUT /v1/takes/t1/source-bank', () => {
      const bank = aSourceBank({ plug_ins: ['Pro-Q 3', 'Valhalla'], recipe: 'Two bowls.' })
      server.on('GET /v1/takes/t1/source-bank', bank)
      return bank
    })
    const shown = await bankOf()
    await userEvent.click(within(shown).getByRole('button', { name: 'Write recipe' }))
    await userEvent.type(within(shown).getByLabelText('Plug-ins, one a line'), 'Pro-Q 3\n\nValhalla')
    await userEvent.type(within(shown).getByRole('textbox', { name: 'Recipe' }), 'Two bowls.')
    await userEvent.click(within(shown).getByRole('button', { name: 'Save recipe' }))
    expect(await within(shown).findByText('Plug-ins: Pro-Q 3, Valhalla')).toBeVisible()
    expect(server.of('PUT /v1/takes/t1/source-bank').map((asked) => asked.body)).toEqual([
      { plug_ins: ['Pro-Q 3', 'Valhalla'], recipe: 'Two bowls.' },
    ])
  })

  test('keeps a recipe that was not saved for when its designer comes back', async () => {
    const shown = await bankOf()
    await userEvent.click(within(shown).getByRole('button', { name: 'Write recipe' }))
    await userEvent.type(within(shown).getByRole('textbox', { name: 'Recipe' }), 'Two bowls.')
    cleanup()
    const reopened = await bankOf()
    expect(within(reopened).getByRole('textbox', { name: 'Recipe' })).toHaveValue('Two bowls.')
    await userEvent.click(within(reopened).getByRole('button', { name: 'Cancel' }))
    expect(within(reopened).getByRole('button', { name: 'Write recipe' })).toBeVisible()
  })

  test('loses no file once it is the studio’s', async () => {
    server
      .on('GET /v1/takes/t1', aVersion({ state: 'approved' }))
      .on('GET /v1/takes/t1/source-bank', aSourceBank({ files: [SESSION], is_handed_over: true }))
    const shown = await bankOf()
    expect(within(shown).getByRole('link', { name: 'Download laser.rpp' })).toBeVisible()
    expect(within(shown).queryByRole('button', { name: 'Remove laser.rpp' })).toBeNull()
  })

  test('is removed from by its designer before that', async () => {
    server
      .on('GET /v1/takes/t1/source-bank', aSourceBank({ files: [SESSION] }))
      .on('DELETE /v1/source-files/f1', () => {
        server.on('GET /v1/takes/t1/source-bank', aSourceBank())
        return answer(null, 204)
      })
    const shown = await bankOf()
    await userEvent.click(within(shown).getByRole('button', { name: 'Remove laser.rpp' }))
    await waitFor(() => expect(within(shown).queryByText('laser.rpp')).toBeNull())
  })

  test('is not there for whom it is not shown to', async () => {
    server.on('GET /v1/takes/t1/source-bank', aSourceBank({ is_shown: false }))
    openApp('/takes/t1')
    await screen.findByRole('heading', { name: 'Master' })
    await waitFor(() => expect(server.of('GET /v1/takes/t1/source-bank')).not.toHaveLength(0))
    expect(screen.queryByRole('region', { name: 'Source bank' })).toBeNull()
  })
})
