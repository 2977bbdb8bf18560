/** The frames of a FLAC file, decoded (RFC 9639, 9). */
import { LeftToServer } from '../wav'
import { Bits } from './bits'
import { crc16, crc8 } from './checksums'

/** Bytes that are no frame: they were changed on their way. */
export class Damaged extends Error {}

export interface Frame {
  /** How many samples each channel has. */
  size: number
  /** Of each channel, with at least so many; the next frame is written over them. */
  channels: readonly Float64Array[]
  /** Where the next frame begins. */
  end: number
}

interface Head {
  size: number
  assignment: number
}

const MOST_SIZE = 65_536
const SYNC = 0x7ffc // 15 bits: the mark, and one that is reserved
const DEPTHS: readonly (number | null)[] = [0, 8, 12, null, 16, 20, 24, 32] // 0: as STREAMINFO says
const LEFT_SIDE = 8
const SIDE_RIGHT = 9
const MID_SIDE = 10
/** What the coefficients of the fixed predictors are, the nearest sample last (9.2.5). */
const FIXED = [[], [1], [-1, 2], [1, -3, 3], [-1, 4, -6, 4]]

export class FrameDecoder {
  readonly #depth: number
  readonly #channels: Float64Array[]

  constructor(layout: { channels: number; bitDepth: number }) {
    this.#depth = layout.bitDepth
    this.#channels = Array.from({ length: layout.channels }, () => new Float64Array(0))
  }

  /** Decode the frame at a byte; throw OutOfBits where the bytes end inside of it, Damaged where it is none. */
  decode(bytes: Uint8Array, from: number): Frame {
    const bits = new Bits(bytes, from)
    const { size, assignment } = this.#head(bits, bytes, from)
    const channels = this.#channels
    if (channels[0]!.length < size) channels.forEach((_, index) => (channels[index] = new Float64Array(size)))
    channels.forEach((samples, index) => {
      const isSide = assignment === SIDE_RIGHT ? index === 0 : assignment >= LEFT_SIDE && index === 1
      subframe(bits, samples.subarray(0, size), this.#depth + Number(isSide))
    })
    const end = bits.byte
    bits.at = end * 8
    if (bits.read(16) !== crc16(bytes.subarray(from, end))) throw new Damaged()
    if (assignment >= LEFT_SIDE) decorrelate(channels[0]!, channels[1]!, size, assignment)
    return { size, channels, end: end + 2 }
  }

  #head(bits: Bits, bytes: Uint8Array, from: number): Head {
    if (bits.read(15) !== SYNC) throw new Damaged()
    bits.read(1) // whether the size of blocks varies, which is said by each
    const sizeCode = bits.read(4)
    const rateCode = bits.read(4)
    const assignment = bits.read(4)
    const depth = DEPTHS[bits.read(3)]
    if (bits.read(1) !== 0 || sizeCode === 0 || rateCode === 15 || assignment > MID_SIDE) throw new Damaged()
    if (depth === null || depth === undefined) throw new Damaged()
    passNumber(bits)
    const size = sizeOf(sizeCode, bits)
    if (rateCode >= 12) bits.read(rateCode === 12 ? 8 : 16)
    const sum = crc8(bytes.subarray(from, bits.byte))
    if (bits.read(8) !== sum || size > MOST_SIZE) throw new Damaged()
    const count = assignment < LEFT_SIDE ? assignment + 1 : 2
    // Valid, but not what the header of the file says.
    if (count !== this.#channels.length || (depth !== 0 && depth !== this.#depth)) throw new LeftToServer()
    return { size, assignment }
  }
}

/** Pass the number of the frame or sample, which is coded as in UTF-8. */
function passNumber(bits: Bits): void {
  const length = Math.clz32(~(bits.read(8) << 24))
  if (length === 1 || length > 7) throw new Damaged()
  for (let index = 1; index < length; index++) if (bits.read(8) >> 6 !== 0b10) throw new Damaged()
}

function sizeOf(code: number, bits: Bits): number {
  if (code === 1) return 192
  if (code < 6) return 576 << (code - 2)
  if (code < 8) return bits.read(code === 6 ? 8 : 16) + 1
  return 256 << (code - 8)
}

function subframe(bits: Bits, samples: Float64Array, depth: number): void {
  if (bits.read(1) !== 0) throw new Damaged()
  const kind = bits.read(6)
  const wasted = bits.read(1) === 1 ? bits.unary() + 1 : 0
  const width = depth - wasted
  if (width < 1) throw new Damaged()
  if (kind === 0) samples.fill(bits.signed(width))
  else if (kind === 1) verbatim(bits, samples, samples.length, width)
  else if (kind >= 8 && kind <= 12) fixed(bits, samples, kind - 8, width)
  else if (kind >= 32) linear(bits, samples, kind - 31, width)
  else throw new Damaged()
  if (wasted > 0) for (let index = 0; index < samples.length; index++) samples[index] = samples[index]! * 2 ** wasted
}

function verbatim(bits: Bits, samples: Float64Array, count: number, width: number): void {
  if (count > samples.length) throw new Damaged()
  for (let index = 0; index < count; index++) samples[index] = bits.signed(width)
}

function fixed(bits: Bits, samples: Float64Array, order: number, width: number): void {
  verbatim(bits, samples, order, width)
  residual(bits, samples, order)
  predict(samples, FIXED[order]!, 0)
}

function linear(bits: Bits, samples: Float64Array, order: number, width: number): void {
  verbatim(bits, samples, order, width)
  const precision = bits.read(4) + 1
  const shift = bits.signed(5)
  if (precision === 16 || shift < 0) throw new Damaged()
  const coefficients = Array.from({ length: order }, () => bits.signed(precision)).reverse()
  residual(bits, samples, order)
  predict(samples, coefficients, shift)
}

/** What the prediction is off by, from the sample at `order` on (9.2.7). */
function residual(bits: Bits, samples: Float64Array, order: number): void {
  const method = bits.read(2)
  const partitions = 2 ** bits.read(4)
  const partitionSize = samples.length / partitions
  if (method > 1 || !Number.isInteger(partitionSize) || partitionSize < order) throw new Damaged()
  const parameterBits = method === 0 ? 4 : 5
  for (let partition = 0; partition < partitions; partition++) {
    const from = partition === 0 ? order : partition * partitionSize
    const to = (partition + 1) * partitionSize
    const parameter = bits.read(parameterBits)
    if (parameter < 2 ** parameterBits - 1) bits.rice(samples, from, to, parameter)
    else {
      const width = bits.read(5)
      for (let index = from; index < to; index++) samples[index] = bits.signed(width)
    }
  }
}

/** Add to each sample what those before it predict. The sums are whole numbers below 2^53, so they are exact. */
function predict(samples: Float64Array, coefficients: readonly number[], shift: number): void {
  const order = coefficients.length
  const weights = Float64Array.from(coefficients)
  const scale = 2 ** -shift
  for (let index = order; index < samples.length; index++) {
    let sum = 0
    for (let tap = 0, before = index - order; tap < order; tap++, before++) sum += weights[tap]! * samples[before]!
    samples[index] = samples[index]! + Math.floor(sum * scale)
  }
}

/** Left and right of what was kept as one of them, or their mean, and their difference (4.2). */
function decorrelate(first: Float64Array, second: Float64Array, size: number, assignment: number): void {
  for (let index = 0; index < size; index++) {
    const a = first[index]!
    const b = second[index]!
    if (assignment === LEFT_SIDE) second[index] = a - b
    else if (assignment === SIDE_RIGHT) first[index] = a + b
    else {
      const sum = 2 * a + (b & 1)
      first[index] = (sum + b) / 2
      second[index] = (sum - b) / 2
    }
  }
}
