import { channels, figure, length, rate } from '@/ui/format'

import type { Invitation, PreviewCue, Spec } from './api'

export interface Fact {
  term: string
  text: string
}

const listed = (items: readonly string[]): string =>
  items.length < 2 ? (items[0] ?? '') : `${items.slice(0, -1).join(', ')} or ${items.at(-1)}`

const CONTAINERS: Record<string, string> = { wav: 'WAV', rf64: 'RF64', flac: 'FLAC' }

function lengthsOf({ min, max }: Spec['accept']['duration_s']): string | null {
  if (min !== null && max !== null) return `${length(min)} to ${length(max)}`
  if (min !== null) return `${length(min)} or longer`
  return max === null ? null : `${length(max)} or shorter`
}

function loudnessOf({ min, max }: Spec['limits']['loudness_lufs']): string | null {
  if (min !== null && max !== null) return `${figure(min, 1)} to ${figure(max, 1)} LUFS`
  if (min !== null) return `${figure(min, 1)} LUFS or louder`
  return max === null ? null : `${figure(max, 1)} LUFS or quieter`
}

/** How sounds must come, in lines; what the spec leaves open is left out. */
export function factsOf({ accept, limits, naming, required_metadata, engine, categories }: Spec): Fact[] {
  const level = (value: number | null, unit: string) => (value === null ? null : `at most ${figure(value, 1)} ${unit}`)
  const facts: [string, string | null][] = [
    [
      'Container',
      accept.containers &&
        listed(accept.containers.map((container) => CONTAINERS[container] ?? container.toUpperCase())),
    ],
    ['Sample rate', accept.sample_rates_hz && listed(accept.sample_rates_hz.map(rate))],
    ['Bit depth', accept.bit_depths && `${listed(accept.bit_depths.map(String))} bit`],
    ['Channels', accept.channels && listed(accept.channels.map(channels))],
    ['Length', lengthsOf(accept.duration_s)],
    ['Sample peak', level(limits.sample_peak_dbfs, 'dBFS')],
    ['True peak', level(limits.true_peak_dbtp, 'dBTP')],
    ['Loudness', loudnessOf(limits.loudness_lufs)],
    ['Leading silence', limits.head_silence_ms === null ? null : `at most ${figure(limits.head_silence_ms)} ms`],
    ['Trailing silence', limits.tail_silence_ms === null ? null : `at most ${figure(limits.tail_silence_ms)} ms`],
    ['Metadata', required_metadata.length > 0 ? `${required_metadata.join(', ')} filled` : null],
    ['File names', naming.extension && `as in the list, ending in ${naming.extension}`],
    ['Applied in engine', engine.adds.length > 0 ? `${engine.adds.join(', ')}; deliver dry` : null],
    ['Special rules for', categories.length > 0 ? categories.join(', ') : null],
  ]
  return facts.flatMap(([term, text]) => (text ? [{ term, text }] : []))
}

export const KIND_WORDS: Record<Invitation['kind'], string> = {
  advisory: 'to advise before any work is ordered',
  contract: 'to make its sounds as a contractor',
  'in-house': 'to make its sounds in-house',
}

/** "set of 4, loop, mono", or nothing for a single one-shot in the channels of the spec. */
export const shapeOf = ({ variations, loop, channels }: PreviewCue): string =>
  [variations > 1 ? `set of ${variations}` : '', loop ? 'loop' : '', channels ?? ''].filter(Boolean).join(', ')

/** How many sounds and files a list asks for. */
export function sumOf(cues: readonly PreviewCue[]): { cues: number; files: number; settled: number } {
  const open = cues.filter(({ state }) => state !== 'cut')
  return {
    cues: open.length,
    files: open.reduce((sum, { variations }) => sum + variations, 0),
    settled: open.filter(({ state }) => state !== 'concept').length,
  }
}
