import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'

import { ApiProblem } from '@/api'
import { bytes, File, HandTransport } from '@/test/upload'

import { type QueueOptions, type Upload, UploadQueue } from './queue'

describe('the queue', () => {
  let transport: HandTransport
  let clockMs: number
  const made: Upload[] = []

  beforeEach(() => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
    transport = new HandTransport()
    clockMs = 0
    made.length = 0
  })
  afterEach(() => vi.useRealTimers())

  const queueOf = (more: Partial<QueueOptions> = {}) =>
    new UploadQueue({
      transport,
      now: () => clockMs,
      onFinished: (upload) => {
        made.push(upload)
        return Promise.resolve()
      },
      ...more,
    })
  const wav = (name: string, size = 1000) => {
    const file = new File([bytes('RIFF....WAVEfmt ', size)], name, { lastModified: 1 })
    return { file, path: name }
  }
  const states = (queue: UploadQueue) => Object.fromEntries(queue.get().map(({ path, state }) => [path, state]))
  const settled = () => vi.advanceTimersByTimeAsync(0)

  test('four at a time, the next one when one is there', async () => {
    const queue = queueOf()
    await queue.add(['a', 'b', 'c', 'd', 'e', 'f'].map((name) => wav(`${name}.wav`)))
    expect(transport.started.map(({ upload }) => upload.file.name)).toEqual(['a.wav', 'b.wav', 'c.wav', 'd.wav'])
    transport.of('b.wav').events.onFinished('upload-b')
    await settled()
    expect(made.map(({ path }) => path)).toEqual(['b.wav'])
    expect(states(queue)).toMatchObject({ 'b.wav': 'finished', 'e.wav': 'sending', 'f.wav': 'waiting' })
  })

  test('many are listed some at a time, so that the page can draw between', async () => {
    vi.useRealTimers()
    const queue = queueOf()
    const picked = Array.from({ length: 120 }, (_, index) => wav(`${index}.wav`))
    const later = picked[50]?.file as File
    const listed: number[] = []
    vi.spyOn(later, 'slice').mockImplementation(() => {
      listed.push(queue.get().length)
      return new File([bytes('RIFF....WAVEfmt ')], '50.wav')
    })
    const tasks = vi.spyOn(globalThis, 'setTimeout')
    await queue.add(picked)
    expect(listed).toEqual([50])
    expect(tasks.mock.calls.filter(([, wait]) => wait === undefined)).toHaveLength(2)
    expect(queue.get()).toHaveLength(120)
    queue.dispose()
  })

  test('finished files are shown together while more go, and the last at once', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav'), wav('b.wav'), wav('c.wav')])
    await vi.advanceTimersByTimeAsync(100)
    const notified = vi.fn()
    queue.subscribe(notified)
    for (const name of ['a.wav', 'b.wav']) transport.of(name).events.onFinished(name)
    await settled()
    expect(notified).not.toHaveBeenCalled()
    transport.of('c.wav').events.onFinished('c')
    await settled()
    expect(notified).toHaveBeenCalledTimes(1)
    expect(queue.figures()).toMatchObject({ finished: 3 })
  })

  test('a lost line waits longer each time, goes on by itself, and says from where', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    transport.of('a.wav').events.onProgress(400)
    transport.of('a.wav').events.onLost()
    expect(states(queue)).toEqual({ 'a.wav': 'line_lost' })
    await vi.advanceTimersByTimeAsync(999)
    expect(transport.started).toHaveLength(1)
    await vi.advanceTimersByTimeAsync(1)
    expect(transport.started).toHaveLength(2)
    transport.of('a.wav').events.onLost()
    await vi.advanceTimersByTimeAsync(1999)
    expect(transport.started).toHaveLength(2)
    await vi.advanceTimersByTimeAsync(1)
    transport.of('a.wav').events.onResumed(400)
    expect(queue.get()[0]).toMatchObject({ state: 'sending', sentBytes: 400, resumedAtBytes: 400 })
  })

  test('growth proves the line: the wait begins at a second again', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    for (const wait of [1000, 2000]) {
      transport.of('a.wav').events.onLost()
      await vi.advanceTimersByTimeAsync(wait)
    }
    transport.of('a.wav').events.onProgress(500)
    transport.of('a.wav').events.onLost()
    await vi.advanceTimersByTimeAsync(1000)
    expect(transport.started).toHaveLength(4)
  })

  test('when the browser says the line is back, nobody waits on', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    transport.of('a.wav').events.onLost()
    queue.lineIsBack()
    expect(transport.started).toHaveLength(2)
    expect(states(queue)).toEqual({ 'a.wav': 'sending' })
  })

  test('paused, nothing is sent; resumed, it goes on', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav'), wav('b.wav')])
    queue.pause()
    expect(transport.started.map(({ stopped }) => stopped)).toEqual([false, false])
    await queue.add([wav('c.wav')])
    expect(states(queue)).toEqual({ 'a.wav': 'paused', 'b.wav': 'paused', 'c.wav': 'paused' })
    expect(transport.started).toHaveLength(2)
    queue.resume()
    expect(states(queue)).toEqual({ 'a.wav': 'sending', 'b.wav': 'sending', 'c.wav': 'sending' })
  })

  test('a word of a transport that was stopped changes nothing', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    const { events } = transport.of('a.wav')
    queue.pause()
    events.onProgress(900)
    events.onLost()
    events.onFinished('late')
    await settled()
    expect(queue.get()[0]).toMatchObject({ state: 'paused', sentBytes: 0 })
    expect(made).toEqual([])
  })

  test('stopped for good, what was sent is taken away and the next one starts', async () => {
    const queue = queueOf({ atATime: 1 })
    await queue.add([wav('a.wav'), wav('b.wav')])
    queue.stop(queue.get()[0]?.id ?? '')
    expect(transport.of('a.wav').stopped).toBe(true)
    expect(states(queue)).toEqual({ 'a.wav': 'stopped', 'b.wav': 'sending' })
  })

  test('the same name and size is here already; after a stop it may come again', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    await queue.add([wav('a.wav'), wav('a.wav', 2000)])
    expect(queue.get().map(({ state }) => state)).toEqual(['sending', 'already_here', 'sending'])
    queue.stop(queue.get()[0]?.id ?? '')
    await queue.add([wav('a.wav')])
    expect(queue.get().at(-1)?.state).toBe('sending')
  })

  test('what is not a WAV is not sent, and says why', async () => {
    const queue = queueOf()
    await queue.add([{ file: new File([bytes('ID3\x04')], 'vo_oath.wav'), path: 'vo_oath.wav' }])
    expect(transport.started).toEqual([])
    expect(queue.get()[0]).toMatchObject({ state: 'not_sent', reason: expect.stringContaining('MP3') as string })
  })

  test('a ZIP is one upload', async () => {
    const queue = queueOf()
    await queue.add([{ file: new File([bytes('PK\x03\x04')], 'all.zip'), path: 'all.zip' }])
    expect(queue.get()[0]).toMatchObject({ kind: 'archive', state: 'sending' })
  })

  test('a refusal stays with its row, and the others go on', async () => {
    const queue = queueOf({ atATime: 1 })
    await queue.add([wav('a.wav'), wav('b.wav')])
    transport.of('a.wav').events.onRefused('The delivery is not yours.')
    expect(queue.get()[0]).toMatchObject({ state: 'not_sent', reason: 'The delivery is not yours.' })
    expect(states(queue)['b.wav']).toBe('sending')
  })

  test('all bytes there but no answer to the take: only the take is asked for again', async () => {
    const answers = [new ApiProblem(0, { code: 'line-lost', detail: '' }), null]
    const asked: string[] = []
    const queue = queueOf({
      onFinished: (_upload, uploadId) => {
        asked.push(uploadId)
        const problem = answers.shift()
        return problem ? Promise.reject(problem) : Promise.resolve()
      },
    })
    await queue.add([wav('a.wav')])
    transport.of('a.wav').events.onFinished('upload-a')
    await settled()
    expect(states(queue)).toEqual({ 'a.wav': 'line_lost' })
    await vi.advanceTimersByTimeAsync(1000)
    expect(asked).toEqual(['upload-a', 'upload-a'])
    expect(transport.started).toHaveLength(1)
    expect(states(queue)).toEqual({ 'a.wav': 'finished' })
  })

  test('figures: what is there of what, how fast, how long still', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav', 3000), wav('b.wav', 1000)])
    await queue.add([{ file: new File([bytes('ID3\x04')], 'no.wav'), path: 'no.wav' }])
    transport.of('a.wav').events.onProgress(500)
    clockMs = 2000
    transport.of('a.wav').events.onProgress(1500)
    // 1000 bytes in 2 s, 2500 bytes are left.
    expect(queue.figures()).toEqual({
      files: 2,
      finished: 0,
      sentBytes: 1500,
      totalBytes: 4000,
      bytesPerS: 500,
      secondsLeft: 5,
    })
  })

  test('progress is reported ten times a second at most, states at once', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    const notified = vi.fn()
    queue.subscribe(notified)
    for (let sent = 1; sent <= 50; sent += 1) transport.of('a.wav').events.onProgress(sent)
    expect(notified).not.toHaveBeenCalled()
    await vi.advanceTimersByTimeAsync(100)
    expect(notified).toHaveBeenCalledTimes(1)
    queue.pause()
    expect(notified).toHaveBeenCalledTimes(2)
  })

  test('a row that is not on its way can be taken off the list', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    const id = queue.get()[0]?.id ?? ''
    queue.dismiss(id)
    expect(queue.get()).toHaveLength(1)
    queue.stop(id)
    queue.dismiss(id)
    expect(queue.get()).toHaveLength(0)
  })
})
