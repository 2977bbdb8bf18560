/** The header of a WAV or RF64 file, read as the server reads it; what is odd about one is left to the server. */

import { otherContainer } from './otherContainers'

export interface Layout {
  container: 'wav' | 'rf64' | 'flac'
  encoding: 'pcm' | 'float'
  sampleRateHz: number
  bitDepth: number
  containerBits: number
  channels: number
  channelMask: number | null
  isAmbisonic: boolean
  frames: number
  dataOffset: number
}

/** Why the server could not read the file. */
export class Unreadable extends Error {
  readonly rule: string
  readonly code: string
  readonly fix: string

  constructor(message: string, rule: string, code: string, fix: string) {
    super(message)
    this.rule = rule
    this.code = code
    this.fix = fix
  }
}

/** The server alone says what becomes of such a file. */
export class LeftToServer extends Error {}

export type Read = (offset: number, count: number) => Promise<Uint8Array<ArrayBuffer>>

const UPLOAD_AGAIN = 'export or copy it again; the file was cut short on its way'
const EXPORT_AGAIN = 'export it again from your audio editor as WAV'
const EXPORT_WAV = 'export it from your audio editor as WAV (PCM); renaming a file does not convert it'
const FETCH_FROM_LFS = 'fetch the real file with `git lfs pull`'
const PCM = 1
const FLOAT = 3
const EXTENSIBLE = 0xfffe
const OPEN_SIZE = 0xffffffff
const MOST_CHUNKS = 10_000
const MOST_CHANNELS = 1_024
const MOST_EXACT = 2 ** 53
const GUID_TAIL = '00001000800000aa00389b71'
const AMBISONIC_TAIL = '2107d3118644c8c1ca000000'

const CODECS: Record<number, string> = {
  0x0002: 'Microsoft ADPCM',
  0x0006: 'A-law',
  0x0007: 'µ-law',
  0x0011: 'IMA ADPCM',
  0x0031: 'GSM 6.10',
  0x0050: 'MPEG audio',
  0x0055: 'MP3',
  0x0069: 'Xbox ADPCM',
  0x0092: 'Dolby AC-3',
  0x00ff: 'AAC',
  0x0161: 'Windows Media Audio',
  0x0162: 'Windows Media Audio Professional',
  0x0163: 'Windows Media Audio Lossless',
  0x0270: 'ATRAC3',
  0x566f: 'Vorbis',
  0x676f: 'Vorbis',
  0xf1ac: 'FLAC',
}

const text = (bytes: Uint8Array) => String.fromCharCode(...bytes)
const shown = (bytes: Uint8Array) => text(bytes.map((byte) => (byte >= 0x20 && byte < 0x7f ? byte : 0x3f)))
const isLawful = (bytes: Uint8Array) => bytes.every((byte) => byte >= 0x20 && byte < 0x7f)
const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
const hex = (value: number, digits = 0) => `0x${value.toString(16).padStart(digits, '0')}`

interface Chunk {
  id: string
  offset: number
  size: number
}

interface Sizes64 {
  riff: number
  data: number
  frames: number
}

function container(start: Uint8Array, size: number): 'wav' | 'rf64' {
  const magic = text(start.subarray(0, 4))
  if (magic !== 'RIFF' && magic !== 'RF64') {
    const otherFormat = otherContainer(start)
    if (otherFormat !== null) {
      const message = `the file is ${otherFormat.name}, not WAV, whatever its name ends in`
      const fix = otherFormat.code === 'git-lfs-pointer' ? FETCH_FROM_LFS : EXPORT_WAV
      throw new Unreadable(message, 'R11', `container:${otherFormat.code}`, fix)
    }
    if (start.every((byte) => byte === 0)) {
      throw new Unreadable(
        'the file starts with zeros where a WAV file starts with RIFF',
        'R11',
        'container:zeros',
        UPLOAD_AGAIN,
      )
    }
    const message = `the file starts with "${shown(start.subarray(0, 4))}"; a WAV file starts with RIFF or RF64`
    throw new Unreadable(message, 'R11', 'container:unknown', EXPORT_WAV)
  }
  if (start.length < 12) {
    const message = `the file ends after ${size} bytes, in the middle of its header`
    throw new Unreadable(message, 'R1', 'structure:truncated', UPLOAD_AGAIN)
  }
  if (text(start.subarray(8, 12)) !== 'WAVE') {
    const message = `the file is RIFF, but of the kind "${shown(start.subarray(8, 12))}"; "WAVE" is wanted`
    throw new Unreadable(message, 'R11', 'container:not-wave', EXPORT_WAV)
  }
  return magic === 'RIFF' ? 'wav' : 'rf64'
}

async function sizes64(start: Uint8Array, read: Read): Promise<Sizes64> {
  const content = await read(20, 28)
  if (text(start.subarray(12, 16)) !== 'ds64' || content.length < 28) throw new LeftToServer()
  const view = viewOf(content)
  const [riff = 0, data = 0, frames = 0] = [0, 8, 16].map((at) => Number(view.getBigUint64(at, true)))
  if (Math.max(riff, data, frames) >= MOST_EXACT) throw new LeftToServer()
  if (viewOf(start).getUint32(16, true) !== 28 || view.getUint32(24, true) !== 0) throw new LeftToServer()
  return { riff, data, frames }
}

function overrun(id: Uint8Array, size: number, missing: number): Unreadable {
  const message =
    text(id) === 'data'
      ? `the data chunk says that it has ${size} bytes of sound, but ${missing} of them are missing`
      : `the chunk "${shown(id)}" says that it has ${size} bytes, which is ${missing} more than the file has left`
  return new Unreadable(message, 'R1', 'structure:truncated', UPLOAD_AGAIN)
}

async function chunksTo(end: number, data64: number | null, read: Read): Promise<Chunk[]> {
  const chunks: Chunk[] = []
  let at = 12
  while (at < end) {
    const head = await read(at, 8)
    if (head.length < 8 || at + 8 > end || !isLawful(head.subarray(0, 4)) || chunks.length === MOST_CHUNKS) {
      throw new LeftToServer()
    }
    const id = text(head.subarray(0, 4))
    let size = viewOf(head).getUint32(4, true)
    if (size === OPEN_SIZE && id === 'data') {
      if (data64 === null) throw openSizes()
      size = data64
    }
    const missing = at + 8 + size - end
    if (missing > 0) {
      // After a chunk of odd length the pad byte may be what is missing.
      if ((chunks.at(-1)?.size ?? 0) % 2 === 1) throw new LeftToServer()
      throw overrun(head.subarray(0, 4), size, missing)
    }
    chunks.push({ id, offset: at + 8, size })
    at += 8 + size + (size % 2)
  }
  return chunks
}

const openSizes = () =>
  new Unreadable(
    'the header leaves its sizes open, as a program does that writes to a pipe; the true sizes are wanted',
    'R11',
    'structure:stream-header',
    EXPORT_AGAIN,
  )

/** The one chunk of a name. */
function only(chunks: readonly Chunk[], name: string, role: string): Chunk {
  const matches = chunks.filter(({ id }) => id === name)
  const [first] = matches
  if (first !== undefined && matches.length === 1) return first
  const count = matches.length === 0 ? 'no' : String(matches.length)
  const message = `the file has ${count} "${name}" chunk${matches.length > 1 ? 's' : ''}, which ${role}; exactly one is wanted`
  const code = `structure:${matches.length === 0 ? 'no' : 'several'}-${name.trim()}`
  throw new Unreadable(message, 'R3', code, EXPORT_AGAIN)
}

type Format = Omit<Layout, 'container' | 'frames' | 'dataOffset'>

const inconsistent = (message: string, code: string) => new Unreadable(message, 'R4', `structure:${code}`, EXPORT_AGAIN)

function formatOf(content: Uint8Array, size: number): Format {
  if (size < 16) throw inconsistent(`the "fmt " chunk has ${size} bytes; 16 or more are wanted`, 'fmt-size')
  const view = viewOf(content)
  const word = (at: number) => view.getUint16(at, true)
  const channels = word(2)
  const sampleRateHz = view.getUint32(4, true)
  const isExtensible = word(0) === EXTENSIBLE
  let tag = word(0)
  let containerBits = word(14)
  let bitDepth = containerBits
  let channelMask: number | null = null
  let isAmbisonic = false
  if (isExtensible) {
    if (content.length < 40 || word(16) < 22) {
      const message = `the "fmt " chunk of an extensible header has ${size} bytes; 40 are wanted`
      throw inconsistent(message, 'fmt-size')
    }
    bitDepth = word(18)
    channelMask = view.getUint32(20, true)
    const tail = [...content.subarray(28, 40)].map((byte) => byte.toString(16).padStart(2, '0')).join('')
    if (tail !== GUID_TAIL && tail !== AMBISONIC_TAIL) throw new LeftToServer()
    isAmbisonic = tail === AMBISONIC_TAIL
    tag = view.getUint32(24, true)
  }
  if (tag !== PCM && tag !== FLOAT) {
    const name = CODECS[tag] ?? `of an unknown kind (tag ${hex(tag, 4)})`
    const message = `the sound in this WAV file is ${name}; PCM or IEEE float is wanted`
    throw new Unreadable(message, 'R5', 'encoding:codec', EXPORT_WAV)
  }
  if (channels < 1 || channels > MOST_CHANNELS) {
    throw inconsistent(`the header says ${channels} channels; 1 to ${MOST_CHANNELS} are wanted`, 'channels')
  }
  if (sampleRateHz < 1_000 || sampleRateHz > 768_000) {
    const message = `the header says a sample rate of ${sampleRateHz} Hz; 1,000 to 768,000 Hz is wanted`
    throw inconsistent(message, 'sample-rate')
  }
  if (isExtensible && (containerBits % 8 !== 0 || bitDepth < 1 || bitDepth > containerBits)) {
    throw inconsistent(`the header says ${bitDepth} valid bits in a sample of ${containerBits} bits`, 'bit-depth')
  }
  containerBits = Math.ceil(containerBits / 8) * 8
  const lawful = tag === PCM ? [8, 16, 24, 32] : [32, 64]
  if (!lawful.includes(containerBits) || (tag === FLOAT && bitDepth !== containerBits)) {
    const [kind, allowed] = tag === PCM ? ['PCM', '8, 16, 24 or 32'] : ['float', '32 or 64']
    throw inconsistent(`the header says ${kind} of ${bitDepth} bits; ${allowed} bits are wanted`, 'bit-depth')
  }
  const frameBytes = (channels * containerBits) / 8
  if (word(12) !== frameBytes) {
    const expected = `${channels} × ${containerBits} bits make ${frameBytes}`
    throw inconsistent(`the header says ${word(12)} bytes a frame, but ${expected}`, 'block-align')
  }
  const byteRate = view.getUint32(8, true)
  if (byteRate !== (sampleRateHz * frameBytes) % 2 ** 32) {
    const expected = `${sampleRateHz} frames of ${frameBytes} bytes make ${sampleRateHz * frameBytes}`
    throw inconsistent(`the header says ${byteRate} bytes a second, but ${expected}`, 'byte-rate')
  }
  const encoding = tag === PCM ? 'pcm' : 'float'
  return { encoding, sampleRateHz, bitDepth, containerBits, channels, channelMask, isAmbisonic }
}

/** Read the header of a file; throw Unreadable where the server would refuse it, LeftToServer where only it can say. */
export async function readLayout(read: Read, fileSize: number): Promise<Layout> {
  const start = await read(0, 40)
  const kind = container(start, fileSize)
  const large = kind === 'rf64' ? await sizes64(start, read) : null
  let riffSize = viewOf(start).getUint32(4, true)
  if (riffSize === OPEN_SIZE) {
    if (large === null) throw openSizes()
    riffSize = large.riff
  }
  const end = riffSize + 8
  if (end < 12) {
    const message = 'the RIFF size was left at zero, as a recorder does that could not finish'
    throw new Unreadable(message, 'R2', 'structure:riff-size', EXPORT_AGAIN)
  }
  const isWhole = end === fileSize
  if (end < fileSize || end - fileSize === 8 || end - fileSize === 1) throw new LeftToServer()
  const chunks = await chunksTo(fileSize, large?.data ?? null, read)
  if (!isWhole) {
    const message = `the RIFF header says that the file has ${end} bytes, but it has ${fileSize}`
    throw new Unreadable(message, 'R2', 'structure:riff-size', UPLOAD_AGAIN)
  }
  const header = only(chunks, 'fmt ', 'describes the sample format')
  const data = only(chunks, 'data', 'holds the sound')
  if (header.offset > data.offset) {
    const message = 'the "fmt " chunk comes after the "data" chunk; it must come before'
    throw new Unreadable(message, 'R3', 'structure:fmt-after-data', EXPORT_AGAIN)
  }
  const format = formatOf(await read(header.offset, Math.min(header.size, 40)), header.size)
  const frameBytes = (format.channels * format.containerBits) / 8
  const rest = data.size % frameBytes
  if (rest > 0) {
    const message = `the data chunk holds ${data.size} bytes, which is not a whole number of frames of ${frameBytes} bytes`
    throw new Unreadable(`${message}: ${rest} are left over`, 'R1', 'structure:partial-frame', EXPORT_AGAIN)
  }
  const frames = data.size / frameBytes
  if (frames === 0) {
    const message = 'the file holds no sound: its data chunk is empty'
    throw new Unreadable(message, 'R6', 'structure:no-frames', EXPORT_AGAIN)
  }
  if (large !== null && large.frames !== 0 && large.frames !== frames) throw new LeftToServer()
  return { ...format, container: kind, frames, dataOffset: data.offset }
}
