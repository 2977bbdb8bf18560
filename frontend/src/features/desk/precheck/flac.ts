/** The header of a FLAC file (RFC 9639, 8.2); what is odd about one is left to the server, and so are its samples. */
import { type Layout, LeftToServer, type Read } from './wav'

const HEAD_BYTES = 26 // the mark, the head of the first block, and STREAMINFO up to its checksum
const STREAMINFO_BYTES = 34
const MOST_CHANNELS = 2 // of more channels, comments say which is which
const DEPTHS: readonly number[] = [16, 24]

export async function readFlacLayout(read: Read): Promise<Layout> {
  const bytes = await read(0, HEAD_BYTES)
  const head = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (bytes.length < HEAD_BYTES || head.getUint32(0) !== 0x664c6143) throw new LeftToServer()
  // The highest bit says that no other block follows.
  const isInfo = (head.getUint32(4) & 0x7fffffff) === STREAMINFO_BYTES
  const facts = head.getUint32(18)
  const sampleRateHz = facts >>> 12
  const channels = ((facts >>> 9) & 0x7) + 1
  const bitDepth = ((facts >>> 4) & 0x1f) + 1
  const frames = (facts & 0xf) * 2 ** 32 + head.getUint32(22)
  if (!isInfo || sampleRateHz === 0 || frames === 0) throw new LeftToServer()
  if (channels > MOST_CHANNELS || !DEPTHS.includes(bitDepth)) throw new LeftToServer()
  return {
    container: 'flac',
    encoding: 'pcm',
    sampleRateHz,
    bitDepth,
    containerBits: bitDepth,
    channels,
    channelMask: null,
    isAmbisonic: false,
    frames,
    dataOffset: 0,
  }
}
