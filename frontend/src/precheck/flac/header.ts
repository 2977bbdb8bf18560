/** The header of a FLAC file (RFC 9639, 8), read as the server reads it; what is odd about one is left to the server. */
import { type Layout, LeftToServer, type Read, Unreadable } from '../wav'

export interface FlacLayout extends Layout {
  /** Of the samples; zeros where the encoder left it out. */
  md5: Uint8Array
}

const UPLOAD_AGAIN = 'export or copy it again; the file was cut short on its way'
const EXPORT_AGAIN = 'export it again from your audio editor as FLAC or WAV'
const STREAMINFO = 0
const VORBIS_COMMENT = 4
const STREAMINFO_BYTES = 34
const MOST_BLOCKS = 1_024
const MOST_COMMENTS = 1_024
const MOST_COMMENT_BYTES = 2 ** 20
const MOST_UNPACKED_BYTES = 2 ** 31
const DEPTHS: readonly number[] = [8, 16, 24]
const MASK_COMMENT = 'WAVEFORMATEXTENSIBLE_CHANNEL_MASK'
/** What a number of channels means, unless a comment says otherwise; fewer need none. */
const MASKS: Record<number, number> = { 3: 0x7, 4: 0x33, 5: 0x607, 6: 0x60f, 8: 0x63f }

const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
const wrong = (message: string) =>
  new Unreadable(`the FLAC header is wrong: ${message}`, 'R4', 'structure:flac-header', EXPORT_AGAIN)
const truncated = (message: string) => new Unreadable(message, 'R1', 'structure:truncated', UPLOAD_AGAIN)

/** Read the blocks before the sound; throw Unreadable where the server would refuse them. */
export async function readFlacLayout(read: Read, fileSize: number): Promise<FlacLayout> {
  let info = new Uint8Array(0)
  let comments: ReadonlyMap<string, string> = new Map()
  let at = 4
  for (let count = 0, isLast = false; !isLast; count++) {
    const head = await read(at, 4)
    const [first = 0] = head
    const size = head.length < 4 ? 0 : viewOf(head).getUint32(0) % 2 ** 24
    at += 4
    if (head.length < 4 || at + size > fileSize) {
      throw truncated('a metadata block of the FLAC file reaches beyond its end')
    }
    const kind = first & 0x7f
    isLast = first >= 0x80
    if ((kind === STREAMINFO) !== (count === 0) || kind === 127 || count === MOST_BLOCKS) {
      throw wrong('its metadata blocks are not in valid order: STREAMINFO comes first, and once')
    }
    if (kind === STREAMINFO) info = await read(at, Math.min(size, 64))
    if (kind === VORBIS_COMMENT) {
      const some = commentsOf(await read(at, Math.min(size, MOST_COMMENT_BYTES)))
      if (comments.size === 0) comments = some
    }
    at += size
  }
  if (at >= fileSize) throw truncated('the file ends before its sound begins')
  return layoutOf(info, comments, at)
}

function layoutOf(info: Uint8Array, comments: ReadonlyMap<string, string>, dataOffset: number): FlacLayout {
  if (info.length !== STREAMINFO_BYTES) throw wrong(`its STREAMINFO has ${info.length} bytes; 34 are wanted`)
  const facts = viewOf(info).getUint32(10)
  const sampleRateHz = facts >>> 12
  const channels = ((facts >>> 9) & 0x7) + 1
  const bitDepth = ((facts >>> 4) & 0x1f) + 1
  const frames = (facts & 0xf) * 2 ** 32 + viewOf(info).getUint32(14)
  if (sampleRateHz < 1_000 || sampleRateHz > 768_000) {
    throw wrong(`it says a sample rate of ${sampleRateHz} Hz; 1,000 to 768,000 Hz is wanted`)
  }
  if (!DEPTHS.includes(bitDepth)) throw wrong(`it has ${bitDepth} bits; ${DEPTHS.join(', ')} are wanted`)
  if (frames === 0) {
    const message = 'the header leaves open how long the sound is, as a program does that writes to a pipe'
    throw new Unreadable(message, 'R11', 'structure:stream-header', EXPORT_AGAIN)
  }
  const unpacked = (frames * channels * bitDepth) / 8
  if (unpacked > MOST_UNPACKED_BYTES) {
    const most = MOST_UNPACKED_BYTES / 2 ** 20
    throw wrong(`it announces ${Math.floor(unpacked / 2 ** 20)} MiB of samples; at most ${most} MiB are read`)
  }
  return {
    container: 'flac',
    encoding: 'pcm',
    sampleRateHz,
    bitDepth,
    containerBits: bitDepth,
    channels,
    channelMask: maskOf(channels, comments),
    isAmbisonic: false,
    frames,
    dataOffset,
    md5: info.subarray(18),
  }
}

function maskOf(channels: number, comments: ReadonlyMap<string, string>): number | null {
  if (channels <= 2) return null
  const comment = comments.get(MASK_COMMENT)
  if (comment === undefined) return MASKS[channels] ?? null
  if (!/^(0x)?[0-9a-f]{1,8}$/i.test(comment)) throw new LeftToServer()
  const mask = parseInt(comment, 16)
  const speakers = mask.toString(2).replaceAll('0', '').length
  return speakers === channels ? mask : (MASKS[channels] ?? null)
}

/** The comments by their names in capitals; of one name the first (Ogg Vorbis I, 5). */
function commentsOf(block: Uint8Array): ReadonlyMap<string, string> {
  const comments = new Map<string, string>()
  const view = viewOf(block)
  let at = 0
  const number = (): number => {
    if (at + 4 > block.length) throw new LeftToServer()
    at += 4
    return view.getUint32(at - 4, true)
  }
  const encoderBytes = number()
  at += encoderBytes
  for (let left = Math.min(number(), MOST_COMMENTS); left > 0; left--) {
    const size = number()
    if (at + size > block.length) throw new LeftToServer()
    const entry = new TextDecoder('utf-8', { ignoreBOM: true }).decode(block.subarray(at, at + size))
    const [, name = '', text = ''] = /^([ -<>-~]*)=(.*)$/s.exec(entry) ?? []
    if (text !== '' && !comments.has(name.toUpperCase())) comments.set(name.toUpperCase(), text)
    at += size
  }
  return comments
}
