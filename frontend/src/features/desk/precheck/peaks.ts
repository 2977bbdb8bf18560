/** The largest sample of each channel, read in slices: a file is never in memory as a whole. */
import { type Layout, LeftToServer, type Read } from './wav'

export interface Peaks {
  /** Of each channel; full scale is 1. */
  channels: Float64Array
  /** The first frame in which a sample is as large as any. */
  frame: number
}

/** Whole frames, one slice after the other. */
export type Slices = AsyncGenerator<Uint8Array<ArrayBuffer>>

const SLICE_BYTES = 4 * 2 ** 20
/** More than this no sound has: the server refuses such a file. */
const MOST = 2 ** 64

type Samples = ArrayLike<number>

const SCALES: Record<string, number> = { pcm8: 2 ** 7, pcm16: 2 ** 15, pcm24: 2 ** 23, pcm32: 2 ** 31 }

/** Samples of 24 bits, as whole numbers. */
function of24(bytes: Uint8Array): Int32Array {
  const samples = new Int32Array(bytes.length / 3)
  for (let index = 0, at = 0; index < samples.length; index++, at += 3) {
    samples[index] = ((bytes[at]! << 8) | (bytes[at + 1]! << 16) | (bytes[at + 2]! << 24)) >> 8
  }
  return samples
}

function samplesOf(bytes: Uint8Array<ArrayBuffer>, { encoding, containerBits }: Layout): Samples {
  if (encoding === 'float')
    return containerBits === 32 ? new Float32Array(bytes.buffer) : new Float64Array(bytes.buffer)
  switch (containerBits) {
    case 8:
      return Int16Array.from(bytes, (byte) => byte - 128)
    case 16:
      return new Int16Array(bytes.buffer)
    case 24:
      return of24(bytes)
    default:
      return new Int32Array(bytes.buffer)
  }
}

/** The samples of a WAV file, a slice at a time. */
export async function* wavSlices(layout: Layout, read: Read): Slices {
  const { channels, containerBits, frames, dataOffset } = layout
  const frameBytes = (channels * containerBits) / 8
  const atOnce = Math.max(1, Math.floor(SLICE_BYTES / frameBytes))
  for (let first = 0; first < frames; first += atOnce) {
    const wanted = Math.min(atOnce, frames - first) * frameBytes
    const bytes = await read(dataOffset + first * frameBytes, wanted)
    if (bytes.length < wanted) throw new LeftToServer()
    yield bytes
  }
}

/** Measure the peaks; throw LeftToServer for samples that are no numbers, or beyond any sound. */
export async function peaksOf(layout: Layout, slices: Slices): Promise<Peaks> {
  const { channels: count, containerBits, encoding } = layout
  const channels = new Float64Array(count)
  let highest = 0
  let frame = 0
  let first = 0
  for await (const bytes of slices) {
    const samples = samplesOf(bytes, layout)
    for (let index = 0, channel = 0; index < samples.length; index++) {
      const level = Math.abs(samples[index]!)
      if (!(level <= MOST)) throw new LeftToServer()
      if (level > channels[channel]!) {
        channels[channel] = level
        if (level > highest) {
          highest = level
          frame = first + Math.floor(index / count)
        }
      }
      channel = channel + 1 === count ? 0 : channel + 1
    }
    first += samples.length / count
  }
  const scale = encoding === 'float' ? 1 : (SCALES[`pcm${containerBits}`] ?? 1)
  return { channels: channels.map((level) => level / scale), frame }
}
