/** The checksums of FLAC: CRC-8 and CRC-16 of its frames (RFC 9639, 9.1.8 and 9.3), MD5 of its samples (RFC 1321). */

const remainders = (bits: number, polynomial: number): Uint16Array =>
  Uint16Array.from({ length: 256 }, (_, byte) => {
    let rest = byte << (bits - 8)
    for (let bit = 0; bit < 8; bit++) rest = rest & (1 << (bits - 1)) ? (rest << 1) ^ polynomial : rest << 1
    return rest & (2 ** bits - 1)
  })
const OF_8 = remainders(8, 0x07)
const OF_16 = remainders(16, 0x8005)

export function crc8(bytes: Uint8Array): number {
  let rest = 0
  for (const byte of bytes) rest = OF_8[rest ^ byte]!
  return rest
}

export function crc16(bytes: Uint8Array): number {
  let rest = 0
  for (let at = 0; at < bytes.length; at++) rest = ((rest << 8) & 0xffff) ^ OF_16[(rest >> 8) ^ bytes[at]!]!
  return rest
}

const BLOCK_BYTES = 64
const START = [0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476]
const SINES = Int32Array.from({ length: 64 }, (_, step) => Math.floor(2 ** 32 * Math.abs(Math.sin(step + 1))))
/** One step: a sum of four, its bits turned round to the left, and one more. */
function step(sum: number, turn: number, more: number): number {
  return (((sum << turn) | (sum >>> (32 - turn))) + more) | 0
}

export class Md5 {
  readonly #state = Int32Array.from(START)
  /** Bytes that do not fill a block yet. */
  readonly #rest = new Uint8Array(BLOCK_BYTES)
  readonly #words = new DataView(this.#rest.buffer)
  #bytes = 0

  add(bytes: Uint8Array): void {
    let at = 0
    const held = this.#bytes % BLOCK_BYTES
    this.#bytes += bytes.length
    if (held > 0) {
      at = Math.min(BLOCK_BYTES - held, bytes.length)
      this.#rest.set(bytes.subarray(0, at), held)
      if (held + at < BLOCK_BYTES) return
      this.#block(this.#words, 0)
    }
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
    for (; at + BLOCK_BYTES <= bytes.length; at += BLOCK_BYTES) this.#block(view, at)
    this.#rest.set(bytes.subarray(at))
  }

  digest(): Uint8Array {
    const length = this.#bytes
    const padding = new Uint8Array(BLOCK_BYTES - ((length + 8) % BLOCK_BYTES) + 8)
    padding[0] = 0x80
    new DataView(padding.buffer).setBigUint64(padding.length - 8, BigInt(length) * 8n, true)
    this.add(padding)
    return new Uint8Array(this.#state.buffer)
  }

  #block(view: DataView, from: number): void {
    const state = this.#state
    let [a = 0, b = 0, c = 0, d = 0] = state
    const word = (index: number, place: number) => (SINES[index]! + view.getInt32(from + (place & 15) * 4, true)) | 0
    for (let at = 0; at < 16; at += 4) {
      a = step((a + ((b & c) | (~b & d)) + word(at, at)) | 0, 7, b)
      d = step((d + ((a & b) | (~a & c)) + word(at + 1, at + 1)) | 0, 12, a)
      c = step((c + ((d & a) | (~d & b)) + word(at + 2, at + 2)) | 0, 17, d)
      b = step((b + ((c & d) | (~c & a)) + word(at + 3, at + 3)) | 0, 22, c)
    }
    for (let at = 16; at < 32; at += 4) {
      a = step((a + ((b & d) | (c & ~d)) + word(at, 5 * at + 1)) | 0, 5, b)
      d = step((d + ((a & c) | (b & ~c)) + word(at + 1, 5 * at + 6)) | 0, 9, a)
      c = step((c + ((d & b) | (a & ~b)) + word(at + 2, 5 * at + 11)) | 0, 14, d)
      b = step((b + ((c & a) | (d & ~a)) + word(at + 3, 5 * at + 16)) | 0, 20, c)
    }
    for (let at = 32; at < 48; at += 4) {
      a = step((a + (b ^ c ^ d) + word(at, 3 * at + 5)) | 0, 4, b)
      d = step((d + (a ^ b ^ c) + word(at + 1, 3 * at + 8)) | 0, 11, a)
      c = step((c + (d ^ a ^ b) + word(at + 2, 3 * at + 11)) | 0, 16, d)
      b = step((b + (c ^ d ^ a) + word(at + 3, 3 * at + 14)) | 0, 23, c)
    }
    for (let at = 48; at < 64; at += 4) {
      a = step((a + (c ^ (b | ~d)) + word(at, 7 * at)) | 0, 6, b)
      d = step((d + (b ^ (a | ~c)) + word(at + 1, 7 * at + 7)) | 0, 10, a)
      c = step((c + (a ^ (d | ~b)) + word(at + 2, 7 * at + 14)) | 0, 15, d)
      b = step((b + (d ^ (c | ~a)) + word(at + 3, 7 * at + 21)) | 0, 21, c)
    }
    state[0] = state[0]! + a
    state[1] = state[1]! + b
    state[2] = state[2]! + c
    state[3] = state[3]! + d
  }
}
