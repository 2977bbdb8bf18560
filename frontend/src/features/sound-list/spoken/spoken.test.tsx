import { act, fireEvent, screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'

import { QueryClientProvider } from '@tanstack/react-query'

import { queryClient } from '@/api/queryClient'
import { draw } from '@/test/draw'
import { answer, refusal, serve, wrote } from '@/test/server'

import { SpokenPlaceholder } from './SpokenPlaceholder'
import { encodeWav } from './wav'

const SAID = {
  cue_id: 'c1',
  sha256: 'a'.repeat(64),
  duration_s: 0.42,
  recorded_by: { id: 'x1', name: 'Producer' },
  recorded_at: '2026-11-20T10:00:00Z',
}
const readBlob = Object.getOwnPropertyDescriptor(Blob.prototype, 'arrayBuffer')
const stopTrack = vi.fn()
const getUserMedia = vi.fn()

/** A microphone that hears half of full scale for ten frames. */
class FakeRecorder extends EventTarget {
  state = 'inactive'
  mimeType = 'audio/webm'
  start() {
    this.state = 'recording'
  }
  stop() {
    this.state = 'inactive'
    this.dispatchEvent(Object.assign(new Event('dataavailable'), { data: new Blob(['x']) }))
    this.dispatchEvent(new Event('stop'))
  }
}

class FakeContext {
  decodeAudioData() {
    return Promise.resolve({ numberOfChannels: 2, getChannelData: (at: number) => new Float32Array(10).fill(at) })
  }
}

beforeEach(() => {
  queryClient.clear()
  stopTrack.mockReset()
  getUserMedia.mockReset()
  getUserMedia.mockResolvedValue({ getTracks: () => [{ stop: stopTrack }] })
  vi.stubGlobal('MediaRecorder', FakeRecorder)
  vi.stubGlobal('OfflineAudioContext', FakeContext)
  Object.defineProperty(navigator, 'mediaDevices', { configurable: true, value: { getUserMedia } })
  Object.defineProperty(Blob.prototype, 'arrayBuffer', {
    configurable: true,
    value: () => Promise.resolve(new ArrayBuffer(1)),
  })
})
afterEach(() => {
  Reflect.deleteProperty(navigator, 'mediaDevices')
  if (readBlob) Object.defineProperty(Blob.prototype, 'arrayBuffer', readBlob)
  else Reflect.deleteProperty(Blob.prototype, 'arrayBuffer')
})

function show(said: unknown, mayEdit = true, more: object = {}) {
  const { asked } = serve({
    'GET /v1/cues/c1/spoken-placeholder': said,
    'PUT /v1/cues/c1/spoken-placeholder': SAID,
    'DELETE /v1/cues/c1/spoken-placeholder': answer(null, 204),
    ...more,
  })
  draw(
    <QueryClientProvider client={queryClient}>
      <SpokenPlaceholder cueId="c1" cueName="Door" projectId="p1" mayEdit={mayEdit} />
    </QueryClientProvider>,
  )
  return asked
}

const NOTHING = () => answer(null)
const hold = async () => {
  fireEvent.keyDown(window, { key: 'v' })
  await screen.findByText('Recording, 10 s at most.')
  act(() => {
    fireEvent.keyUp(window, { key: 'v' })
  })
}

test('a key that is held records a word, which is sent as a WAV', async () => {
  const asked = show(NOTHING)
  await screen.findByRole('button', { name: /Record a placeholder/ })
  await hold()
  await waitFor(() => expect(wrote(asked, 'PUT /v1/cues/c1/spoken-placeholder')).toHaveLength(1))
  const [sent] = wrote(asked, 'PUT /v1/cues/c1/spoken-placeholder')
  const bytes = atob((sent?.body as { content_base64: string }).content_base64)
  expect(bytes.slice(0, 4) + bytes.slice(8, 12)).toBe('RIFFWAVE')
  expect(stopTrack).toHaveBeenCalledTimes(1)
})

test('the button starts and stops', async () => {
  const asked = show(NOTHING)
  await userEvent.click(await screen.findByRole('button', { name: /Record a placeholder/ }))
  await userEvent.click(await screen.findByRole('button', { name: /Stop/ }))
  await waitFor(() => expect(wrote(asked, 'PUT /v1/cues/c1/spoken-placeholder')).toHaveLength(1))
})

test('what was said is played, and removed', async () => {
  const asked = show(SAID)
  expect(await screen.findByText(/0\.42 s, said by Producer/)).toBeVisible()
  expect(document.querySelector('audio')).toHaveAttribute('src', '/v1/cues/c1/spoken-placeholder/file?v=aaaaaaaaaaaa')
  await userEvent.click(screen.getByRole('button', { name: 'Remove' }))
  await waitFor(() => expect(wrote(asked, 'DELETE /v1/cues/c1/spoken-placeholder')).toHaveLength(1))
})

test.each([
  ['NotAllowedError', 'does not allow this page to use the microphone', 'Allow the microphone'],
  ['NotFoundError', 'No microphone was found', 'Connect one'],
  ['NotReadableError', 'could not be opened', 'Close other programs'],
])('a microphone that is refused by %s is explained', async (name, detail, fix) => {
  getUserMedia.mockRejectedValue(new DOMException('no', name))
  show(NOTHING)
  await userEvent.click(await screen.findByRole('button', { name: /Record a placeholder/ }))
  expect(await screen.findByRole('alert')).toHaveTextContent(new RegExp(`${detail}.*${fix}`))
})

test('a recording that was not sent can be sent again', async () => {
  let isDown = true
  const asked = show(NOTHING, true, {
    'PUT /v1/cues/c1/spoken-placeholder': () => (isDown ? refusal(503, 'busy', 'the server is busy') : answer(SAID)),
  })
  await screen.findByRole('button', { name: /Record a placeholder/ })
  await hold()
  const again = await screen.findByRole('button', { name: 'Send it again' })
  isDown = false
  await userEvent.click(again)
  await waitFor(() => expect(screen.queryByRole('alert')).toBeNull())
  const [first, second] = wrote(asked, 'PUT /v1/cues/c1/spoken-placeholder').slice(-2)
  expect(second?.body).toEqual(first?.body)
})

test('a designer hears it and says none', async () => {
  show(SAID, false)
  expect(await screen.findByRole('button', { name: 'Play placeholder' })).toBeVisible()
  expect(screen.queryByRole('button', { name: /Say/ })).toBeNull()
  const found = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(found.violations.map(({ id }) => id)).toEqual([])
})

test('channels are mixed and clipped at full scale', () => {
  const view = new DataView(encodeWav([Float32Array.of(1, 0, 3), Float32Array.of(0, -1, 3)]))
  expect(view.getUint32(24, true)).toBe(48_000)
  expect([44, 46, 48].map((at) => view.getInt16(at, true))).toEqual([16_384, -16_383, 32_767])
})
