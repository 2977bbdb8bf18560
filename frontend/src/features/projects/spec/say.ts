import { channels, figure, plural, sampleFormat, rate } from '@/ui/format'

import type { Check, Spec } from '../api'
import { listed } from '../words'
import { type Severity, severityOf, statedLimits, tuningLimits } from './checks'
import { at, type Tables, tableIn } from './tables'

/** A number as exactly as it was said, with one decimal at least where the unit is a level. */
export function exact(value: number, least = 0): string {
  const decimals = (String(value).split('.')[1] ?? '').length
  return figure(value, Math.min(6, Math.max(least, decimals)))
}

const numbers = (value: unknown): number[] =>
  Array.isArray(value) ? value.filter((item): item is number => typeof item === 'number') : []
const words = (value: unknown): string[] =>
  Array.isArray(value) ? value.filter((item): item is string => typeof item === 'string') : []

/** "48 or 96 kHz": one unit for all. */
const ratesOf = (hz: readonly number[]): string =>
  `${listed(
    hz.map((rateHz) => rate(rateHz).replace(' kHz', '')),
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

/** A level has one decimal at least, a time as many as were said. */
const inUnit = (value: number, unit: string): string => exact(value, unit.endsWith('s') ? 0 : 1)

const rangeOf = ({ min = null, max = null }: { min?: number | null; max?: number | null }, unit: string): string => {
  if (min !== null && max !== null) return `${inUnit(min, unit)} to ${inUnit(max, unit)} ${unit}`
  return max === null ? `${inUnit(min ?? 0, unit)} ${unit} or more` : `up to ${inUnit(max, unit)} ${unit}`
}

/** A label within a sentence: "true peak", and "DC offset" all the same. */
const lower = (label: string): string => (/^[A-Z]{2}/.test(label) ? label : label.toLowerCase())

export interface Line {
  word: string
  value: string
  severity?: Severity
}

const CONTAINERS: Record<string, string> = { wav: 'WAV', rf64: 'RF64', flac: 'FLAC' }
const ENCODINGS: Record<string, string> = { pcm: 'PCM', float: 'float' }

/** What a delivered file may be. */
export function acceptLines({ resolved: { accept } }: Spec): Line[] {
  const containers = accept.containers?.map((container) => CONTAINERS[container] ?? container) ?? ['any']
  const encodings = accept.encodings?.map((encoding) => ENCODINGS[encoding] ?? encoding) ?? []
  return [
    { word: 'Container', value: [listed(containers, 'or'), listed(encodings, 'or')].filter(Boolean).join(', ') },
    { word: 'Sample rate', value: accept.sample_rates_hz ? ratesOf(accept.sample_rates_hz) : 'any' },
    { word: 'Bit depth', value: accept.bit_depths ? depthsOf(accept.bit_depths) : 'any' },
    { word: 'Channels', value: accept.channels ? accept.channels.map(channels).join(', ') : 'any' },
    { word: 'Length', value: lengthOf(accept.duration_s) },
  ]
}

/** The levels and edges a file keeps to, with what happens when it does not. */
export function limitLines(
  { resolved: { limits, checks: severities, engine } }: Spec,
  checks: readonly Check[],
): Line[] {
  const all: Tables = { ...limits, ...limits.others }
  const lines = statedLimits(checks).flatMap(({ key, label, unit, is_range: isRange, check }) => {
    const { min, max } = range(all[key])
    const limit = all[key]
    const value =
      isRange && (min !== null || max !== null)
        ? rangeOf({ min, max }, unit)
        : typeof limit === 'number'
          ? `${inUnit(limit, unit)} ${unit}`
          : null
    const severity = severityOf(severities, check.name, check.severity)
    return value === null || severity === 'off' ? [] : [{ word: label, value, severity }]
  })
  const clipping = severityOf(severities, 'clipping', 'warning')
  if (clipping !== 'off') lines.push({ word: 'Clipping', value: 'none', severity: clipping })
  return [...lines, ...(engine.adds.length > 0 ? [{ word: 'Applied in engine', value: engine.adds.join(', ') }] : [])]
}

const DITHERS: Record<string, string> = { tpdf: 'TPDF', shaped: 'shaped', none: 'none' }
const OVER_PEAK: Record<string, string> = { attenuate: 'attenuate', refuse: 'refuse' }

export interface TargetFacts {
  sample_rate_hz: number
  bit_depth: number
  encoding: string
  quality?: number | null
  channels: string | number
}

/** "48 kHz, 16 bit, as master". */
export function targetInWords({ sample_rate_hz, bit_depth, encoding, quality, channels: count }: TargetFacts): string {
  const channelText = typeof count === 'number' ? channels(count) : 'same as master'
  return [rate(sample_rate_hz), sampleFormat(bit_depth, encoding, quality), channelText].join(', ')
}

/** What is made from each master, and what holds for all of it. */
export function targetLines({ resolved: { targets } }: Spec): Line[] {
  const all = Object.values(targets)
  const lines = all.map((target) => ({ word: target.name, value: targetInWords(target) }))
  const together = (word: string, values: string[]): Line[] =>
    values.length === 0 ? [] : [{ word, value: [...new Set(values)].join(', ') }]
  return [
    ...lines,
    ...together(
      'Dither',
      all.filter(({ quality }) => quality === null).map(({ dither }) => DITHERS[dither] ?? dither),
    ),
    ...together(
      'If a peak exceeds the limit',
      all.map(({ over_peak }) => OVER_PEAK[over_peak] ?? over_peak),
    ),
  ]
}

/** What follows of a finding. */
export const FOLLOWS: Record<Severity, string> = {
  error: 'is sent back',
  warning: 'gives a warning',
  off: 'is not checked',
}

const range = (value: unknown) => {
  const { min, max } = tableIn(value)
  return { min: typeof min === 'number' ? min : null, max: typeof max === 'number' ? max : null }
}

function acceptDifferences(own: Tables, base: Tables): string[] {
  const parts: string[] = []
  for (const [key, value] of Object.entries(own)) {
    if (value === 'any') parts.push(`any ${key.replace(/_(hz|s)$/, '').replaceAll('_', ' ')}`)
    else if (key === 'channels') parts.push(numbers(value).map(channels).join(' or '))
    else if (key === 'sample_rates_hz') parts.push(ratesOf(numbers(value)))
    else if (key === 'bit_depths') parts.push(depthsOf(numbers(value)))
    else if (key === 'containers')
      parts.push(
        listed(
          words(value).map((container) => CONTAINERS[container] ?? container),
          'or',
        ),
      )
    else if (key === 'encodings')
      parts.push(
        listed(
          words(value).map((encoding) => ENCODINGS[encoding] ?? encoding),
          'or',
        ),
      )
    else if (key === 'duration_s') parts.push(lengthOf(range({ ...tableIn(base.duration_s), ...tableIn(value) })))
  }
  return parts
}

function limitDifferences(own: Tables, checks: readonly Check[]): string[] {
  const known = [...statedLimits(checks), ...tuningLimits(checks)]
  return Object.entries(own).map(([key, value]) => {
    const { label = key, unit = '', is_range: isRange = false } = known.find((limit) => limit.key === key) ?? {}
    if (value === 'any') return `${lower(label)} not limited`
    const figures = isRange
      ? rangeOf(range(value), unit)
      : `${typeof value === 'number' ? inUnit(value, unit) : String(value)} ${unit}`
    return `${lower(label)} ${figures}`
  })
}

/** What a category asks otherwise than the spec at large, in words; nothing where it only has a name. */
export function differences(tables: Tables, category: string, checks: readonly Check[]): string[] {
  const own = tableIn(at(tables, ['categories', category]))
  const naming = tableIn(own.naming)
  const adds = tableIn(own.engine).adds
  return [
    ...acceptDifferences(tableIn(own.accept), tableIn(tables.accept)),
    ...Object.entries(tableIn(own.checks)).map(
      ([name, severity]) =>
        `${lower(checks.find((check) => check.name === name)?.label ?? name)} ${FOLLOWS[severity as Severity] ?? String(severity)}`,
    ),
    ...limitDifferences(tableIn(own.limits), checks),
    ...('pattern' in naming ? [naming.pattern === 'any' ? 'any name' : `named ${String(naming.pattern)}`] : []),
    ...(Array.isArray(adds) ? [adds.length === 0 ? 'no engine effects' : `engine adds ${listed(words(adds))}`] : []),
    ...Object.entries(tableIn(own.targets)).map(([name, value]) => {
      const { sample_rate_hz: hz, bit_depth: bits, encoding, quality, channels: count } = tableIn(value)
      const facts = [
        typeof hz === 'number' ? rate(hz) : '',
        sampleFormat(
          typeof bits === 'number' ? bits : undefined,
          encoding,
          typeof quality === 'number' ? quality : undefined,
        ),
        encoding === undefined && typeof quality === 'number' ? `quality ${quality}` : '',
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

/** Whether the names of the list fit a pattern: "1 name of 4 in the list doesn’t match: laser". */
export function namesInWords(odd: readonly string[], count: number): string {
  if (odd.length === 0) {
    return count === 1 ? 'The one name in the list matches.' : `All ${plural(count, 'name')} in the list match.`
  }
  const first = `${odd.slice(0, 3).join(', ')}${odd.length > 3 ? ' …' : ''}`
  return `${odd.length} of ${plural(count, 'name')} in the list ${odd.length === 1 ? 'doesn’t' : 'don’t'} match: ${first}`
}
