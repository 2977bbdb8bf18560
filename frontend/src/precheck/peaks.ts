/** The largest sample of each channel, read in slices: a file is never in memory as a whole. */
import { type Layout, LeftToServer, type Read } from './wav'

export interface Peaks {
  /** Of each channel; full scale is 1. */
  channels: Float64Array
  /** The first frame in which a sample is as large as any. */
  frame: number
  /** The highest crests are cut off flat. */
  isCutOff: boolean
}

/** Whole frames, one slice after the other. */
export type Slices = AsyncGenerator<Uint8Array<ArrayBuffer>>

const SLICE_BYTES = 4 * 2 ** 20
/** More than this no sound has: the server refuses such a file. */
const MAX_LEVEL = 2 ** 64

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
    const sliceBytes = Math.min(atOnce, frames - first) * frameBytes
    const bytes = await read(dataOffset + first * frameBytes, sliceBytes)
    if (bytes.length < sliceBytes) throw new LeftToServer()
    yield bytes
  }
}

/** Samples on one level that are more than a crest, and how many such tops under full scale are no chance. */
const SHORTEST_RUN = 3
const FEWEST = 3
/** What the wave falls from one sample to the next at the end of a flat top, in steps; a round crest does not. */
const CORNER_STEPS = 20
const CORNER_OF_FLOAT = 8e-4
/** Of so many samples a flat top is that of a square wave, which has come from the other side. */
const SQUARE_RUN = 8
/** 0.1 dB under the highest sample: flat tops that low are what sets the peak. */
const CUT_OFF_SHARE = 10 ** (-0.1 / 20)

/** Looks for flat tops in one channel (audio_checks/measure/flat_tops.py knows more kinds of them). */
class FlatTops {
  #top = 0
  #run = 0
  #before = 0
  #last = 0
  #tops = 0
  #atRail = 0
  #isAtRail = false
  readonly #rail: number
  readonly #full: number
  readonly #corner: number

  constructor({ encoding, bitDepth, containerBits }: Layout, full: number) {
    const step = encoding === 'float' ? 0 : 2 ** (1 - bitDepth)
    this.#full = full
    this.#rail = full * (1 - Math.max(step, 2 ** -15))
    this.#corner = encoding === 'float' ? CORNER_OF_FLOAT : CORNER_STEPS * 2 ** (containerBits - bitDepth)
  }

  add(sample: number, level: number): void {
    if (level >= this.#rail) {
      this.#atRail = this.#last * sample > 0 && Math.abs(this.#last) >= this.#rail ? this.#atRail + 1 : 1
      this.#isAtRail ||= this.#atRail >= SHORTEST_RUN
    }
    if (level > this.#top) {
      this.#top = level
      this.#tops = 0
      this.#run = 0
    }
    if (level === this.#top) {
      if (this.#run === 0 || sample !== this.#last) {
        this.#run = 0
        this.#before = this.#last
      }
      this.#run += 1
    } else if (this.#run > 0) {
      this.#end(sample)
    }
    this.#last = sample
  }

  #end(after: number): void {
    const isSteep = (sample: number) => Math.abs(this.#last - sample) >= this.#corner
    const isSquare = this.#run >= SQUARE_RUN && this.#before * this.#last <= 0
    if (this.#run >= SHORTEST_RUN && isSteep(this.#before) && isSteep(after) && !isSquare) this.#tops += 1
    this.#run = 0
  }

  get isCutOff(): boolean {
    return this.#top <= this.#full && (this.#isAtRail || this.#tops >= FEWEST)
  }

  get top(): number {
    return this.#top
  }
}

/** Measure the peaks; throw LeftToServer for samples that are no numbers, or beyond any sound. */
export async function peaksOf(layout: Layout, slices: Slices): Promise<Peaks> {
  const { channels: count, containerBits, encoding } = layout
  const channels = new Float64Array(count)
  const scale = encoding === 'float' ? 1 : (SCALES[`pcm${containerBits}`] ?? 1)
  const tops = Array.from({ length: count }, () => new FlatTops(layout, scale))
  let highest = 0
  let frame = 0
  let first = 0
  for await (const bytes of slices) {
    const samples = samplesOf(bytes, layout)
    for (let index = 0, channel = 0; index < samples.length; index++) {
      const level = Math.abs(samples[index]!)
      if (!(level <= MAX_LEVEL)) throw new LeftToServer()
      tops[channel]!.add(samples[index]!, level)
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
  const isCutOff = tops.some((channel) => channel.isCutOff && channel.top >= highest * CUT_OFF_SHARE)
  return { channels: channels.map((level) => level / scale), frame, isCutOff }
}
