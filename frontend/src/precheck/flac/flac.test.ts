import { createHash } from 'node:crypto'

import { expect, test } from 'vitest'

import { peaksOf } from '../peaks'
import { LeftToServer, type Read, Unreadable } from '../wav'
import { crc16, crc8, Md5 } from './checksums'
import type { FlacLayout } from './header'
import { flacSlices } from './samples'

const FRAME_FRAMES = 4_096
const LAYOUT: FlacLayout = {
  container: 'flac',
  encoding: 'pcm',
  sampleRateHz: 48_000,
  bitDepth: 24,
  containerBits: 24,
  channels: 1,
  channelMask: null,
  isAmbisonic: false,
  frames: FRAME_FRAMES,
  dataOffset: 42,
  md5: new Uint8Array(16),
}

/** A frame of one channel, 24 bit, as it is written where nothing packs better: its samples as they are. */
function verbatimFrame(sample: number): Uint8Array<ArrayBuffer> {
  const head = [0xff, 0xf8, 0xc0, 0x0c, 0x00]
  const bytes = new Uint8Array(head.length + 2 + 3 * FRAME_FRAMES + 2)
  bytes.set([...head, crc8(Uint8Array.from(head)), 0x02])
  for (let at = 7; at < bytes.length - 2; at += 3) bytes.set([sample >> 16, sample >> 8, sample], at)
  new DataView(bytes.buffer).setUint16(bytes.length - 2, crc16(bytes.subarray(0, -2)))
  return bytes
}

/** A file that has the same frame again and again, of which only what is asked for is in memory. */
function repeated(frame: Uint8Array, count: number): { read: Read; sizes: number[] } {
  const sizes: number[] = []
  const read: Read = (offset, wanted) => {
    const from = offset - LAYOUT.dataOffset
    sizes.push(wanted)
    const bytes = new Uint8Array(Math.max(0, Math.min(wanted, frame.length * count - from)))
    for (let at = 0; at < bytes.length;) {
      const inside = (from + at) % frame.length
      const piece = frame.subarray(inside, inside + bytes.length - at)
      bytes.set(piece, at)
      at += piece.length
    }
    return Promise.resolve(bytes)
  }
  return { read, sizes }
}

test('a long file is read in slices, and its frames are put together from two of them', async () => {
  const count = 200
  const { read, sizes } = repeated(verbatimFrame(-0x400000), count)
  const layout = { ...LAYOUT, frames: count * FRAME_FRAMES }
  let frames = 0
  for await (const bytes of flacSlices(layout, read)) {
    expect(bytes.length).toBeLessThanOrEqual(3 * FRAME_FRAMES)
    frames += bytes.length / 3
  }
  expect(frames).toBe(count * FRAME_FRAMES)
  expect([...new Set(sizes)]).toEqual([2 ** 20])
  const peaks = await peaksOf(layout, flacSlices(layout, read))
  expect([[...peaks.channels], peaks.frame]).toEqual([[0.5], 0])
})

test('a frame that does not end within reason is left to the server', async () => {
  const frame = verbatimFrame(0)
  const endless = repeated(new Uint8Array(2 ** 20), 100)
  // A fixed predictor, a Rice code, and zeros to the end.
  const read: Read = async (offset, count) => {
    const bytes = await endless.read(offset, count)
    if (offset === LAYOUT.dataOffset) bytes.set([...frame.subarray(0, 6), 0x10])
    return bytes
  }
  await expect(flacSlices(LAYOUT, read).next()).rejects.toBeInstanceOf(LeftToServer)
  expect(endless.sizes.length).toBeLessThan(8)
})

test('samples beyond their depth are left to the server', async () => {
  const frame = verbatimFrame(1)
  const { read } = repeated(frame, 1)
  await expect(flacSlices({ ...LAYOUT, bitDepth: 16 }, read).next()).rejects.toBeInstanceOf(LeftToServer)
})

test('a file that is cut is read no further than its end', async () => {
  const { read } = repeated(verbatimFrame(1), 3)
  const reading = (async () => {
    for await (const bytes of flacSlices({ ...LAYOUT, frames: 4 * FRAME_FRAMES }, read)) expect(bytes).not.toBeNull()
  })()
  await expect(reading).rejects.toBeInstanceOf(Unreadable)
})

test('the checksums are those of their standards', () => {
  const digits = new TextEncoder().encode('123456789')
  expect([crc8(digits), crc16(digits)]).toEqual([0xf4, 0xfee8])
  const bytes = Uint8Array.from({ length: 1_000 }, (_, index) => (index * 37) % 251)
  for (const lengths of [[], [1], [55], [56], [63, 1], [64], [65, 128, 3], [10, 500, 200], [119, 1, 0, 7]]) {
    const sum = new Md5()
    let at = 0
    for (const length of lengths) sum.add(bytes.subarray(at, (at += length)))
    const wanted = createHash('md5').update(bytes.subarray(0, at)).digest('hex')
    expect(Buffer.from(sum.digest()).toString('hex')).toBe(wanted)
  }
})
