import { File as NodeFile } from 'node:buffer'

import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'

import { ApiProblem } from '@/api'

import { filesOfDrop, filesOfField, isClutter } from './drops'
import { type QueueOptions, type Transport, type TransportEvents, type Upload, UploadQueue } from './queue'
import { SMALL_BYTES, smallFilesTransport } from './small'
import { judge, kindOf } from './sniff'
import { uploadIdOf } from './tus'

// jsdom's files cannot be read; Node's can.
const File = NodeFile as unknown as typeof globalThis.File

const bytes = (text: string, length = text.length) =>
  Uint8Array.from({ length }, (_, index) => (index < text.length ? text.charCodeAt(index) : 0))

describe('what a file is, by its first bytes', () => {
  test.each([
    ['RIFF\x24\x00\x00\x00WAVEfmt ', 'wav'],
    ['RF64\xff\xff\xff\xffWAVEds64', 'rf64'],
    ['RIFF\x24\x00\x00\x00AVI LIST', 'unknown'],
    ['PK\x03\x04', 'zip'],
    ['ID3\x04', 'mp3'],
    ['\xff\xfb\x90\x64', 'mp3'],
    ['\xff\xff\xff\xff', 'mp3'],
    ['\xff\xf1\x50\x80', 'unknown'],
    ['fLaC', 'flac'],
    ['FORM\x00\x00\x00\x00AIFC', 'aiff'],
    ['OggS', 'ogg'],
    ['\x00\x00\x00\x20ftypM4A ', 'mp4'],
    ['version https://git-lfs.github.com/spec/v1\n', 'lfs-pointer'],
    ['hello', 'unknown'],
    ['', 'unknown'],
  ])('%j is %s', (first, kind) => {
    expect(kindOf(bytes(first))).toBe(kind)
  })
})

describe('what goes on its way', () => {
  test.each([
    ['laser.wav', 'wav', { send: 'sound' }],
    ['long.wav', 'rf64', { send: 'sound' }],
    ['all.zip', 'zip', { send: 'archive' }],
    // A damaged WAV is the worker's to judge: it says which rule it breaks.
    ['broken.wav', 'unknown', { send: 'sound' }],
  ] as const)('%s, which is %s', (name, kind, judged) => {
    expect(judge(name, 100, kind)).toEqual(judged)
  })

  test.each([
    ['vo_oath.wav', 100, 'mp3', 'This is an MP3 named .wav. Export a WAV. Nothing was uploaded.'],
    ['vo_oath.mp3', 100, 'mp3', 'This is an MP3. Export a WAV. Nothing was uploaded.'],
    ['laser.wav', 0, 'unknown', 'The file is empty (0 bytes). Export it again. Nothing was uploaded.'],
    ['laser.wav', 100, 'zip', 'This is a ZIP named .wav. Rename it to .zip. Nothing was uploaded.'],
    ['notes.txt', 100, 'unknown', 'Not an audio file or ZIP. Nothing was uploaded.'],
  ] as const)('%s of %s bytes, which is %s, is stopped in words', (name, size, kind, refused) => {
    expect(judge(name, size, kind)).toEqual({ refused })
  })

  test.each([
    [{ kinds: ['wav', 'rf64'], sampleRatesHz: [44_100], bitDepths: [16] }, 'a WAV, 44.1 kHz, 16 bit'],
    [
      { kinds: ['wav', 'rf64', 'flac'], sampleRatesHz: [44_100, 48_000, 96_000], bitDepths: [16, 24] },
      'a WAV or FLAC, 44.1, 48 or 96 kHz, 16 or 24 bit',
    ],
  ] as const)('a refused file is answered by the spec of its project', (accepts, wanted) => {
    expect(judge('vo_oath.mp3', 100, 'mp3', accepts)).toEqual({
      refused: `This is an MP3. Export ${wanted}. Nothing was uploaded.`,
    })
  })

  test('a FLAC goes where the project takes FLAC', () => {
    const accepts = { kinds: ['wav', 'flac'], sampleRatesHz: null, bitDepths: null } as const
    expect(judge('laser.flac', 100, 'flac', accepts)).toEqual({ send: 'sound' })
  })
})

describe('drops', () => {
  const wav = (name: string) => new File([bytes('RIFF....WAVE')], name)
  const fileEntry = (path: string) => ({
    isFile: true,
    isDirectory: false,
    fullPath: path,
    file: (give: (file: File) => void) => give(wav(path.split('/').at(-1) ?? '')),
  })
  const folder = (path: string, inside: object[]) => ({
    isFile: false,
    isDirectory: true,
    fullPath: path,
    createReader: () => {
      const left = [...inside]
      return { readEntries: (give: (some: object[]) => void) => give(left.splice(0, 100)) }
    },
  })
  const drop = (entries: (object | null)[], files: File[] = []) =>
    ({
      items: entries.map((entry, index) => ({ webkitGetAsEntry: () => entry, getAsFile: () => files[index] ?? null })),
      files,
    }) as unknown as DataTransfer

  test('folders are walked to the end, a hundred at a time, without what systems leave about', async () => {
    const many = Array.from({ length: 250 }, (_, index) => fileEntry(`/sfx/steps/step_${index}.wav`))
    const picked = await filesOfDrop(
      drop(
        [folder('/sfx', [fileEntry('/sfx/.DS_Store'), folder('/sfx/steps', many)]), fileEntry('/laser.wav')],
        [wav('sfx'), wav('laser.wav')],
      ),
    )
    expect(picked).toHaveLength(251)
    expect(picked[0]?.path).toBe('sfx/steps/step_0.wav')
    expect(picked.at(-1)?.path).toBe('laser.wav')
  })

  test('a file is taken as it comes: asking a thousand entries for theirs takes long', async () => {
    const file = () => {
      throw new Error('asked of its entry')
    }
    const picked = await filesOfDrop(drop([{ ...fileEntry('/laser.wav'), file }], [wav('laser.wav')]))
    expect(picked.map(({ path }) => path)).toEqual(['laser.wav'])
  })

  test('without entries the plain list counts', async () => {
    const picked = await filesOfDrop(drop([null], [wav('laser.wav')]))
    expect(picked.map(({ path }) => path)).toEqual(['laser.wav'])
  })

  test('a folder field keeps the folders', () => {
    const file = wav('a.wav')
    Object.defineProperty(file, 'webkitRelativePath', { value: 'sfx/a.wav' })
    expect(filesOfField([file, wav('.hidden.wav')]).map(({ path }) => path)).toEqual(['sfx/a.wav'])
  })

  test.each(['.DS_Store', 'sfx/__MACOSX/a.wav', 'sfx/Thumbs.db', 'sfx/.git/config'])('%s is clutter', (path) => {
    expect(isClutter(path)).toBe(true)
  })
})

class HandTransport implements Transport {
  started: { upload: Upload; events: TransportEvents; stopped: boolean | null }[] = []

  start(upload: Upload, events: TransportEvents) {
    const one = { upload, events, stopped: null as boolean | null }
    this.started.push(one)
    return (forget: boolean) => {
      one.stopped = forget
    }
  }

  of(name: string) {
    const one = this.started.findLast(({ upload }) => upload.file.name === name)
    if (one === undefined) throw new Error(`${name} was not started`)
    return one
  }
}

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
    const told = vi.fn()
    queue.subscribe(told)
    for (const name of ['a.wav', 'b.wav']) transport.of(name).events.onFinished(name)
    await settled()
    expect(told).not.toHaveBeenCalled()
    transport.of('c.wav').events.onFinished('c')
    await settled()
    expect(told).toHaveBeenCalledTimes(1)
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

  test('what is no WAV is not sent, and says why', async () => {
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

  test('progress is told ten times a second at most, states at once', async () => {
    const queue = queueOf()
    await queue.add([wav('a.wav')])
    const told = vi.fn()
    queue.subscribe(told)
    for (let sent = 1; sent <= 50; sent += 1) transport.of('a.wav').events.onProgress(sent)
    expect(told).not.toHaveBeenCalled()
    await vi.advanceTimersByTimeAsync(100)
    expect(told).toHaveBeenCalledTimes(1)
    queue.pause()
    expect(told).toHaveBeenCalledTimes(2)
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

test.each([
  ['http://127.0.0.1:8000/v1/uploads/0193-a', '0193-a'],
  ['/v1/uploads/0193-a/?x=1', '0193-a'],
  [null, ''],
])('the id in %s is %s', (url, id) => {
  expect(uploadIdOf(url)).toBe(id)
})

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
    await vi.waitFor(() => expect(events[called]).toHaveBeenCalledTimes(1))
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
    await vi.waitFor(() => expect(events.onLost).toHaveBeenCalledTimes(1))
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
