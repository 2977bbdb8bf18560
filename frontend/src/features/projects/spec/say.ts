import { channels, figure, rate } from '@/ui/format'

import type { Spec } from '../api'
import { listed } from '../words'
import { FAULT_CHECKS, FORM_CHECKS, LIMITS, type Severity, severityOf } from './checks'
import { at, type Tables, tableIn } from './tables'

/** A number as exactly as it was said, with one decimal at least where the unit is a level. */
export function exact(value: number, least = 0): string {
  const decimals = (String(value).split('.')[1] ?? '').length
  return figure(value, Math.min(6, Math.max(least, decimals)))
}

const numbers = (value: unknown): number[] =>
  Array.isArray(value) ? value.filter((one): one is number => typeof one === 'number') : []
const words = (value: unknown): string[] =>
  Array.isArray(value) ? value.filter((one): one is string => typeof one === 'string') : []

/** "48 or 96 kHz": one unit for all. */
const ratesOf = (hz: readonly number[]): string =>
  `${listed(
    hz.map((one) => rate(one).replace(' kHz', '')),
    'or',
  )} kHz`

const depthsOf = (bits: readonly number[]): string => `${listed(bits.map(String), 'or')} bit`

/** "0.01–30 s", "up to 300 s", "0.5 s or more", "any length". */
export function lengthOf(range: { min?: number | null; max?: number | null }): string {
  const { min = null, max = null } = range
  if (min !== null && max !== null) return `${exact(min)}–${exact(max)} s`
  if (max !== null) return `up to ${exact(max)} s`
  return min === null ? 'any' : `${exact(min)} s or more`
}

const loudnessOf = ({ min = null, max = null }: { min?: number | null; max?: number | null }): string => {
  if (min !== null && max !== null) return `${exact(min, 1)} to ${exact(max, 1)} LUFS`
  return max === null ? `${exact(min ?? 0, 1)} LUFS or more` : `up to ${exact(max, 1)} LUFS`
}

export interface Line {
  word: string
  value: string
  severity?: Severity
}

const CONTAINERS: Record<string, string> = { wav: 'WAV', rf64: 'RF64', flac: 'FLAC' }
const ENCODINGS: Record<string, string> = { pcm: 'PCM', float: 'float' }

/** What a delivered file may be. */
export function acceptLines({ resolved: { accept } }: Spec): Line[] {
  const containers = accept.containers?.map((one) => CONTAINERS[one] ?? one) ?? ['any']
  const encodings = accept.encodings?.map((one) => ENCODINGS[one] ?? one) ?? []
  return [
    { word: 'Container', value: [listed(containers, 'or'), listed(encodings, 'or')].filter(Boolean).join(', ') },
    { word: 'Sample rate', value: accept.sample_rates_hz ? ratesOf(accept.sample_rates_hz) : 'any' },
    { word: 'Bit depth', value: accept.bit_depths ? depthsOf(accept.bit_depths) : 'any' },
    { word: 'Channels', value: accept.channels ? accept.channels.map(channels).join(', ') : 'any' },
    { word: 'Length', value: lengthOf(accept.duration_s) },
  ]
}

/** The levels and edges a file keeps to, with what happens when it does not. */
export function limitLines({ resolved: { limits, checks, engine } }: Spec): Line[] {
  const of = (name: string) => severityOf(checks, name)
  const lines: Line[] = []
  const add = (word: string, value: string, severity: Severity) => {
    if (severity !== 'off') lines.push({ word, value, severity })
  }
  if (limits.sample_peak_dbfs !== null) {
    add('Sample peak', `${exact(limits.sample_peak_dbfs, 1)} dBFS`, of('sample-peak'))
  }
  if (limits.true_peak_dbtp !== null) add('True peak', `${exact(limits.true_peak_dbtp, 1)} dBTP`, of('true-peak'))
  if (limits.loudness_lufs.min !== null || limits.loudness_lufs.max !== null) {
    add('Loudness', loudnessOf(limits.loudness_lufs), of('loudness'))
  }
  if (limits.dc_offset_percent !== null) add('DC offset', `${exact(limits.dc_offset_percent, 1)} %`, of('dc-offset'))
  const { head_silence_ms: head, tail_silence_ms: tail } = limits
  if (head !== null && tail !== null && of('head-silence') === of('tail-silence')) {
    add('Leading / trailing silence', `${exact(head)} / ${exact(tail)} ms`, of('head-silence'))
  } else {
    if (head !== null) add('Leading silence', `${exact(head)} ms`, of('head-silence'))
    if (tail !== null) add('Trailing silence', `${exact(tail)} ms`, of('tail-silence'))
  }
  if (limits.silence_below_dbfs !== null) {
    add('Counts as silence below', `${exact(limits.silence_below_dbfs, 1)} dBFS`, of('silence'))
  }
  if (limits.mono_loss_db !== null) {
    add('Mono fold-down loss', `${exact(limits.mono_loss_db, 1)} dB`, severityOf(checks, 'phase', 'warning'))
  }
  add('Clipping', 'none', severityOf(checks, 'clipping', 'warning'))
  if (engine.adds.length > 0) lines.push({ word: 'Applied in engine', value: engine.adds.join(', ') })
  return lines
}

const DITHERS: Record<string, string> = { tpdf: 'TPDF', shaped: 'shaped', none: 'none' }
const OVER_PEAK: Record<string, string> = { attenuate: 'attenuate', refuse: 'refuse' }

export interface TargetFacts {
  sample_rate_hz: number
  bit_depth: number
  encoding: string
  channels: string | number
}

/** "48 kHz, 16 bit, as master". */
export function targetInWords({ sample_rate_hz, bit_depth, encoding, channels: count }: TargetFacts): string {
  const made = typeof count === 'number' ? channels(count) : 'same as master'
  return [rate(sample_rate_hz), `${bit_depth} bit${encoding === 'float' ? ' float' : ''}`, made].join(', ')
}

/** What is made from each master, and what holds for all of it. */
export function targetLines({ resolved: { targets } }: Spec): Line[] {
  const all = Object.values(targets)
  const each = all.map((target) => ({ word: target.name, value: targetInWords(target) }))
  const together = (word: string, values: string[]): Line[] =>
    values.length === 0 ? [] : [{ word, value: [...new Set(values)].join(', ') }]
  return [
    ...each,
    ...together(
      'Dither',
      all.map(({ dither }) => DITHERS[dither] ?? dither),
    ),
    ...together(
      'If a peak exceeds the limit',
      all.map(({ over_peak }) => OVER_PEAK[over_peak] ?? over_peak),
    ),
  ]
}

const SEVERITY_VERBS: Record<Severity, string> = { error: 'returns', warning: 'warns', off: 'not checked' }

const CHECK_WORDS = new Map([
  ...LIMITS.flatMap(({ check, word }) => (check ? [[check, word.toLowerCase()] as const] : [])),
  ...[...FORM_CHECKS, ...FAULT_CHECKS].map(({ name, word }) => [name, word.toLowerCase()] as const),
  ['loudness', 'loudness'] as const,
  ['dc-offset', 'DC offset'] as const,
])

const range = (value: unknown) => {
  const { min, max } = tableIn(value)
  return { min: typeof min === 'number' ? min : null, max: typeof max === 'number' ? max : null }
}

function acceptDifferences(own: Tables, base: Tables): string[] {
  const said: string[] = []
  for (const [key, value] of Object.entries(own)) {
    if (value === 'any') said.push(`any ${key.replace(/_(hz|s)$/, '').replaceAll('_', ' ')}`)
    else if (key === 'channels') said.push(numbers(value).map(channels).join(' or '))
    else if (key === 'sample_rates_hz') said.push(ratesOf(numbers(value)))
    else if (key === 'bit_depths') said.push(depthsOf(numbers(value)))
    else if (key === 'containers')
      said.push(
        listed(
          words(value).map((one) => CONTAINERS[one] ?? one),
          'or',
        ),
      )
    else if (key === 'encodings')
      said.push(
        listed(
          words(value).map((one) => ENCODINGS[one] ?? one),
          'or',
        ),
      )
    else if (key === 'duration_s') said.push(lengthOf(range({ ...tableIn(base.duration_s), ...tableIn(value) })))
  }
  return said
}

function limitDifferences({ head_silence_ms: head, tail_silence_ms: tail, ...own }: Tables): string[] {
  const edges =
    typeof head === 'number' && typeof tail === 'number'
      ? [`leading / trailing silence ${exact(head)} / ${exact(tail)} ms`]
      : limitWords({
          ...(head === undefined ? {} : { head_silence_ms: head }),
          ...(tail === undefined ? {} : { tail_silence_ms: tail }),
        })
  return [...limitWords(own), ...edges]
}

function limitWords(own: Tables): string[] {
  return Object.entries(own).map(([key, value]) => {
    const limit = LIMITS.find((one) => one.key === key)
    const word =
      (limit?.key === 'dc_offset_percent' ? limit.word : limit?.word.toLowerCase()) ??
      key.replace(/_(lufs|dbfs|db)$/, '').replaceAll('_', ' ')
    if (value === 'any') return `${word} not limited`
    if (key === 'loudness_lufs') return `loudness ${loudnessOf(range(value))}`
    const unit = limit?.unit ?? (key.endsWith('dbfs') ? 'dBFS' : 'dB')
    return `${word} ${typeof value === 'number' ? exact(value, unit.startsWith('dB') ? 1 : 0) : String(value)} ${unit}`
  })
}

/** What a category asks otherwise than the spec at large, in words; nothing where it only has a name. */
export function differences(tables: Tables, category: string): string[] {
  const own = tableIn(at(tables, ['categories', category]))
  const naming = tableIn(own.naming)
  const adds = tableIn(own.engine).adds
  return [
    ...acceptDifferences(tableIn(own.accept), tableIn(tables.accept)),
    ...Object.entries(tableIn(own.checks)).map(
      ([name, severity]) =>
        `${CHECK_WORDS.get(name) ?? name} ${SEVERITY_VERBS[severity as Severity] ?? String(severity)}`,
    ),
    ...limitDifferences(tableIn(own.limits)),
    ...('pattern' in naming ? [naming.pattern === 'any' ? 'any name' : `named ${String(naming.pattern)}`] : []),
    ...(Array.isArray(adds) ? [adds.length === 0 ? 'no engine effects' : `engine adds ${listed(words(adds))}`] : []),
    ...Object.entries(tableIn(own.targets)).map(([name, value]) => {
      const { sample_rate_hz: hz, bit_depth: bits, channels: count } = tableIn(value)
      const facts = [
        typeof hz === 'number' ? rate(hz) : '',
        typeof bits === 'number' ? `${bits} bit` : '',
        typeof count === 'number' ? channels(count) : count === 'master' ? 'same as master' : '',
      ]
      return `${name} ${facts.filter(Boolean).join(' ') || 'different settings'}`
    }),
  ]
}

export const SOUND_KINDS: Record<string, string> = {
  event: 'event',
  'natural-decay': 'natural decay',
  ambience: 'ambience',
  voice: 'voice',
  music: 'music',
}

/** What the sounds of a category are. */
export function kindOf(tables: Tables, category: string): string {
  const kind = at(tables, ['categories', category, 'kind'])
  return typeof kind === 'string' ? (SOUND_KINDS[kind] ?? kind) : ''
}
