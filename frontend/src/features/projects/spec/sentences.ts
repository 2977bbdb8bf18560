/** A delivery spec as sentences: each is derived from the fields that the checks read, and from nothing else. */
import { bytes, channels, rate } from '@/ui/format'

import type { Check, Spec } from '../api'
import { listed } from '../words'
import { type HeldLimit, type Severity, severityOf, statedLimits, tuningLimits } from './checks'
import { differences, exact, FOLLOWS, kindOf, lengthOf, type TargetFacts, targetInWords } from './say'
import { type Tables, tableIn } from './tables'

export interface Sentence {
  key: string
  label: string
  /** `**` stands around what is decided. */
  text: string
  note?: string
}

export const MASTER_CHECKS = ['container', 'encoding', 'sample-rate', 'bit-depth', 'channels', 'duration']
export const LEVEL_CHECKS = ['sample-peak', 'true-peak', 'loudness', 'dc-offset', 'silence', 'low-level', 'clipping']
export const EDGE_CHECKS = ['head-silence', 'tail-silence', 'internal-silence', 'cut-start', 'cut-tail']
export const DRY_CHECKS = ['baked-reverb', 'reverb-set']
const GROUPED = [...MASTER_CHECKS, ...LEVEL_CHECKS, ...EDGE_CHECKS, ...DRY_CHECKS, 'naming']
/** Checks that hold files to a limit of their own where the spec states none. */
const WITH_OWN_LIMIT = ['low-level', 'variation-set']

export const faultChecks = (checks: readonly Check[]): string[] =>
  checks.map(({ name }) => name).filter((name) => !GROUPED.includes(name))

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)
const lower = (label: string) => (/^[A-Z]{2}/.test(label) ? label : label.charAt(0).toLowerCase() + label.slice(1))
const strings = (value: unknown): string[] =>
  Array.isArray(value) ? value.filter((item): item is string => typeof item === 'string') : []
const numbers = (value: unknown): number[] =>
  Array.isArray(value) ? value.filter((item): item is number => typeof item === 'number') : []

const severity = (tables: Tables, check: Check): Severity =>
  severityOf(tableIn(tables.checks), check.name, check.severity)

/** What breaks a limit, in words. */
const BREAKS: Record<string, (figure: string) => string> = {
  sample_peak_dbfs: (figure) => `a sample peak above **${figure}**`,
  true_peak_dbtp: (figure) => `a true peak above **${figure}**`,
  dc_offset_percent: (figure) => `a DC offset over **${figure}**`,
  silence_below_dbfs: (figure) => `a file or channel that stays below **${figure}**`,
  low_level_dbfs: (figure) => `a sound whose peak stays below **${figure}**`,
  head_silence_ms: (figure) => `more than **${figure} of silence in front**`,
  tail_silence_ms: (figure) => `more than **${figure} of silence at the end**`,
  noise_floor_dbfs: (figure) => `background noise above **${figure}**`,
  mono_loss_db: (figure) => `losing more than **${figure}** in mono`,
  variation_level_lu: (figure) => `a variation more than **${figure}** from its set`,
}

function breach({ key, label, unit, is_range: isRange }: HeldLimit, value: unknown): string | null {
  const figure = (limit: number) => `${exact(limit, unit.endsWith('s') || unit === '%' ? 0 : 1)} ${unit}`
  if (isRange) {
    const { min, max } = tableIn(value)
    const sides = [
      typeof min === 'number' ? `below **${figure(min)}**` : '',
      typeof max === 'number' ? `above **${figure(max)}**` : '',
    ].filter(Boolean)
    return sides.length === 0 ? null : `${/^[aeiou]/i.test(label) ? 'an' : 'a'} ${lower(label)} ${sides.join(' or ')}`
  }
  if (typeof value !== 'number') return null
  return BREAKS[key]?.(figure(value)) ?? `a ${lower(label)} beyond **${figure(value)}**`
}

/** What is held against a file by some checks: "More than 5 ms of silence in front is sent back. Clicks give a warning." */
function rules(tables: Tables, checks: readonly Check[], names: readonly string[], none: string): string {
  const limits = tableIn(tables.limits)
  const phrases: Record<Severity, string[]> = { error: [], warning: [], off: [] }
  for (const check of checks.filter(({ name }) => names.includes(name))) {
    const held = statedLimits([check])
    const broken = held.flatMap((limit) => breach(limit, limits[limit.key]) ?? [])
    const level = severity(tables, check)
    if (level === 'off') phrases.off.push(lower(check.label))
    else if (broken.length > 0) phrases[level].push(...broken)
    else if (held.length === 0 || WITH_OWN_LIMIT.includes(check.name)) phrases[level].push(lower(check.label))
  }
  const told = (['error', 'warning'] as const).flatMap((level) =>
    phrases[level].length === 0 ? [] : [`${capital(listed(phrases[level], 'or'))} ${FOLLOWS[level]}.`],
  )
  if (told.length === 0) told.push(none)
  if (phrases.off.length > 0) told.push(`Not checked: ${listed(phrases.off, 'and')}.`)
  return told.join(' ')
}

const NAMES: Record<string, string> = { wav: 'WAV', rf64: 'RF64', flac: 'FLAC', pcm: 'PCM', float: 'float' }

function masters(tables: Tables, checks: readonly Check[]): Sentence {
  const accept = tableIn(tables.accept)
  const range = tableIn(accept.duration_s)
  const side = (key: string) => (typeof range[key] === 'number' ? range[key] : null)
  const [min, max] = [side('min'), side('max')]
  const words: [check: string, told: string, any: string][] = [
    [
      'container',
      listed(
        strings(accept.containers).map((container) => NAMES[container] ?? container),
        'or',
      ),
      'any container',
    ],
    [
      'encoding',
      listed(
        strings(accept.encodings).map((encoding) => NAMES[encoding] ?? encoding),
        'or',
      ),
      '',
    ],
    [
      'bit-depth',
      numbers(accept.bit_depths).length > 0 ? `${listed(numbers(accept.bit_depths).map(String), 'or')} bit` : '',
      'any bit depth',
    ],
    ['sample-rate', listed(numbers(accept.sample_rates_hz).map(rate), 'or'), 'any sample rate'],
    ['channels', listed(numbers(accept.channels).map(channels), 'or'), 'any number of channels'],
    ['duration', min === null && max === null ? '' : lengthOf({ min, max }), 'any length'],
  ]
  const limited = words.filter(([, told]) => told !== '').map(([check]) => check)
  const levels = checks
    .filter(({ name }) => limited.includes(name))
    .map((check) => ({ check, level: severity(tables, check) }))
  const labelsOf = (level: Severity) =>
    levels
      .filter((entry) => entry.level === level)
      .map(({ check }) => (check.name === 'channels' ? 'number of channels' : lower(check.label)))
  const follows = (['error', 'warning', 'off'] as const)
    .filter((level) => labelsOf(level).length > 0)
    .map((level) =>
      level === 'error' && labelsOf('error').length === levels.length
        ? 'Anything else is sent back.'
        : `Another ${listed(labelsOf(level), 'or')} ${FOLLOWS[level]}.`,
    )
  return {
    key: 'masters',
    label: 'Masters',
    text: [
      `Masters are ${words.flatMap(([, told, any]) => (told !== '' ? [`**${told}**`] : any !== '' ? [any] : [])).join(', ')}.`,
      ...follows,
    ].join(' '),
    note: 'A length that the sound list gives holds too.',
  }
}

function gameFiles({ resolved: { targets } }: Pick<Spec, 'resolved'>): Sentence {
  const all = Object.values(targets)
  const lowers = all.some(({ over_peak }) => over_peak === 'attenuate')
  return {
    key: 'targets',
    label: 'Game files',
    text:
      all.length === 0
        ? 'No game file is made from a master.'
        : `From each master we make **${all.length === 1 ? '1 game file' : `${all.length} game files`}**: ${all.map((target) => `${target.name} at ${targetInWords(target)}`).join('; ')}.`,
    note:
      all.length === 0
        ? undefined
        : lowers
          ? 'A game file that would peak too high is lowered.'
          : 'A game file that would peak too high is refused.',
  }
}

/** Names as teams write them, each with the pattern that holds files to it. */
export const NAME_STYLES = [
  { example: 'weapon_shield_hit_01', pattern: '[a-z0-9]+(_[a-z0-9]+)*' },
  { example: 'Weapon_ShieldHit_01', pattern: '[A-Z0-9][A-Za-z0-9]*(_[A-Z0-9][A-Za-z0-9]*)*' },
  { example: 'shield-hit-01', pattern: '[a-z0-9]+(-[a-z0-9]+)*' },
]

function names(tables: Tables, checks: readonly Check[]): Sentence {
  const { pattern, extension, tokens, separator, grammar } = tableIn(tables.naming)
  const ending = typeof extension === 'string' ? extension : ''
  const style = NAME_STYLES.find((candidate) => candidate.pattern === pattern)
  const parts = Array.isArray(tokens) ? tokens.map((token) => String(tableIn(token).name)) : []
  const text =
    grammar === 'ucs'
      ? 'Files are named by the **Universal Category System**.'
      : parts.length > 0
        ? `Files are named by parts: **${parts.join(typeof separator === 'string' ? separator : '_')}${ending}**.`
        : style
          ? `Files are named like **${style.example}${ending}**.`
          : typeof pattern === 'string' && pattern !== 'any'
            ? `File names follow the pattern **${pattern}**${ending && ` and end in **${ending}**`}.`
            : ending
              ? `Files have **any name that ends in ${ending}**.`
              : 'Files have **any name**; they are matched by the sound list.'
  const check = checks.find(({ name }) => name === 'naming')
  const isAny = text.startsWith('Files have **any name**')
  return {
    key: 'names',
    label: 'Names',
    text: !check || isAny ? text : `${text} Another name ${FOLLOWS[severity(tables, check)]}.`,
  }
}

function dryness(tables: Tables, checks: readonly Check[]): Sentence {
  const adds = strings(tableIn(tables.engine).adds)
  const check = checks.find(({ name }) => name === 'baked-reverb')
  const isAsked = adds.includes('reverb') || 'baked-reverb' in tableIn(tables.checks)
  const others = adds.filter((effect) => effect !== 'reverb')
  const level = check ? severity(tables, check) : 'off'
  return {
    key: 'dryness',
    label: 'Dryness',
    text: !isAsked
      ? 'The game adds **no reverb**, so only sounds that the list calls dry are checked for it.'
      : `Sounds come **dry**${adds.includes('reverb') ? ', because the game adds the reverb' : ''}. Reverb in the file ${FOLLOWS[level]}.`,
    note: [
      others.length > 0 ? `The game also adds ${listed(others, 'and')}.` : '',
      rules(tables, checks, ['reverb-set'], ''),
    ]
      .filter(Boolean)
      .join(' '),
  }
}

const tuned = (tables: Tables, checks: readonly Check[], key: string): string => {
  const limit = tuningLimits(checks).find((candidate) => candidate.key === key)
  const value = tableIn(tables.limits)[key] ?? limit?.usual
  return limit && typeof value === 'number' ? `${exact(value)} ${limit.unit}` : ''
}

/** Every sound of the spec, as sentences in the order of the page. */
export function sentencesOf(tables: Tables, resolved: Pick<Spec, 'resolved'>, checks: readonly Check[]): Sentence[] {
  const [tolerance, edge] = [tuned(tables, checks, 'tolerance_db'), tuned(tables, checks, 'edge_silence_below_dbfs')]
  return [
    masters(tables, checks),
    gameFiles(resolved),
    names(tables, checks),
    {
      key: 'levels',
      label: 'Levels',
      text: rules(tables, checks, LEVEL_CHECKS, 'No level is limited.'),
      note: [
        tolerance && `${capital(tolerance)} more passes, for rounding.`,
        'low_level_dbfs' in tableIn(tables.limits) ? '' : 'A low level is judged by the check’s own limit.',
      ]
        .filter(Boolean)
        .join(' '),
    },
    dryness(tables, checks),
    {
      key: 'edges',
      label: 'Start and end',
      text: rules(tables, checks, EDGE_CHECKS, 'Start and end are not limited.'),
      note: edge && `Silence is what stays below ${edge}. Loops are left alone.`,
    },
    { key: 'faults', label: 'Faults', text: rules(tables, checks, faultChecks(checks), 'No fault is looked for.') },
  ]
}

/** What one category asks otherwise. */
export const categorySentence = (tables: Tables, category: string, checks: readonly Check[]): Sentence => {
  const kind = kindOf(tables, category)
  const others = differences(tables, category, checks)
  const told = [kind && `sounds are ${kind}`, ...others].filter(Boolean).join('; ')
  return { key: `category ${category}`, label: category, text: told === '' ? 'As every sound.' : `${capital(told)}.` }
}

/** Return what one change of the spec asks for, as a sentence; `tables` hold the change already. */
export function changeSentence(place: string, after: unknown, tables: Tables, checks: readonly Check[]): Sentence {
  const [group, name = '', setting] = place.split('.')
  if (group === 'categories') return categorySentence(tables, name, checks)
  if (group === 'targets') return { key: place, label: 'Game files', text: targetSentence(name, setting, after) }
  const words = place.split('.').at(-1)?.replaceAll('_', ' ') ?? place
  const value = Array.isArray(after) ? after.map(String).join(', ') : String(after)
  return { key: place, label: 'Names', text: `The ${words} ${after === null ? 'is left out' : `becomes ${value}`}.` }
}

function targetSentence(name: string, setting: string | undefined, after: unknown): string {
  if (setting === 'budget_bytes') {
    return typeof after === 'number'
      ? `The game files of ${name} may have up to ${bytes(after)} together.`
      : `The memory of ${name} is not limited.`
  }
  if (after === null) return `Game files for ${name} are no longer made.`
  const facts = { bit_depth: 16, encoding: 'pcm', channels: 'source', ...tableIn(after) } as unknown as TargetFacts
  return `Game files for ${name} are made, at ${targetInWords(facts)}.`
}

const leaves = (value: unknown, place: string[] = []): { place: string; value: unknown }[] =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
    ? Object.entries(value).flatMap(([key, inner]) => leaves(inner, [...place, key]))
    : [{ place: place.join('.'), value }]

/** The settings that no sentence speaks of, so that each is named all the same. */
export function expertSettings(tables: Tables, checks: readonly Check[]): Sentence[] {
  const limits = checks.flatMap((check) => check.limits.map(({ key }) => key))
  const isTold = (place: string) =>
    /^(format|name|extend|files\..*|targets\..*|categories\..*|engine\.adds)$/.test(place) ||
    /^accept\.(containers|encodings|sample_rates_hz|bit_depths|channels|duration_s(\..*)?)$/.test(place) ||
    /^naming\.(pattern|extension|tokens|separator|grammar)$/.test(place) ||
    limits.some((key) => place === `limits.${key}` || place.startsWith(`limits.${key}.`)) ||
    checks.some(({ name }) => place === `checks.${name}`)
  return leaves(tables)
    .filter(({ place }) => !isTold(place))
    .map(({ place, value }) => ({
      key: `expert ${place}`,
      label: 'Expert setting',
      text: `**${place}** is ${Array.isArray(value) ? value.map(String).join(', ') : String(value)}.`,
      note: 'It has no sentence: see All settings.',
    }))
}
