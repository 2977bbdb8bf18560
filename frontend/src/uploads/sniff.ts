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
  unknown: 'no sound that is known here',
}

/** How many bytes of the beginning are enough to tell. */
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

export type Judged = { send: 'sound' | 'archive' } | { refused: string }

const SOUND_ENDINGS = /\.(wav|wave|flac|aiff?|mp3|ogg|m4a|mp4)$/i

/**
 * Decide in the browser whether a file goes on its way at all.
 *
 * Only what is surely not wanted is stopped here; whatever could be a master is sent, and the worker judges it.
 */
export function judge(
  name: string,
  size: number,
  kind: FileKind,
  accepts: readonly FileKind[] = ['wav', 'rf64'],
): Judged {
  const ending = /\.([^./]+)$/.exec(name)?.[1]?.toLowerCase() ?? ''
  if (size === 0) return { refused: 'It is empty, 0 bytes. Export it again. Nothing was sent.' }
  if (kind === 'zip') {
    return ending === 'zip'
      ? { send: 'archive' }
      : { refused: `This is a ZIP named .${ending}. Name it .zip. Nothing was sent.` }
  }
  if (kind === 'lfs-pointer') {
    return { refused: 'This is a Git LFS pointer, not the sound. Run git lfs pull first. Nothing was sent.' }
  }
  if (accepts.includes(kind)) return { send: 'sound' }
  if (kind !== 'unknown') {
    const named = kind === ending || (kind === 'aiff' && ending === 'aif') ? '' : ` named .${ending}`
    return { refused: `This is ${NAMES[kind]}${named}. Export a WAV, 48 or 96 kHz, 24 bit. Nothing was sent.` }
  }
  if (SOUND_ENDINGS.test(name)) return { send: 'sound' }
  return { refused: 'This is no sound and no ZIP. Nothing was sent.' }
}
