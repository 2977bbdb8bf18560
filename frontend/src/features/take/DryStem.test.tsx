import { createEvent, fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { answer } from '@/test/server'
import { aCheck, aTakeServer, aVersion } from '@/test/take'
import type { Transport, TransportEvents, Upload } from '@/uploads'

/** A connection under the test's control: half of a file arrives at once, the rest on request. */
const line = vi.hoisted(() => ({ bound: {}, finish: (): void => undefined }))
vi.mock('@/uploads', async (original) => ({
  ...(await original<object>()),
  partsTransport: ({ metadata }: { metadata: (upload: Upload) => object }): Transport => ({
    start: (upload: Upload, events: TransportEvents) => {
      line.bound = metadata(upload)
      line.finish = () => events.onFinished('u7')
      events.onProgress(upload.file.size / 2)
      return () => undefined
    },
  }),
}))

beforeAll(() => import('./TakePage'))

/** A file as browsers give it; the DOM of these tests reads no bytes. */
function aFile(text: string, name: string): File {
  const file = new File([text], name)
  const bytes = new TextEncoder().encode(text)
  vi.spyOn(file, 'slice').mockReturnValue({ arrayBuffer: () => Promise.resolve(bytes.buffer) } as Blob)
  return file
}

let server: ReturnType<typeof aTakeServer>

beforeEach(() => {
  vi.stubGlobal('AudioContext', HandContext)
  server = aTakeServer()
})

describe('reverb beside the dry stem', () => {
  const band = { hz: 500, curve_db: [0, -20, -40], rt60_s: 1.82, rate_db_s: -33 }
  const evidence = { decay: { start_s: 0, step_s: 0.05, bands: [band] }, coherence: null }
  const reverb = { verdict: 'reverb', score: 0.99, rt60_s: 1.8, evidence }
  const dry_stem = { file_name: 'dry.wav', file_bytes: 1_200_000, sha256: 's', received_at: '2026-11-20T10:00:00Z' }
  const beside = (stem: object, check: object = {}) =>
    aCheck({ judgements: { reverb: { ...reverb, stem: { name: 'dry.wav', ...stem } } }, dry_stem, ...check })
  const section = async () => {
    openApp('/takes/t1')
    return screen.findByRole('region', { name: 'Comparison with the dry stem' })
  }

  test.each([
    [{ verdict: 'reverb', rt60_s: 1.75, wet_db: -6.2 }, 'Reverb was added: its tail is 6.2 dB under the sound'],
    [{ verdict: 'dry' }, 'No reverb was added, down to 30 dB below the sound.'],
    [
      { verdict: 'undecided', why: 'the two are not the same sound' },
      'The two are not the same sound, so the result without the stem is kept.',
    ],
    [
      { verdict: 'unreadable', why: 'this is an MP3; export a WAV' },
      'The stem could not be read. This is an MP3; export a WAV.',
    ],
    [{ verdict: 'failed', why: 'our comparison of the two failed' }, 'That is our fault. Run the check again.'],
  ])('says what was found: %j', async (stem, said) => {
    server.on('GET /v1/takes/t1/check', beside(stem))
    const shown = await section()
    expect(within(shown).getByRole('status')).toHaveTextContent(said)
    expect(within(shown).getByRole('link', { name: 'Download stem' })).toHaveAttribute('href', '/v1/takes/t1/dry-stem')
  })

  test('is withdrawn by its designer, and the sound is judged without it', async () => {
    server.on('GET /v1/takes/t1/check', beside({ verdict: 'dry' })).on('DELETE /v1/takes/t1/dry-stem', () => {
      const alone = aCheck({ judgements: { reverb }, is_newest_stem: false })
      server.on('GET /v1/takes/t1/check', alone)
      return answer(null, 204)
    })
    const shown = await section()
    await userEvent.click(within(shown).getByRole('button', { name: 'Remove stem' }))
    await waitFor(() => expect(within(shown).getByRole('status')).toHaveTextContent('Checking again without the stem…'))
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb } }))
    expect(await within(shown).findByRole('button', { name: 'Add dry stem' })).toBeVisible()
    await waitFor(() => expect(within(shown).getByRole('status')).toHaveTextContent('measure the reverb exactly'))
  })

  test('cannot be changed once a verdict stands, nor by others', async () => {
    server
      .on('GET /v1/takes/t1', aVersion({ state: 'approved' }))
      .on('GET /v1/takes/t1/check', beside({ verdict: 'dry' }, { state: 'approved', is_newest_stem: false }))
    const shown = await section()
    expect(within(shown).getByRole('status')).toHaveTextContent('It arrived after the decision')
    expect(within(shown).queryByRole('button')).toBeNull()
  })

  test('is sent by its designer and given to the version once it is here', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb } })).on('PUT /v1/takes/t1/dry-stem', () => {
      server.on('GET /v1/takes/t1/check', beside({}, { judgements: { reverb }, is_newest_stem: false }))
      return {}
    })
    const shown = await section()
    const file = aFile('RIFF....WAVEfmt ', 'dry.wav')
    await userEvent.upload(within(shown).getByLabelText('File of the dry stem'), file)
    expect(await within(shown).findByRole('img', { name: 'dry.wav: 50 % here' })).toBeVisible()
    line.finish()
    await waitFor(() => expect(within(shown).getByRole('status')).toHaveTextContent('Comparing with the stem…'))
    expect(server.of('PUT /v1/takes/t1/dry-stem').map((asked) => asked.body)).toEqual([{ upload_id: 'u7' }])
    expect(line.bound).toEqual({ delivery_id: 'd1', take_id: 't1', file_name: 'dry.wav' })
  })

  test('is taken by a drop anywhere on the page, which says so while it hangs there', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb } }))
    const shown = await section()
    const dataTransfer = { types: ['Files'], items: [], files: [aFile('RIFF....WAVEfmt ', 'dry.wav')] }
    fireEvent(document.body, createEvent.dragEnter(document.body, { dataTransfer }))
    expect(shown.querySelector('[data-over]')).not.toBeNull()
    fireEvent(document.body, createEvent.drop(document.body, { dataTransfer }))
    expect(await within(shown).findByRole('img', { name: 'dry.wav: 50 % here' })).toBeVisible()
    expect(shown.querySelector('[data-over]')).toBeNull()
    expect(line.bound).toEqual({ delivery_id: 'd1', take_id: 't1', file_name: 'dry.wav' })
  })

  test('that is no sound at all is not sent, and says why', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb } }))
    const shown = await section()
    const picture = aFile('PNG', 'dry.wav.png')
    await userEvent.upload(within(shown).getByLabelText('File of the dry stem'), picture, { applyAccept: false })
    expect(await within(shown).findByRole('alert')).toHaveTextContent('Not an audio file or ZIP. Nothing was uploaded.')
  })

  test('is without fault for those who listen to the page', { tags: ['slow'] }, async () => {
    server.on('GET /v1/takes/t1/check', beside({ verdict: 'reverb', rt60_s: 1.75, wet_db: -6.2 }))
    const shown = await section()
    const { violations } = await axe.run(shown)
    expect(violations.map(({ id }) => id)).toEqual([])
  })
})
