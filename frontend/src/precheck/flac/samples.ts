/** The samples of a FLAC file as a WAV holds them, a frame at a time: a file is never in memory as a whole. */
import { LeftToServer, type Read, Unreadable } from '../wav'
import { OutOfBits, SPARE_BYTES } from './bits'
import { Md5 } from './checksums'
import { Damaged, type Frame, FrameDecoder } from './frames'
import type { FlacLayout } from './header'

const SLICE_BYTES = 2 ** 20
/** No sensible frame is larger: 65,536 samples of 8 channels and 24 bits have 1.5 MiB as they are. */
const MOST_FRAME_BYTES = 4 * 2 ** 20
const UPLOAD_AGAIN = 'export or copy it again; the file was cut short on its way'

const damaged = (why: string) =>
  new Unreadable(`the FLAC file is damaged: ${why}`, 'R1', 'structure:flac-damaged', UPLOAD_AGAIN)

/** Yield the samples; throw Unreadable where they are not what the header says. */
export async function* flacSlices(layout: FlacLayout, read: Read): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  const sum = new Md5()
  let left = layout.frames
  for await (const { size, channels } of framesOf(layout, read)) {
    const bytes = pcmOf(channels, Math.min(size, left), layout.bitDepth)
    left -= Math.min(size, left)
    sum.add(bytes)
    // A WAV holds samples of 8 bits without a sign.
    yield layout.bitDepth === 8 ? bytes.map((byte) => byte ^ 0x80) : bytes
    if (left === 0) break
  }
  const digest = sum.digest()
  if (layout.md5.some((byte) => byte !== 0) && layout.md5.some((byte, index) => byte !== digest[index])) {
    throw damaged('its samples do not have the checksum that was packed with them')
  }
}

async function* framesOf(layout: FlacLayout, read: Read): AsyncGenerator<Frame> {
  const decoder = new FrameDecoder(layout)
  let held = new Uint8Array(SPARE_BYTES)
  let at = 0
  for (let next = layout.dataOffset; ;) {
    const frame = decoded(decoder, held, at)
    if (frame !== null) {
      at = frame.end
      yield frame
      continue
    }
    const more = await read(next, SLICE_BYTES)
    if (more.length === 0) throw damaged('it does not decode')
    next += more.length
    const kept = held.subarray(at, held.length - SPARE_BYTES)
    if (kept.length > MOST_FRAME_BYTES) throw new LeftToServer()
    held = new Uint8Array(kept.length + more.length + SPARE_BYTES)
    held.set(kept)
    held.set(more, kept.length)
    at = 0
  }
}

/** The next frame; null where more bytes are needed. */
function decoded(decoder: FrameDecoder, held: Uint8Array, at: number): Frame | null {
  try {
    return decoder.decode(held, at)
  } catch (refusal) {
    if (refusal instanceof OutOfBits) return null
    throw refusal instanceof Damaged ? damaged('it does not decode') : refusal
  }
}

/** The first samples of all channels, one frame after the other, with their sign and the lowest byte first. */
function pcmOf(channels: readonly Float64Array[], size: number, depth: number): Uint8Array<ArrayBuffer> {
  const sampleBytes = depth / 8
  const frameBytes = channels.length * sampleBytes
  const bytes = new Uint8Array(size * frameBytes)
  const spare = 32 - depth
  channels.forEach((samples, channel) => {
    for (let index = 0, at = channel * sampleBytes; index < size; index++, at += frameBytes) {
      const sample = samples[index]!
      // Only a file that was made so on purpose has samples beyond its depth.
      if ((sample << spare) >> spare !== sample) throw new LeftToServer()
      bytes[at] = sample
      if (sampleBytes > 1) bytes[at + 1] = sample >> 8
      if (sampleBytes > 2) bytes[at + 2] = sample >> 16
    }
  })
  return bytes
}
