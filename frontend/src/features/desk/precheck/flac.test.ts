import { Blob as NodeBlob, File as NodeFile } from 'node:buffer'

import { describe, expect, test } from 'vitest'

import type { SpecView } from './checks'
import { judgeFile } from './judge'
import vectors from './vectors.json'

interface Head {
  rate: number
  channels: number
  depth: number
  frames: number
  size?: number
}

/** A FLAC up to the end of STREAMINFO (RFC 9639, 8.2): 20 bits of rate, 3 of channels, 5 of depth, 36 of frames. */
function flac({ rate, channels, depth, frames, size = 34 }: Head): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(42)
  const view = new DataView(bytes.buffer)
  bytes.set([0x66, 0x4c, 0x61, 0x43, 0x80])
  view.setUint8(7, size)
  view.setUint16(8, 4_096)
  view.setUint16(10, 4_096)
  const packed = (BigInt(rate) << 44n) | (BigInt(channels - 1) << 41n) | (BigInt(depth - 1) << 36n) | BigInt(frames)
  view.setBigUint64(18, packed)
  return bytes
}

const base = vectors[0]!.spec as SpecView
const spec: SpecView = {
  ...base,
  levels: {},
  accept: {
    ...base.accept,
    containers: ['wav', 'flac'],
    encodings: ['pcm'],
    sample_rates_hz: [44_100, 48_000],
    bit_depths: [16, 24],
    channels: [1, 2],
    layouts: null,
    duration_s: { min: 0.01, max: 30 },
  },
}
const PLAIN: Head = { rate: 48_000, channels: 2, depth: 24, frames: 48_000 }

const judged = (bytes: Uint8Array<ArrayBuffer>, wanted = spec) =>
  judgeFile({ file: new NodeBlob([bytes]) as Blob, spec: wanted, length: null })
const codes = async (head: Partial<Head>, wanted = spec) =>
  (await judged(flac({ ...PLAIN, ...head }), wanted))?.findings.map(({ code }) => code)

describe('the header of a FLAC', () => {
  test.each([
    ['as the spec wants it', {}, []],
    ['of another rate', { rate: 96_000 }, ['sample-rate:not-accepted']],
    ['too long by one sample', { frames: 1_440_001 }, ['duration:long']],
    ['of more than 2^32 samples', { frames: 2 ** 32 + 1 }, ['duration:long']],
    ['too short', { frames: 479 }, ['duration:short']],
    ['of both', { rate: 22_050, frames: 1 }, ['sample-rate:not-accepted', 'duration:short']],
  ])('%s', async (_, head, found) => {
    expect(await codes(head)).toEqual(found)
  })

  test('channels, depth and container are held to the spec', async () => {
    const mono = { ...spec, accept: { ...spec.accept, channels: [1], bit_depths: [16], containers: ['wav'] } }
    expect(await codes({}, mono)).toEqual(['container:not-accepted', 'bit-depth:not-accepted', 'channels:not-accepted'])
  })

  test.each([
    ['an open length', { frames: 0 }],
    ['no rate', { rate: 0 }],
    ['a depth that is seldom', { depth: 20 }],
    ['more than two channels', { channels: 6 }],
    ['a block of another size', { size: 33 }],
  ])('with %s is left to the server', async (_, head) => {
    expect(await judged(flac({ ...PLAIN, ...head }))).toBeNull()
  })

  test('cut short, or under another name, it is left to the server', async () => {
    expect(await judged(flac(PLAIN).subarray(0, 25))).toBeNull()
    const renamed = new NodeFile([flac(PLAIN)], 'laser.wav')
    expect(await judgeFile({ file: renamed as unknown as File, spec, length: null })).toBeNull()
  })
})
