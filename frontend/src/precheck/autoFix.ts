/** What the automatic fix does about a finding, in the server's words (audio_checks/fixing/offers.py). */
import type { Finding, Subject } from './findings'
import { fixed } from './numbers'

const MOST_FIXED_BITS = 24
/** Of sound in a WAV file, with room for a megabyte of chunks. */
const WAV_BYTES = 0xffffffff - 2 ** 20

const LEFT_FLAT = ', which leaves its cut-off tops flat'

/** Whether a fix leaves nothing of a finding to do by hand. */
export const isAllFixed = ({ auto_fix }: Finding): boolean => auto_fix != null && !auto_fix.endsWith(LEFT_FLAT)

/** Sizes in the header that can be written right. */
const SIZES: ReadonlySet<string> = new Set(
  ['riff-size', 'stream-header', 'no-frames', 'trailing-bytes', 'no-chunk', 'byte-rate', 'pad-byte', 'padding'].map(
    (rule) => `structure:${rule}`,
  ),
)

/** What it does about a header that cannot be read; null where no fix helps. */
export const headerFix = (code: string): string | null => (SIZES.has(code) ? 'rewrites the sizes in the header' : null)

/** What it does about a finding; null where no fix helps. */
export function autoFix({ code, measured, limit }: Finding, { layout, peaks, spec }: Subject): string | null {
  if (layout.container === 'flac') return null
  switch (code) {
    case 'sample-peak:over':
      if (measured === null || limit === null) return null
      return `lowers the level by ${fixed(measured - limit, 2)} dB${peaks.isCutOff ? LEFT_FLAT : ''}`
    case 'bit-depth:not-accepted':
      return depthFix(layout, spec.accept)
    case 'encoding:not-accepted':
      return layout.encoding === 'float' ? depthFix(layout, spec.accept) : null
    case 'container:not-accepted':
      return containerFix(layout, spec.accept)
    default:
      return null
  }
}

const ORDER = ['container', 'structure', 'sample-peak', 'encoding', 'bit-depth', 'naming']

/** What one fix does about all findings, as in "writes it as WAV and lowers the level by 1.70 dB". */
export function fixInWords(findings: readonly Finding[]): string {
  const rank = ({ code }: Finding) => ORDER.findIndex((check) => code.startsWith(`${check}:`))
  const ordered = findings.toSorted((a, b) => rank(a) - rank(b))
  const words = [...new Set(ordered.flatMap(({ auto_fix }) => auto_fix ?? []))]
  const last = words.pop() ?? ''
  return words.length > 0 ? `${words.join(', ')} and ${last}` : last
}

type Accept = Subject['spec']['accept']

function depthFix({ bitDepth, encoding }: Subject['layout'], { bit_depths, encodings }: Accept): string | null {
  if (encodings !== null && !encodings.includes('pcm')) return null
  const isFloat = encoding === 'float'
  const most = isFloat ? MOST_FIXED_BITS : bitDepth
  const depths = bit_depths?.filter((depth) => depth <= most && (isFloat || depth < bitDepth)) ?? [
    Math.min(most, MOST_FIXED_BITS),
  ]
  if (depths.length === 0) return null
  const depth = Math.max(...depths)
  return `brings it to ${depth} bit${depth <= 16 ? ' with dither' : ''}`
}

function containerFix({ container, frames, channels, bitDepth }: Subject['layout'], { containers }: Accept) {
  if (container !== 'rf64' || !containers?.includes('wav')) return null
  return frames * channels * Math.ceil(bitDepth / 8) > WAV_BYTES ? null : 'writes it as WAV'
}
