import { waitFor } from '@testing-library/react'
import { describe, expect, test, vi } from 'vitest'

import { ApiProblem } from '@/api'
import { HandTransport } from '@/test/upload'

import { type Upload } from './queue'
import { SMALL_BYTES, smallFilesTransport } from './small'

describe('small files', () => {
  const uploadOf = (size: number, kind: Upload['kind'] = 'sound') => ({ kind, file: { size } }) as unknown as Upload
  const eventsOf = () => ({
    onProgress: vi.fn(),
    onResumed: vi.fn(),
    onFinished: vi.fn(),
    onLost: vi.fn(),
    onRefused: vi.fn(),
  })

  test.each([
    ['a small sound in one request', uploadOf(SMALL_BYTES), 1],
    ['a larger one by what resumes', uploadOf(SMALL_BYTES + 1), 0],
    ['a ZIP by what resumes', uploadOf(100, 'archive'), 0],
  ])('%s', async (_, upload, times) => {
    const otherwise = new HandTransport()
    const send = vi.fn(() => Promise.resolve('u1'))
    const events = eventsOf()
    smallFilesTransport({ send, otherwise }).start(upload, events)
    await Promise.resolve()
    expect([send.mock.calls.length, otherwise.started.length]).toEqual([times, 1 - times])
    expect(events.onFinished).toHaveBeenCalledTimes(times)
  })

  test.each([
    [0, 'onLost'],
    [503, 'onLost'],
    [429, 'onLost'],
    [404, 'onRefused'],
    [413, 'onRefused'],
  ] as const)('status %s calls %s', async (status, called) => {
    const events = eventsOf()
    const send = () => Promise.reject(new ApiProblem(status, { code: 'any', detail: 'why' }))
    smallFilesTransport({ send, otherwise: new HandTransport() }).start(uploadOf(1), events)
    await waitFor(() => expect(events[called]).toHaveBeenCalledTimes(1))
  })

  test.each([
    [0, 1],
    [408, 1],
    [503, 0],
  ])('after status %s it resumes from then on: %s', async (status, resumes) => {
    const otherwise = new HandTransport()
    const events = eventsOf()
    const send = () => Promise.reject(new ApiProblem(status, { code: 'any', detail: 'why' }))
    const transport = smallFilesTransport({ send, otherwise })
    const upload = uploadOf(1)
    transport.start(upload, events)
    await waitFor(() => expect(events.onLost).toHaveBeenCalledTimes(1))
    transport.start(upload, events)
    expect(otherwise.started).toHaveLength(resumes)
  })

  test('one that was stopped says nothing more', async () => {
    const events = eventsOf()
    smallFilesTransport({ send: () => Promise.resolve('u1'), otherwise: new HandTransport() }).start(
      uploadOf(1),
      events,
    )(true)
    await new Promise((resolve) => setTimeout(resolve))
    expect(events.onFinished).not.toHaveBeenCalled()
  })
})
