import type { Picked } from '@/uploads'

import type { ShippedFile } from './api'

const SOUND_ENDINGS = /\.(wave?|bwf|flac|aif[fc]?|caf|w64|og[ga]|opus|mp3|m4a|wma)$/i
const HEAD_BYTES = 64 * 1024
export const MOST_FILES = 10_000

export interface Folder {
  name: string
  files: ShippedFile[]
  /** The file of each path. */
  sources: ReadonlyMap<string, File>
}

/** The sounds among dropped files. */
export const soundsOf = (picked: readonly Picked[]): Picked[] =>
  picked.filter(({ file, path }) => SOUND_ENDINGS.test(path) && file.size > 0)

/** Browsers hash on secure pages only. */
export const canHash = () => (globalThis.crypto as Partial<Crypto> | undefined)?.subtle !== undefined

/** Read what the server plans by: each file's SHA-256, and the rate and depth that its header says. */
export async function readFolder(picked: readonly Picked[], onRead: (count: number) => void): Promise<Folder> {
  const name = commonFolder(picked.map(({ path }) => path))
  const files: ShippedFile[] = []
  const sources = new Map<string, File>()
  for (const { file, path: whole } of picked) {
    const path = name === '' ? whole : whole.slice(name.length + 1)
    const content = await file.arrayBuffer()
    const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', content))
    const sha256 = [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('')
    files.push({ path, sha256, size_bytes: file.size, ...formatOf(new DataView(content.slice(0, HEAD_BYTES))) })
    sources.set(path, file)
    onRead(files.length)
  }
  return { name: name === '' ? 'Sounds' : name, files, sources }
}

/** The outermost folder, where every path is in the same one. */
function commonFolder(paths: readonly string[]): string {
  const [first = ''] = paths
  const folder = first.includes('/') ? first.slice(0, first.indexOf('/')) : ''
  return folder !== '' && paths.every((path) => path.startsWith(`${folder}/`)) ? folder : ''
}

type Format = Pick<ShippedFile, 'sample_rate_hz' | 'bit_depth'>
const UNREAD: Format = { sample_rate_hz: null, bit_depth: null }

/** Rate and depth of a WAV or FLAC file by its first bytes, the rate of an Ogg file; the server's checks read the whole file. */
export function formatOf(head: DataView): Format {
  const text = (at: number) =>
    at + 4 <= head.byteLength ? String.fromCharCode(...[0, 1, 2, 3].map((place) => head.getUint8(at + place))) : ''
  if (text(0) === 'fLaC' && head.byteLength >= 26) {
    const word = head.getUint32(18) // 20 bits rate, 3 of channels, 5 of depth, and the first 4 of the length
    return plausible(word >>> 12, ((word >>> 4) & 31) + 1)
  }
  if (text(0) === 'OggS') return ofOgg(head)
  if (!['RIFF', 'RF64'].includes(text(0)) || text(8) !== 'WAVE') return UNREAD
  for (let at = 12; at + 24 <= head.byteLength;) {
    if (text(at) === 'fmt ') return plausible(head.getUint32(at + 12, true), head.getUint16(at + 22, true))
    const size = head.getUint32(at + 4, true)
    at += 8 + size + (size % 2)
  }
  return UNREAD
}

/** The first page of an Ogg file has the codec's header alone. */
function ofOgg(head: DataView): Format {
  const text = new TextDecoder('latin1').decode(
    new Uint8Array(head.buffer, head.byteOffset, Math.min(128, head.byteLength)),
  )
  const vorbis = text.indexOf('\u0001vorbis')
  if (vorbis >= 0 && vorbis + 16 <= text.length) return plausible(head.getUint32(vorbis + 12, true), 0)
  return text.includes('OpusHead') ? plausible(48_000, 0) : UNREAD
}

const plausible = (hz: number, depth: number): Format => ({
  sample_rate_hz: hz >= 1 && hz <= 10_000_000 ? hz : null,
  bit_depth: depth >= 1 && depth <= 64 ? depth : null,
})
