/** Bytes read bit by bit, the highest bit first. */

/** The bytes at hand end; more of the file may follow. */
export class OutOfBits extends Error {}

/** Zeros behind the last byte: a word of 32 bits may be read at any place. */
export const SPARE_BYTES = 8
/** Bits that a word holds at any place inside a byte. */
const WORD_BITS = 25

export class Bits {
  /** The place of the next bit. */
  at: number
  readonly #view: DataView
  readonly #end: number

  /** Read from a byte on; behind the last byte the array has zeros to spare. */
  constructor(bytes: Uint8Array, from: number) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
    this.#end = (bytes.length - SPARE_BYTES) * 8
    this.at = from * 8
  }

  get byte(): number {
    return Math.ceil(this.at / 8)
  }

  /** A whole number of up to 32 bits. */
  read(count: number): number {
    if (count > WORD_BITS) return this.read(count - 16) * 2 ** 16 + this.read(16)
    const word = this.#view.getUint32(this.at >>> 3) << (this.at & 7)
    this.#pass(count)
    return (word >>> 1) >>> (31 - count)
  }

  /** A whole number in two's complement. */
  signed(count: number): number {
    const value = this.read(count)
    return count > 0 && value >= 2 ** (count - 1) ? value - 2 ** count : value
  }

  /** How many zeros come before the next one. */
  unary(): number {
    for (let zeros = 0; ;) {
      const inside = this.at & 7
      const word = this.#view.getUint32(this.at >>> 3) << inside
      if (word !== 0) {
        const run = Math.clz32(word)
        this.#pass(run + 1)
        return zeros + run
      }
      this.#pass(32 - inside)
      zeros += 32 - inside
    }
  }

  /** Rice codes with a parameter, as signed numbers, into a part of an array (RFC 9639, 9.2.7.2). */
  rice(into: Float64Array, from: number, to: number, parameter: number): void {
    const view = this.#view
    let at = this.at
    for (let index = from; index < to; index++) {
      const word = view.getUint32(at >>> 3) << (at & 7)
      const zeros = Math.clz32(word)
      let folded: number
      if (zeros + parameter < WORD_BITS) {
        folded = (zeros << parameter) | (((word << (zeros + 1)) >>> 1) >>> (31 - parameter))
        at += zeros + 1 + parameter
      } else {
        this.at = at
        folded = this.unary() * 2 ** parameter + this.read(parameter)
        at = this.at
      }
      into[index] = (folded >>> 1) ^ -(folded & 1)
    }
    this.at = at
    this.#pass(0)
  }

  #pass(count: number): void {
    this.at += count
    if (this.at > this.#end) throw new OutOfBits()
  }
}
