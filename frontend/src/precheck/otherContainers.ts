/** What a file may be in place of a WAV, by its first bytes, in the server's words (audio_checks/wav/other_containers.py). */

interface OtherContainer {
  code: string
  name: string
}

/** The offset of the bytes that say so, the bytes as Latin-1, the code and the name. */
const OTHER_CONTAINERS: readonly (readonly [number, string, string, string])[] = [
  [0, 'version https://git-lfs', 'git-lfs-pointer', 'a Git LFS pointer, a text in place of the real file'],
  [0, 'RIFX', 'rifx', 'RIFX (big-endian RIFF)'],
  [0, 'BW64', 'bw64', 'BW64'],
  [0, 'riff\x2e\x91\xcf\x11', 'w64', 'Sony Wave64 (W64)'],
  [0, 'fLaC', 'flac', 'FLAC'],
  [0, 'OggS', 'ogg', 'Ogg (Vorbis, Opus or FLAC)'],
  [0, 'FORM', 'aiff', 'AIFF'],
  [0, '.snd', 'au', 'AU'],
  [0, 'caff', 'caf', 'Core Audio (CAF)'],
  [0, 'ID3', 'mp3', 'MP3 (it starts with an ID3 tag)'],
  [4, 'ftyp', 'mp4', 'MP4 or M4A'],
  [0, '\x1aE\xdf\xa3', 'matroska', 'Matroska or WebM'],
  [0, '0&\xb2u\x8ef\xcf\x11', 'asf', 'Windows Media (ASF)'],
  [0, 'wvpk', 'wavpack', 'WavPack'],
  [0, 'MAC ', 'ape', "Monkey's Audio"],
  [0, 'MThd', 'midi', 'MIDI'],
  [0, 'DSD ', 'dsf', 'DSD'],
  [0, 'PK\x03\x04', 'zip', 'a ZIP archive'],
  [0, '\x1f\x8b', 'gzip', 'a gzip archive'],
  [0, '%PDF', 'pdf', 'a PDF'],
  [0, '<!DOCTYPE', 'html', 'a web page'],
  [0, '<html', 'html', 'a web page'],
]

/** What the first bytes of a file say that it is; null where they say nothing. */
export function otherContainer(start: Uint8Array): OtherContainer | null {
  const text = String.fromCharCode(...start)
  for (const [offset, mark, code, name] of OTHER_CONTAINERS) if (text.startsWith(mark, offset)) return { code, name }
  const [sync = 0, layer = 0] = start
  const isMp3 = sync === 0xff && (layer & 0xe0) === 0xe0 && (layer & 0x06) !== 0
  return isMp3 ? { code: 'mp3', name: 'MP3' } : null
}
