import { execFileSync } from 'node:child_process'
import { once } from 'node:events'
import { readFile, writeFile } from 'node:fs/promises'
import { createServer, type Server as Listener, type ServerResponse } from 'node:http'
import type { AddressInfo } from 'node:net'
import { setTimeout as wait } from 'node:timers/promises'

import { expect, type Page, test } from '@playwright/test'

import type * as Heard from './heard'
import { heardScript } from './heardScript'
import { PYTHON, ROOT } from './server'

const RATE_HZ = 48_000
const LONG_S = 60
/** What is promised, and how much later it may be on a machine that does other things too. */
const FIRST_SOUND_MS = 150
const BUSY = 3
const RUNS = 10
const FADE_FRAMES = 0.005 * RATE_HZ

declare const heard: typeof Heard
declare const output: Output

/** What the page recorded at the destination of its context. */
interface Output {
  player: Heard.Player
  /** The time of the first sound, by the clock of the page. */
  firstSoundMs: () => number
  pressedMs: () => number
  /** All samples from the first sound on. */
  samples: () => number[]
}

/** A sweep, in which each place is known by its samples; both channels alike. */
const sweep = (frame: number, topHz: number): number => {
  const s = frame / RATE_HZ
  return Math.round(16_000 * Math.cos(2 * Math.PI * (200 * s + ((topHz - 200) * s * s) / (2 * LONG_S)))) / 32_768
}

function wav(topHz: number): Buffer {
  const bytes = Buffer.alloc(44 + LONG_S * RATE_HZ * 4)
  bytes.write('RIFF', 0)
  bytes.writeUInt32LE(bytes.length - 8, 4)
  bytes.write('WAVEfmt ', 8)
  for (const [value, at] of [[16, 16], [RATE_HZ, 24], [RATE_HZ * 4, 28], [bytes.length - 44, 40]] as const) bytes.writeUInt32LE(value, at) // prettier-ignore
  for (const [value, at] of [[1, 20], [2, 22], [4, 32], [16, 34]] as const) bytes.writeUInt16LE(value, at) // prettier-ignore
  bytes.write('data', 36)
  for (let frame = 0; frame < LONG_S * RATE_HZ; frame += 1) {
    const value = sweep(frame, topHz) * 32_768
    bytes.writeInt16LE(value, 44 + 4 * frame)
    bytes.writeInt16LE(value, 46 + 4 * frame)
  }
  return bytes
}

/** The line on which files come: real bytes in small pieces, as a browser has them from a network. */
const line = { bytesPerS: Infinity, latencyMs: 0 }
const SEGMENT_BYTES = 1_460

async function send(answer: ServerResponse, bytes: Buffer): Promise<void> {
  await wait(line.latencyMs)
  const startedMs = performance.now()
  for (let sent = 0; sent < bytes.length && !answer.destroyed;) {
    const due = Math.min(bytes.length, ((performance.now() - startedMs) / 1_000) * line.bytesPerS)
    for (; sent + SEGMENT_BYTES <= due || (due === bytes.length && sent < due); sent += SEGMENT_BYTES) {
      answer.write(bytes.subarray(sent, sent + SEGMENT_BYTES))
    }
    await wait(1)
  }
  answer.end()
}

let script: string
let listener: Listener
const files = new Map<string, { type: string; bytes: Buffer }>()

test.beforeAll(async () => {
  const testInfo = test.info()
  script = await heardScript()
  files.set('/', { type: 'text/html', bytes: Buffer.from('<!doctype html><title>Heard</title>') })
  for (const [name, topHz] of [
    ['/a', 2_000],
    ['/b', 6_000],
  ] as const) {
    const bytes = wav(topHz)
    const [path, light] = [testInfo.outputPath(`${name.slice(1)}.wav`), testInfo.outputPath(`${name.slice(1)}.ogg`)]
    await writeFile(path, bytes)
    const code = 'import sys, audio_checks; assert audio_checks.light_preview(*sys.argv[1:])'
    execFileSync(PYTHON, ['-c', code, path, light], { cwd: ROOT })
    files.set(name, { type: 'audio/wav', bytes })
    files.set(`${name}?light=true`, { type: 'audio/ogg', bytes: await readFile(light) })
  }
  listener = createServer((request, answer) => {
    const file = files.get(request.url ?? '')
    const part = /^bytes=0-([0-9]+)$/.exec(request.headers.range ?? '')
    const bytes = part ? file?.bytes.subarray(0, Number(part[1]) + 1) : file?.bytes
    answer.writeHead(file ? (part ? 206 : 200) : 404, { 'Content-Type': file?.type ?? 'text/plain' })
    if (bytes === undefined || line.bytesPerS === Infinity) answer.end(bytes)
    else void send(answer, bytes)
  }).listen(0, '127.0.0.1')
  await once(listener, 'listening')
})

test.afterAll(() => listener.close())

/** A page that plays by the player and records what reaches the device; Space plays. */
async function open(page: Page, mbitPerS?: number, latencyMs = 0): Promise<void> {
  await page.goto(`http://127.0.0.1:${(listener.address() as AddressInfo).port}/`)
  await page.addScriptTag({ content: script })
  await page.evaluate(async () => {
    const recorder = `registerProcessor('recorder', class extends AudioWorkletProcessor {
      process([input]) {
        if (input[0]) this.port.postMessage({ frame: currentFrame, samples: input[0].slice() })
        return true
      }
    })`
    const context = new AudioContext({ sampleRate: 48_000 })
    await context.audioWorklet.addModule(URL.createObjectURL(new Blob([recorder], { type: 'text/javascript' })))
    const node = new AudioWorkletNode(context, 'recorder')
    node.connect(context.destination)
    const blocks: { frame: number; samples: Float32Array }[] = []
    node.port.onmessage = ({ data }: MessageEvent<{ frame: number; samples: Float32Array }>) => {
      if (blocks.length > 0 || data.samples.some((value) => value !== 0)) blocks.push(data)
    }
    // All that is connected to the device is recorded on its way.
    const connect = Reflect.get(AudioNode.prototype, 'connect') as (this: AudioNode, to: AudioNode) => AudioNode
    Object.assign(AudioNode.prototype, {
      connect(this: AudioNode, to: AudioNode) {
        return connect.call(this, to === context.destination ? node : to)
      },
    })
    await context.resume()
    const player = new heard.Player({ createContext: () => context, light: true, held: true })
    let pressedMs = 0
    addEventListener('keydown', (event) => {
      pressedMs = event.timeStamp
      void player.play()
    })
    const first = () => {
      const [block] = blocks
      if (!block) return -1
      return block.frame + block.samples.findIndex((value) => value !== 0)
    }
    const output: Output = {
      player,
      pressedMs: () => pressedMs,
      firstSoundMs: () => {
        const { contextTime = 0, performanceTime = 0 } = context.getOutputTimestamp()
        return first() < 0 ? Infinity : performanceTime + (first() / context.sampleRate - contextTime) * 1_000
      },
      samples: () => blocks.flatMap(({ samples }) => [...samples]).slice(first() - (blocks[0]?.frame ?? 0)),
    }
    Object.assign(globalThis, { output })
  })
  if (mbitPerS === undefined) return
  const devtools = await page.context().newCDPSession(page)
  await devtools.send('Network.enable')
  await devtools.send('Network.emulateNetworkConditions', {
    offline: false,
    latency: latencyMs,
    downloadThroughput: (mbitPerS * 1_000_000) / 8,
    uploadThroughput: (mbitPerS * 1_000_000) / 8,
  })
}

const soundsWithinMs = async (page: Page): Promise<number> => {
  await expect.poll(() => page.evaluate(() => output.firstSoundMs())).toBeLessThan(Infinity)
  return page.evaluate(() => output.firstSoundMs() - output.pressedMs())
}

/** The first and last place at which what was heard is not the exact sound. */
function apart(samples: readonly number[], topHz: number, from: number, to: number): { first: number; last: number } {
  let [first, last] = [-1, -1]
  for (let frame = from; frame < to; frame += 1) {
    if (Math.abs((samples[frame] ?? 0) - sweep(frame, topHz)) < 1e-4) continue
    if (first < 0) first = frame
    last = frame
  }
  return { first, last }
}

test('a sound that is next plays at once over 5 Mbit/s and 80 ms, and the exact one takes over without a gap @slow', async ({
  page,
}) => {
  await open(page, 5, 80)
  await page.evaluate(() => {
    output.player.previews.release()
    return output.player.select({ id: 'a', url: '/a' })
  })
  await page.keyboard.press('Space')
  const firstMs = await soundsWithinMs(page)
  expect(await page.evaluate(() => output.player.getState().isLight)).toBe(true)
  await expect.poll(() => page.evaluate(() => output.player.getState().isLight), { timeout: 90_000 }).toBe(false)
  await page.waitForTimeout(1_000)
  const samples = await page.evaluate(() => output.samples())
  const { last } = apart(samples, 2_000, 0, samples.length)
  const [window, levels] = [FADE_FRAMES, [] as number[]]
  for (let start = window; start + window <= samples.length; start += window) {
    levels.push(Math.sqrt(samples.slice(start, start + window).reduce((sum, value) => sum + value ** 2, 0) / window))
  }
  const [least, middle] = [Math.min(...levels), levels.sort((a, b) => a - b)[Math.floor(levels.length / 2)] ?? 0]
  console.log(
    `key to first sound ${firstMs.toFixed(0)} ms; exact after ${(last / RATE_HZ).toFixed(2)} s of sound; ` +
      `least level of 5 ms ${(20 * Math.log10(least / middle)).toFixed(1)} dB beside the middle one`,
  )
  expect(firstMs).toBeLessThan(BUSY * FIRST_SOUND_MS)
  // From there on each sample is that of the exact sound, at the very place at which the preview was.
  expect(samples.length - last).toBeGreaterThan(RATE_HZ / 4)
  expect(last).toBeLessThan(LONG_S * RATE_HZ)
  expect(20 * Math.log10(least / middle)).toBeGreaterThan(-3)
})

test('a switch between alternates takes 5 ms of what is heard, to the sample @slow', async ({ page }) => {
  await open(page)
  await page.evaluate(async () => {
    output.player.previews.release()
    await Promise.all(['/a', '/b'].map((url) => output.player.previews.get(url)))
    await output.player.select({ id: 'a', url: '/a' })
  })
  await page.keyboard.press('Space')
  await soundsWithinMs(page)
  await page.waitForTimeout(500)
  await page.evaluate(() => output.player.select({ id: 'b', url: '/b' }))
  await page.waitForTimeout(500)
  const samples = await page.evaluate(() => output.samples())
  const { first } = apart(samples, 2_000, 0, samples.length)
  const { last } = apart(samples, 6_000, 0, samples.length)
  console.log(`a switch: ${(((last - first + 1) / RATE_HZ) * 1_000).toFixed(2)} ms`)
  expect(first).toBeGreaterThan(RATE_HZ / 10)
  expect(last - first + 1).toBeLessThanOrEqual(FADE_FRAMES + 1)
})

/** How far what was heard is from the whole light preview, sample by sample, and how much of it was compared. */
const besideTheWhole = (page: Page) =>
  page.evaluate(async () => {
    const bytes = await (await fetch('/a?light=true')).arrayBuffer()
    const whole = (await new OfflineAudioContext(2, 1, 48_000).decodeAudioData(bytes)).getChannelData(0)
    const from = whole.findIndex((value) => value !== 0)
    const samples = output.samples()
    const most = samples.reduce((worst, value, at) => Math.max(worst, Math.abs(value - (whole[from + at] ?? 0))), 0)
    return { most, seconds: samples.length / 48_000 }
  })

const middle = (values: readonly number[]): number =>
  [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? 0

/** Play a sound of 60 s in a new page, over 5 Mbit/s and 80 ms. */
async function playCold(page: Page, isBegun: boolean): Promise<number> {
  Object.assign(line, { bytesPerS: Infinity, latencyMs: 0 })
  await open(page)
  if (isBegun) {
    await page.evaluate(() => {
      output.player.previews.keepReady([], [], ['/a'])
      output.player.previews.release()
    })
    await page.waitForTimeout(500)
  }
  Object.assign(line, { bytesPerS: 5_000_000 / 8, latencyMs: 80 })
  await page.evaluate((durationS) => void output.player.select({ id: 'a', url: '/a', durationS }), LONG_S)
  await page.keyboard.press('Space')
  return soundsWithinMs(page)
}

for (const isBegun of [false, true]) {
  const here = isBegun ? 'the first bytes are' : 'nothing is'
  test(`a sound of which ${here} here plays before the rest of it comes, and each longer piece goes on without a gap @slow`, async ({
    page,
  }) => {
    const firstMs: number[] = []
    const compared: Awaited<ReturnType<typeof besideTheWhole>>[] = []
    for (let run = 0; run < RUNS; run += 1) {
      firstMs.push(await playCold(page, isBegun))
      expect(await page.evaluate(() => output.player.getState())).toMatchObject({ isLight: true, durationS: LONG_S })
      await page.waitForTimeout(run < RUNS - 1 ? 1_000 : 4_000)
      compared.push(await besideTheWhole(page))
    }
    Object.assign(line, { bytesPerS: Infinity, latencyMs: 0 })
    const times = firstMs.map((ms) => ms.toFixed(0)).join(' ')
    const most = compared.map((one) => one.most)
    const seconds = compared.reduce((sum, one) => sum + one.seconds, 0)
    console.log(
      `${here} here: ${middle(firstMs).toFixed(0)} ms (${times}); at most ${Math.max(...most).toExponential(1)} off in ${seconds.toFixed(1)} s`,
    )
    expect(middle(firstMs)).toBeLessThan(BUSY * FIRST_SOUND_MS)
    expect(seconds).toBeGreaterThan(RUNS)
    // A busy machine does not always have a piece ready in time; a fault of the seam is in every third run.
    expect(most.filter((off) => off < 1e-3).length).toBeGreaterThanOrEqual(RUNS - 1)
  })
}
