import { channels, figure, length, level, type LevelUnit, milliseconds, place, rate, score } from '@/ui/format'

/** One figure of the report, in words. */
export interface Line {
  name: string
  what: string
  said: string
  /** The check that a figure is judged by, so that its finding marks the line. */
  check?: string
}

export interface Group {
  title: string
  lines: Line[]
}

type Values = Readonly<Record<string, unknown>>
type Say = (value: unknown, all: Values) => string | null

const isNumber = (value: unknown): value is number => typeof value === 'number'
const NOT_MEASURED = 'not measured'

const number =
  (say: (value: number) => string): Say =>
  (value) =>
    isNumber(value) ? say(value) : null
/** A level, which the report has as null for silence. */
const inUnit =
  (unit: LevelUnit): Say =>
  (value) =>
    isNumber(value) || value === null ? level(value, unit) : null
const decibels = number((db) => `${figure(db, 1)} dB`)
const percent = number((value) => `${figure(value, 2)} %`)
const seconds = number(place)
const ms = number(milliseconds)
const count: Say = number((value) => (value === 0 ? 'none' : figure(value)))
const word: Say = (value) => (typeof value === 'string' ? value : null)
const list: Say = (value) =>
  Array.isArray(value) ? value.map((item) => String(item).trim()).join(', ') || 'none' : null
const yesNo: Say = (value) => (typeof value === 'boolean' ? (value ? 'yes' : 'no') : null)
/** What only one of several channels that sounds leaves unmeasured. */
const ofTwo =
  (say: Say): Say =>
  (value, all) =>
    value === null ? 'only one channel has sound' : say(value, all)
const frequency = number((hz) => (hz >= 1000 ? `${figure(hz / 1000, 1)} kHz` : `${figure(hz)} Hz`))
const integrated: Say = (value, all) =>
  value === null && isNumber(all.short_loudness_lufs) ? 'not defined below 0.4 s' : inUnit('LUFS')(value, all)

interface Known {
  what: string
  say: Say
  check?: string
}

/** The figures that have words of their own, in the order in which they are read. */
const KNOWN: readonly { title: string; figures: Readonly<Record<string, Known>> }[] = [
  {
    title: 'File',
    figures: {
      container: {
        what: 'Container',
        say: (value) => (typeof value === 'string' ? value.toUpperCase() : null),
        check: 'container',
      },
      encoding: {
        what: 'Encoding',
        say: (value) => (value === 'pcm' ? 'integer (PCM)' : word(value, {})),
        check: 'encoding',
      },
      sample_rate_hz: { what: 'Sample rate', say: number(rate), check: 'sample-rate' },
      bit_depth: { what: 'Bit depth', say: number((bits) => `${bits} bit`), check: 'bit-depth' },
      effective_bits: { what: 'Bits in use', say: number((bits) => `${bits} bit`), check: 'padded-bits' },
      sample_step: {
        what: 'Quantisation levels used',
        say: number((step) => (step === 1 ? 'all' : `one in ${figure(step)}`)),
        check: 'padded-bits',
      },
      channels: { what: 'Channels', say: number(channels), check: 'channels' },
      layout: { what: 'Layout', say: word, check: 'channels' },
      duration_s: { what: 'Length', say: number(length), check: 'duration' },
      frames: { what: 'Frames', say: number((frames) => figure(frames)) },
      chunks: { what: 'Chunks', say: list, check: 'structure' },
    },
  },
  {
    title: 'Level',
    figures: {
      sample_peak_dbfs: { what: 'Sample peak', say: inUnit('dBFS'), check: 'sample-peak' },
      sample_peak_s: { what: 'Sample peak at', say: seconds },
      true_peak_dbtp: { what: 'True peak', say: inUnit('dBTP'), check: 'true-peak' },
      true_peak_s: { what: 'True peak at', say: seconds },
      rms_dbfs: { what: 'RMS', say: inUnit('dBFS') },
      crest_db: { what: 'Crest factor', say: decibels },
      dc_offset_percent: { what: 'DC offset', say: percent, check: 'dc-offset' },
      is_silence: { what: 'Digital silence', say: yesNo, check: 'silence' },
      silent_channels: { what: 'Silent channels', say: list, check: 'silence' },
    },
  },
  {
    title: 'Loudness',
    figures: {
      integrated_lufs: { what: 'Integrated', say: integrated, check: 'loudness' },
      short_loudness_lufs: { what: 'Loudest 400 ms', say: inUnit('LUFS') },
      max_momentary_lufs: { what: 'Max momentary', say: inUnit('LUFS') },
      max_short_term_lufs: { what: 'Max short-term', say: inUnit('LUFS') },
      loudness_range_lu: {
        what: 'Loudness range',
        say: (value, all) => (value === null ? 'too short or too quiet' : inUnit('LU')(value, all)),
      },
    },
  },
  {
    title: 'Edges and loop',
    figures: {
      head_silence_ms: { what: 'Leading silence', say: ms, check: 'head-silence' },
      tail_silence_ms: { what: 'Trailing silence', say: ms, check: 'tail-silence' },
      seam_step_db: { what: 'Seam, step of level', say: decibels, check: 'loop-points' },
      seam_slope_db: { what: 'Seam, change of slope', say: decibels, check: 'loop-points' },
    },
  },
  {
    title: 'Faults',
    figures: {
      clipped_runs: { what: 'Clipped runs', say: count, check: 'clipping' },
      soft_tops: { what: 'Soft-clipped peaks', say: count, check: 'clipping' },
      clicks: { what: 'Clicks', say: count, check: 'click' },
      dropouts: { what: 'Dropouts', say: count, check: 'dropout' },
      repeats: { what: 'Repeated buffers', say: count, check: 'dropout' },
      hum_dbfs: {
        what: 'Hum',
        say: (value, all) => (value === null ? 'none' : inUnit('dBFS')(value, all)),
        check: 'hum',
      },
      hum_hz: { what: 'Hum at', say: number((hz) => `${figure(hz, 1)} Hz`), check: 'hum' },
      noise_floor_dbfs: {
        what: 'Noise floor',
        say: (value, all) => (value === null ? 'no quiet passage to measure' : inUnit('dBFS')(value, all)),
        check: 'noise-floor',
      },
    },
  },
  {
    title: 'Spectrum and width',
    figures: {
      bandwidth_hz: { what: 'Highest frequency', say: frequency, check: 'upsampled' },
      channel_correlation: {
        what: 'Channel correlation',
        say: ofTwo(number((value) => figure(value, 2))),
        check: 'phase',
      },
      mono_loss_db: { what: 'Mono fold-down loss', say: ofTwo(decibels), check: 'phase' },
      channel_difference_db: { what: 'Channel difference', say: ofTwo(decibels), check: 'false-stereo' },
    },
  },
]

/** Figures that a sound of one channel does not have. */
const OF_TWO = new Set(['channel_correlation', 'mono_loss_db', 'channel_difference_db'])

/** How the end of a name says its unit; the longest first. */
const UNITS: readonly [ending: string, say: Say][] = [
  ['_percent', percent],
  ['_dbfs', inUnit('dBFS')],
  ['_dbtp', inUnit('dBTP')],
  ['_lufs', inUnit('LUFS')],
  ['_bits', number((bits) => `${bits} bit`)],
  ['_lu', inUnit('LU')],
  ['_db', decibels],
  ['_hz', frequency],
  ['_ms', ms],
  ['_s', seconds],
]

const plainly: Say = (value) => {
  if (isNumber(value)) return figure(value, Number.isInteger(value) ? 0 : 2)
  return yesNo(value, {}) ?? list(value, {}) ?? word(value, {})
}

/** What a figure without words of its own is called: its name without the unit, "noise_slope_db" reads "Noise slope". */
export function inGeneral(name: string, value: unknown, all: Values = {}): Line | null {
  const [ending, say] = UNITS.find(([end]) => name.endsWith(end)) ?? ['', plainly]
  const words = name.slice(0, name.length - ending.length).replaceAll('_', ' ')
  const text = value === null ? (ending === '' ? NOT_MEASURED : say(null, all)) : say(value, all)
  if (text === null && value !== null) return null
  return { name, what: words.charAt(0).toUpperCase() + words.slice(1), said: text ?? NOT_MEASURED }
}

/** Everything that was measured, in words; a figure that has none of its own is named and given its unit by its name. */
export function groupsOf(facts: Values, measurements: Values): Group[] {
  const all = { ...facts, ...measurements }
  const named = new Set(KNOWN.flatMap(({ figures }) => Object.keys(figures)))
  const groups = KNOWN.map(({ title, figures }) => ({
    title,
    lines: Object.entries(figures).flatMap(([name, { what, say, check }]): Line[] => {
      if (!(name in all)) return []
      const value = all[name]
      // Nothing of two channels is said of one.
      if (value === null && all.channels === 1 && OF_TWO.has(name)) return []
      const text = say(value, all) ?? (value === null ? null : (inGeneral(name, value, all)?.said ?? null))
      return text === null ? [] : [{ name, what, said: text, check: value === 0 && say === count ? undefined : check }]
    }),
  }))
  const further = Object.entries(all).flatMap(([name, value]) =>
    named.has(name) || isTable(value) ? [] : (inGeneral(name, value, all) ?? []),
  )
  return [...groups, { title: 'More measurements', lines: further }].filter(({ lines }) => lines.length > 0)
}

const isTable = (value: unknown): value is Values =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

/** What the file says of itself: texts of its chunks, by the name of chunk and field. */
export function textsOf(facts: Values): Line[] {
  const metadata = facts.metadata
  if (!isTable(metadata)) return []
  const fields = isTable(metadata.fields) ? metadata.fields : metadata
  return Object.entries(fields).flatMap(([name, value]) =>
    typeof value === 'string' || isNumber(value) ? [{ name, what: name, said: String(value) }] : [],
  )
}

/** Judgements ask and answer with a score; they never accuse. */
export function judgementsOf(judgements: Values): Line[] {
  return Object.entries(judgements).flatMap(([name, value]) => {
    if (!isTable(value) || typeof value.verdict !== 'string') return []
    const sure = isNumber(value.score) ? `, score ${score(value.score)}` : ''
    return [
      {
        name,
        what: QUESTIONS[name] ?? `${name.charAt(0).toUpperCase()}${name.slice(1)}?`,
        said: value.verdict + sure,
      },
    ]
  })
}

const QUESTIONS: Record<string, string> = {
  reverb: 'Reverb?',
  reversed: 'Reversed?',
  upsampled: 'Upsampled?',
  lossy: 'Converted from a lossy file?',
}
