export type FileKind = 'wav' | 'rf64' | 'zip' | 'mp3' | 'flac' | 'aiff' | 'ogg' | 'mp4' | 'lfs-pointer' | 'unknown'

const NAMES: Record<FileKind, string> = {
  wav: 'a WAV',
  rf64: 'an RF64',
  zip: 'a ZIP',
  mp3: 'an MP3',
  flac: 'a FLAC',
  aiff: 'an AIFF',
  ogg: 'an Ogg',
  mp4: 'an MP4',
  'lfs-pointer': 'a Git LFS pointer',
  unknown: 'an unknown format',
}

/** How many bytes of the beginning are enough to identify a format. */
export const SNIFF_BYTES = 64

/** Say what a file is by its first bytes, whatever its name says. */
export function kindOf(first: Uint8Array): FileKind {
  const text = (from: number, to: number) => String.fromCharCode(...first.subarray(from, to))
  if (text(0, 4) === 'RIFF' && text(8, 12) === 'WAVE') return 'wav'
  if (text(0, 4) === 'RF64' && text(8, 12) === 'WAVE') return 'rf64'
  if (text(0, 4) === 'PK\x03\x04' || text(0, 4) === 'PK\x05\x06') return 'zip'
  if (text(0, 4) === 'fLaC') return 'flac'
  if (text(0, 4) === 'FORM' && /^AIF[FC]$/.test(text(8, 12))) return 'aiff'
  if (text(0, 4) === 'OggS') return 'ogg'
  if (text(4, 8) === 'ftyp') return 'mp4'
  if (text(0, 3) === 'ID3') return 'mp3'
  if (text(0, 27) === 'version https://git-lfs.git') return 'lfs-pointer'
  const [sync = 0, layer = 0] = first
  if (sync === 0xff && (layer & 0xe0) === 0xe0 && (layer & 0x06) !== 0) return 'mp3'
  return 'unknown'
}

/** What a project's delivery spec takes; null where it takes any. */
export interface Accepts {
  kinds: readonly FileKind[]
  sampleRatesHz: readonly number[] | null
  bitDepths: readonly number[] | null
  /** Whatever the file is: the server says what happens to it. */
  isAnyFile?: true
}

export const ANY_FILE: Accepts = { kinds: [], sampleRatesHz: null, bitDepths: null, isAnyFile: true }
export const ANY_WAV: Accepts = { kinds: ['wav', 'rf64'], sampleRatesHz: null, bitDepths: null }

const either = (items: readonly string[]) =>
  items.length < 2 ? (items[0] ?? '') : `${items.slice(0, -1).join(', ')} or ${items.at(-1)}`

/** "a WAV or FLAC, 44.1 or 48 kHz, 16 bit". */
function acceptedFormats({ kinds, sampleRatesHz, bitDepths }: Accepts): string {
  const containers = kinds.filter((kind) => kind !== 'rf64').map((kind) => kind.toUpperCase())
  const kilohertz = sampleRatesHz?.map((hz) => `${hz / 1000}`)
  return [
    `a ${either(containers)}`,
    ...(kilohertz ? [`${either(kilohertz)} kHz`] : []),
    ...(bitDepths ? [`${either(bitDepths.map(String))} bit`] : []),
  ].join(', ')
}

export type Judged = { send: 'sound' | 'archive' } | { refused: string }

const SOUND_ENDINGS = /\.(wav|wave|flac|aiff?|mp3|ogg|m4a|mp4)$/i

/**
 * Decide in the browser whether a file goes on its way at all.
 *
 * Only what is surely not wanted is stopped here; whatever could be a master is sent, and the worker judges it.
 */
export function judge(name: string, size: number, kind: FileKind, accepts: Accepts = ANY_WAV): Judged {
  const ending = /\.([^./]+)$/.exec(name)?.[1]?.toLowerCase() ?? ''
  if (size === 0) return { refused: 'The file is empty (0 bytes). Export it again. Nothing was uploaded.' }
  if (accepts.isAnyFile) return { send: 'sound' }
  if (kind === 'zip') {
    return ending === 'zip'
      ? { send: 'archive' }
      : { refused: `This is a ZIP named .${ending}. Rename it to .zip. Nothing was uploaded.` }
  }
  if (kind === 'lfs-pointer') {
    return { refused: 'This is a Git LFS pointer, not the sound. Run git lfs pull first. Nothing was uploaded.' }
  }
  if (accepts.kinds.includes(kind)) return { send: 'sound' }
  if (kind !== 'unknown') {
    const named = kind === ending || (kind === 'aiff' && ending === 'aif') ? '' : ` named .${ending}`
    return { refused: `This is ${NAMES[kind]}${named}. Export ${acceptedFormats(accepts)}. Nothing was uploaded.` }
  }
  if (SOUND_ENDINGS.test(name)) return { send: 'sound' }
  return { refused: 'Not an audio file or ZIP. Nothing was uploaded.' }
}
